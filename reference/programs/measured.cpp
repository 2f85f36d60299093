#include "reference/programs/measured.hpp"

#include "reference/truth/data.hpp"

namespace halfway::reference {
namespace {

using nlohmann::json;

Vec3<double> triple(const json& list) {
  return {list.at(0).get<double>(), list.at(1).get<double>(), list.at(2).get<double>()};
}

MeasuredPose pose_of(const json& pose) {
  MeasuredPose out;
  out.id = pose.at("id").get<int>();
  out.ask.a = read_body(pose.at("a"));
  out.ask.b = read_body(pose.at("b"));
  out.ask.K_f = triple(pose.at("k_trans")).asDiagonal();
  out.ask.K_m = triple(pose.at("k_rot")).asDiagonal();
  out.loads << -triple(pose.at("f_a")), -triple(pose.at("m_a")), -triple(pose.at("f_b")),
      -triple(pose.at("m_b"));
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
