#include "halfway/assemble/assembler.hpp"

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace halfway::assemble {
namespace {

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

[[noreturn]] void refuse(std::size_t node, const std::string& what) {
  throw std::invalid_argument("assemble: node " + std::to_string(node) + ": " + what);
}

}  // namespace

void validate(const Assembler& assembler, const Input& input) {
  for (std::size_t node = 0; node < input.poses.size(); ++node) {
    const NodePose& pose = input.poses[node];
    for (int c = 0; c < 3; ++c) {
      if (!std::isfinite(pose.x[c])) refuse(node, "x[" + std::to_string(c) + "] is " + number(pose.x[c]));
    }
    if (const auto length = batch::detail::wrong_length(pose.q))
      refuse(node, "q is a quaternion of length " + number(*length) + ", not 1");
  }
  batch::Joints<double> joints;
  joints.count = assembler.joint_count();
  joints.law = input.law, joints.law_per_joint = input.law_per_joint;
  joints.a = input.a, joints.b = input.b;
  batch::validate_laws(assembler.model(), joints);
}

}  // namespace halfway::assemble
