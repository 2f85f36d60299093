#include "reference/programs/measured.hpp"

#include "reference/truth/data.hpp"

namespace halfway::reference {
namespace {

using nlohmann::json;

template <int n>
Eigen::Matrix<double, n, 1> numbers(const json& list) {
  Eigen::Matrix<double, n, 1> out;
  for (int i = 0; i < n; ++i) out[i] = list.at(std::size_t(i)).get<double>();
  return out;
}

AskedBody body(const json& node) {
  AskedBody out;
  out.x = numbers<3>(node.at("x"));
  out.q = numbers<4>(node.at("q"));
  out.o = numbers<3>(node.at("o"));
  out.h = numbers<4>(node.at("h"));
  return out;
}

MeasuredPose pose_of(const json& pose) {
  MeasuredPose out;
  out.id = pose.at("id").get<int>();
  out.ask.a = body(pose.at("a"));
  out.ask.b = body(pose.at("b"));
  out.ask.K_f = numbers<3>(pose.at("k_trans")).asDiagonal();
  out.ask.K_m = numbers<3>(pose.at("k_rot")).asDiagonal();
  out.loads << -numbers<3>(pose.at("f_a")), -numbers<3>(pose.at("m_a")), -numbers<3>(pose.at("f_b")),
      -numbers<3>(pose.at("m_b"));
  return out;
}

}  // namespace

MeasuredProgram read_measured(const std::string& name) {
  const std::string file = "programs/" + name + ".json";
  const json data = read_data(file);
  try {
    const json& header = data.at("header");
    MeasuredProgram out{header.at("program"), header.at("version"), header.at("how_measured"), {}};
    for (const json& pose : data.at("poses")) out.poses.push_back(pose_of(pose));
    return out;
  } catch (const json::exception& error) {
    throw DataError(file + ": " + error.what());
  }
}

}  // namespace halfway::reference
