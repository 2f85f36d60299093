#include "reference/programs/path_joints.hpp"

#include "halfway/programs/path_laws.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfway::reference {
namespace {

using programs::LsdynaScoor;
using programs::Scoor;

Mat3<double> turn_between(const Mat3<double>& before, const Mat3<double>& after) {
  return after * before.transpose();
}

template <Scoor scoor>
TwelveLoads along(const Ask& question) {
  const Ask ask = with_road(question);
  programs::Situation<double> at = situation<double>(ask), before = at;
  typename LsdynaScoor<scoor>::template State<double> state;
  const auto step = [&](const programs::Situation<double>& to) {
    state.advance(to, so3::log<double>(turn_between(before.a.R, to.a.R)),
                  so3::log<double>(turn_between(before.b.R, to.b.R)));
    before = to;
  };
  for (std::size_t i = 0; i < ask.road.size(); ++i) {
    const RoadPose& pose = ask.road[i];
    programs::Situation<double> there = at;
    there.a = {pose.x_a, matrix_of(pose.q_a)};
    there.b = {pose.x_b, matrix_of(pose.q_b)};
    if (i > 0) {
      step(there);
    } else {
      state.reset(there);
      before = there;
    }
  }
  step(at);
  return state.loads(at);
}

constexpr int kSteps = 8;

RoadPose pose_of(const Ask& ask) { return {ask.a.x, ask.b.x, ask.a.q, ask.b.q}; }

template <Scoor scoor>
PathJoint beam(std::string_view name, std::string_view stands_for) {
  return {name, stands_for, LsdynaScoor<scoor>::facts, &along<scoor>};
}

}  // namespace

std::span<const PathJoint> path_joints() {
  static const PathJoint kJoints[] = {
      beam<Scoor::mean>("lsdyna_scoor_0", "LS-DYNA discrete beam, SCOOR = 0"),
      beam<Scoor::with_a>("lsdyna_scoor_-1", "LS-DYNA discrete beam, SCOOR = -1"),
      beam<Scoor::with_b>("lsdyna_scoor_1", "LS-DYNA discrete beam, SCOOR = 1"),
      beam<Scoor::with_a_on_line>("lsdyna_scoor_-2", "LS-DYNA discrete beam, SCOOR = -2"),
      beam<Scoor::with_b_on_line>("lsdyna_scoor_2", "LS-DYNA discrete beam, SCOOR = 2"),
      beam<Scoor::with_a_balanced>("lsdyna_scoor_-3", "LS-DYNA discrete beam, SCOOR = -3"),
      beam<Scoor::with_b_balanced>("lsdyna_scoor_3", "LS-DYNA discrete beam, SCOOR = 3")};
  return kJoints;
}

const PathJoint* find_path_joint(std::string_view name) {
  const auto all = path_joints();
  const auto it = std::ranges::find(all, name, &PathJoint::name);
  return it == all.end() ? nullptr : &*it;
}

Ask with_road(const Ask& ask) {
  if (!ask.road.empty()) return ask;
  const Mat3<double> P_a = matrix_of(times(ask.a.q, ask.a.h)), P_b = matrix_of(times(ask.b.q, ask.b.h));
  const Vec3<double> theta = so3::log<double>(Mat3<double>(P_a.transpose() * P_b));
  const Vec3<double> point_a = ask.a.x + matrix_of(ask.a.q) * ask.a.o,
                     point_b = ask.b.x + matrix_of(ask.b.q) * ask.b.o;
  const Vec3<double> rest = ask.is_bond ? Vec3<double>::Unit(2) : Vec3<double>(Vec3<double>::Zero());
  const Vec3<double> stretch = P_a.transpose() * (point_b - point_a) - rest;
  Ask out = ask, there = ask;
  for (int i = 0; i < kSteps; ++i) {
    const double share = double(i) / kSteps;
    place_b(there, share * theta, rest + share * stretch);
    out.road.push_back(pose_of(there));
  }
  return out;
}

Ask cone(double tilt) {
  Ask ask;
  const auto add = [&](double angle, double round) {
    place_b(ask, angle * Vec3<double>(std::cos(round), std::sin(round), 0), Vec3<double>::Zero());
    ask.road.push_back(pose_of(ask));
  };
  for (int i = 0; i < kSteps; ++i) add(tilt * i / kSteps, 0);
  for (int i = 0; i < 4 * kSteps; ++i) add(tilt, 2 * std::numbers::pi * i / (4 * kSteps));
  for (int i = kSteps; i > 0; --i) add(tilt * i / kSteps, 0);
  place_b(ask, Vec3<double>::Zero(), Vec3<double>::Zero());
  return ask;
}

}  // namespace halfway::reference
