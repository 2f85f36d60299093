#include "verify/studies/frames/rewriting.hpp"

#include <stdexcept>

namespace halfway::verify {
namespace {

using reference::Scene;
using reference::SceneLoad;

JointEnd<double> turned(const JointEnd<double>& end, const Mat3<double>& H) { return {H * end.o, H * end.H}; }

}  // namespace

Written as_it_is(const Scene& scene, const Mat3<double>&) { return {scene}; }

Written node_b_in_other_axes(const Scene& scene, const Mat3<double>& H) {
  Written out{scene};
  out.node_b = H;
  out.scene.joint.b = turned(scene.joint.b, H);
  for (SceneLoad& load : out.scene.loads) {
    load.point = H * load.point;
    load.arm = H * load.arm;
    if (follows(load.type)) load.value = H * load.value;
  }
  return out;
}

Written in_other_axes(const Scene& scene, const Mat3<double>& H) {
  Written out = node_b_in_other_axes(scene, H);
  out.axes = H;
  out.scene.joint.a = turned(scene.joint.a, H);
  for (SceneLoad& load : out.scene.loads) {
    if (!follows(load.type)) load.value = H * load.value;
  }
  return out;
}

Written law_in_other_axes(const Scene& scene, const Mat3<double>& H) {
  Written out{scene};
  out.scene.joint.a.H = scene.joint.a.H * H;
  out.scene.joint.b.H = scene.joint.b.H * H;
  auto* law = std::get_if<reference::LinearSpec>(&out.scene.joint.law);
  if (!law) throw std::invalid_argument("a law of single axes has no other axes");
  const Eigen::Index n = law->matrix.rows();
  Eigen::MatrixXd turn = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; i += 3) turn.block<3, 3>(i, i) = H;
  const Eigen::MatrixXd K = turn.transpose() * law->matrix * turn;
  law->matrix = (K + K.transpose()) / 2;
  return out;
}

Written nodes_exchanged(const Scene& scene, const Mat3<double>&) {
  Written out{scene};
  out.setting.nodes_exchanged = true;
  return out;
}

}  // namespace halfway::verify
