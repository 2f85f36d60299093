#include "verify/programs/adapter.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace halfway::programs {
namespace {

using nlohmann::json;

/// A request that no program could answer.
struct BadRequest : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Diagonals come out of products, with their rounding.
constexpr double kRounding = 1e-12;

template <std::size_t N>
std::array<double, N> read_numbers(const json& list, const std::string& what) {
  if (!list.is_array() || list.size() != N)
    throw BadRequest(what + " has to be " + std::to_string(N) + " numbers");
  std::array<double, N> numbers;
  for (std::size_t i = 0; i < N; ++i) {
    if (!list[i].is_number()) throw BadRequest(what + " holds what is no number: " + list[i].dump());
    numbers[i] = list[i].get<double>();
  }
  return numbers;
}

Quat read_rotation(const json& list, const std::string& what) {
  Quat q = read_numbers<4>(list, what);
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!(std::abs(length - 1) < 1e-3)) throw BadRequest(what + " is no unit quaternion");
  for (double& part : q) part /= length;
  return q;
}

Body read_body(const json& request, const std::string& node) {
  if (!request.contains(node) || !request.at(node).is_object())
    throw BadRequest("node " + node + " is missing");
  const json& from = request.at(node);
  if (!from.contains("x") || !from.contains("q")) throw BadRequest("node " + node + " needs x and q");
  Body body;
  body.x = read_numbers<3>(from.at("x"), node + ".x");
  body.q = read_rotation(from.at("q"), node + ".q");
  if (from.contains("o")) body.o = read_numbers<3>(from.at("o"), node + ".o");
  if (from.contains("h")) body.h = read_rotation(from.at("h"), node + ".h");
  const std::size_t i = node == "b";
  if (request.contains("mass")) body.mass = read_numbers<2>(request.at("mass"), "mass")[i];
  if (request.contains("inertia")) body.inertia = read_numbers<2>(request.at("inertia"), "inertia")[i];
  if (!(body.mass > 0 && body.inertia > 0)) throw BadRequest("mass and inertia have to be positive");
  return body;
}

/// K as one spring for each axis: N numbers, or N rows with nothing beside the diagonal.
template <std::size_t N>
std::array<double, N> read_springs(const json& K) {
  if (!K.is_array() || K.size() != N)
    throw BadRequest("law.K has to be " + std::to_string(N) + " rows of as many numbers");
  std::array<double, N> springs;
  if (K[0].is_number()) {
    springs = read_numbers<N>(K, "law.K");
  } else {
    std::array<std::array<double, N>, N> rows;
    for (std::size_t i = 0; i < N; ++i) rows[i] = read_numbers<N>(K[i], "a row of law.K");
    for (std::size_t i = 0; i < N; ++i) {
      springs[i] = rows[i][i];
      for (std::size_t j = 0; j < N; ++j) {
        if (i != j && std::abs(rows[i][j]) > kRounding * std::sqrt(std::abs(rows[i][i] * rows[j][j])))
          throw Skipped("law.K is not diagonal: the program has one spring for each axis");
      }
    }
  }
  for (double k : springs) {
    if (k < 0) throw BadRequest("law.K has a negative stiffness");
  }
  return springs;
}

void check_springs(Springs can, const Vec& k, const std::string& what) {
  const bool is_isotropic =
      std::abs(k[1] - k[0]) <= kRounding * k[0] && std::abs(k[2] - k[0]) <= kRounding * k[0];
  if (can == Springs::isotropic && !is_isotropic)
    throw Skipped("the program has one stiffness for all " + what);
}

void read_law(const json& request, const std::string& kind, Joint& joint) {
  if (!request.contains("law") || !request.at("law").is_object()) throw BadRequest("law is missing");
  const json& law = request.at("law");
  const std::string type = law.value("type", "linear");
  if (type != "linear") throw Skipped("law.type '" + type + "': only linear ones");
  if (!law.contains("K")) throw BadRequest("law.K is missing");
  if (kind == "linear_angular") {
    const auto k = read_springs<6>(law.at("K"));
    joint.k_trans = {k[0], k[1], k[2]};
    joint.k_rot = {k[3], k[4], k[5]};
  } else {
    (kind == "linear" ? joint.k_trans : joint.k_rot) = read_springs<3>(law.at("K"));
  }
}

Joint read_joint(const json& request, const Case& can) {
  const std::string kind = request.value("kind", "");
  if (std::find(kAllKinds.begin(), kAllKinds.end(), kind) == kAllKinds.end())
    throw BadRequest("kind is '" + kind + "'; allowed: angular, linear, linear_angular");
  if (std::find(can.kinds.begin(), can.kinds.end(), kind) == can.kinds.end())
    throw Skipped("kind " + kind + ": the program has no such joint");
  Joint joint;
  joint.a = read_body(request, "a");
  joint.b = read_body(request, "b");
  read_law(request, kind, joint);
  check_springs(can.trans, joint.k_trans, "translations");
  check_springs(can.rot, joint.k_rot, "rotations");
  return joint;
}

json hello(const Case& can) {
  const bool is_diagonal = can.trans == Springs::diagonal && can.rot == Springs::diagonal;
  return {{"name", can.name},     {"version", can.version},
          {"kinds", can.kinds},   {"law", is_diagonal ? "diagonal" : "isotropic"},
          {"digits", can.digits}, {"frames", can.frames}};
}

json as_json(const Loads& loads) {
  json list = json::array();
  for (const Vec* part : {&loads.f_a, &loads.m_a, &loads.f_b, &loads.m_b}) {
    for (double number : *part) {
      // NaN has no word in JSON: it would become a null that says nothing.
      if (!std::isfinite(number)) throw std::runtime_error("the program gave loads that are not finite");
      list.push_back(number);
    }
  }
  return list;
}

json refused(const char* code, const std::string& message) {
  return {{"error", {{"code", code}, {"message", message}}}};
}

json answer(const json& request, const Case& can) {
  try {
    if (request.contains("hello")) return hello(can);
    return {{"loads", as_json(can.loads(read_joint(request, can)))}};
  } catch (const Skipped& e) {
    return {{"skipped", e.what()}};
  } catch (const BadRequest& e) {
    return refused("bad_request", e.what());
  } catch (const json::exception& e) {
    return refused("bad_request", e.what());
  } catch (const std::exception& e) {
    return refused("program_failed", e.what());
  }
}

json answer_line(const std::string& line, const Case& can) {
  json request;
  try {
    request = json::parse(line);
  } catch (const json::exception& e) {
    json out = refused("malformed_json", e.what());
    out["id"] = nullptr;
    return out;
  }
  if (!request.is_object()) {
    json out = refused("bad_request", "a request is a JSON object");
    out["id"] = nullptr;
    return out;
  }
  json out = answer(request, can);
  out["id"] = request.value("id", json());
  return out;
}

}  // namespace

int run(int argc, char** argv, const std::vector<Case>& cases) {
  std::string names;
  for (const Case& can : cases) {
    if (argc == 2 && can.id == argv[1]) {
      // Text that is no UTF-8 came from the request, in its id: it is answered, with a mark where it was.
      for (std::string line; std::getline(std::cin, line);)
        std::cout << answer_line(line, can).dump(-1, ' ', false, json::error_handler_t::replace) << std::endl;
      return 0;
    }
    names += " " + can.id;
  }
  std::cerr << "usage: " << argv[0] << " CASE, one of:" << names << "\n";
  return 2;
}

}  // namespace halfway::programs
