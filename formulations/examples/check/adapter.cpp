// A joint behind `halfway check`, here one of Halfway's own library: JSON lines in, one answer a line out.
#include <halfway/joint.hpp>
#include <halfway/systems/intrinsic.hpp>

#include <nlohmann/json.hpp>

#include <array>
#include <iostream>
#include <string>

using namespace halfway;  // SI units, radians
using nlohmann::json;

Vec3<double> vector(const json& node, const char* key) {
  return Vec3<double>(node.value(key, std::array<double, 3>{0, 0, 0}).data());
}

Mat3<double> rotation(const json& node, const char* key) {
  const auto q = node.value(key, std::array<double, 4>{1, 0, 0, 0});
  return so3::matrix<double>({q[0], {q[1], q[2], q[3]}});
}

json answer(const json& r) {
  if (r.contains("hello"))
    return {{"name", "invariant"}, {"kinds", {"linear_angular"}}, {"law", "full"}, {"frames", true}};
  if (r["kind"] != "linear_angular") return {{"skipped", "linear_angular joints alone"}};
  Joint<Kind::linear_angular, double, Invariant, LinearLaw<double, 6>> joint;
  for (int i = 0; i < 36; ++i) joint.law.K(i / 6, i % 6) = r["law"]["K"][i / 6][i % 6];
  joint.a = {vector(r["a"], "o"), rotation(r["a"], "h")};
  joint.b = {vector(r["b"], "o"), rotation(r["b"], "h")};
  const Pose<double> a{vector(r["a"], "x"), rotation(r["a"], "q")},
      b{vector(r["b"], "x"), rotation(r["b"], "q")};
  const auto q = loads<false>(joint, a, b).q;  // f_a, m_a, f_b, m_b, in global axes
  return {{"loads", std::vector<double>(q.begin(), q.end())}};
}

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    const json request = json::parse(line);
    json out = answer(request);
    out["id"] = request["id"];
    std::cout << out << std::endl;  // flushed
  }
}
