#include "reference/programs/joints.hpp"

#include <algorithm>

namespace halfway::reference {

const ProgramJoint* find_program_joint(std::string_view name) {
  const auto all = program_joints();
  const auto it = std::ranges::find(all, name, &ProgramJoint::name);
  return it == all.end() ? nullptr : &*it;
}

JointSpec joint_spec(const programs::Situation<double>& s) {
  JointSpec spec;
  spec.kind = Kind::linear_angular;
  spec.a = s.end_a, spec.b = s.end_b;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(6, 6);
  K.topLeftCorner<3, 3>() = s.K_f;
  K.bottomRightCorner<3, 3>() = s.K_m;
  spec.law = LinearSpec{K, false};
  return spec;
}

Answerer answerer(const Entry& entry, double xi) {
  return [&entry, xi](const Ask& ask) -> TwelveLoads {
    const programs::Situation<double> s = situation<double>(ask);
    JointSpec spec = joint_spec(s);
    spec.xi = xi;
    if (!ask.K_fm.isZero(0)) {
      auto& K = std::get<LinearSpec>(spec.law).matrix;
      K.topRightCorner<3, 3>() = ask.K_fm;
      K.bottomLeftCorner<3, 3>() = ask.K_fm.transpose();
    }
    return node_loads<double>(entry, spec, s.a, s.b, false).q;
  };
}

}  // namespace halfway::reference
