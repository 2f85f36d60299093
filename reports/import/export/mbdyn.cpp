#include "reports/import/export/export.hpp"

#include <fmt/format.h>

namespace halfway::imports {
namespace {

/// What MBDyn calls the joint of that kind and formulation; nullptr: none of its.
const char* type_of(Kind kind, const std::string& formulation) {
  const bool attached = formulation == "attached_a";
  if (kind == Kind::angular)
    return attached                     ? "deformable hinge"
           : formulation == "invariant" ? "invariant deformable hinge"
                                        : nullptr;
  if (kind == Kind::linear)
    return attached                     ? "deformable displacement joint"
           : formulation == "invariant" ? "invariant deformable displacement joint"
                                        : nullptr;
  return attached                           ? "deformable joint"
         : formulation == "mbdyn_joint_inv" ? "invariant deformable joint"
                                            : nullptr;
}

std::string node_text(int label, const JointEnd<double>& end, bool has_point) {
  std::string out = fmt::format("  {}", label);
  if (has_point) out += ", position, " + words_of(end.o, ", ");
  Eigen::VectorXd H(9);
  for (int i = 0; i < 3; ++i) H.segment<3>(3 * i) = end.H.row(i).transpose();
  if (end.H != Mat3<double>::Identity()) out += ",\n    orientation, matr, " + words_of(H, ", ");
  return out + ",\n";
}

std::string law_text(const Eigen::MatrixXd& K) {
  std::string out = "  linear elastic generic, ";
  if (K.isDiagonal(0)) return out + "diag, " + words_of(K.diagonal(), ", ");
  out += "sym";
  for (Eigen::Index i = 0; i < K.rows(); ++i)
    out += ",\n    " + words_of(K.row(i).tail(K.cols() - i).transpose(), ", ");
  return out;
}

}  // namespace

Exported mbdyn_of(const ExportRequest& request) {
  const auto& scene = request.scene;
  const Kind kind = scene.joint.kind;
  const char* type = type_of(kind, request.formulation);
  if (!type) {
    throw CannotSay(
        fmt::format("{}: formulations: MBDyn has no joint of this kind that computes {}; allowed: --as "
                    "attached_a, --as {}",
                    scene.name, request.formulation.empty() ? "what is not said" : request.formulation,
                    kind == Kind::linear_angular ? "mbdyn_joint_inv" : "invariant"));
  }
  Exported out;
  const bool has_point = kind != Kind::angular;
  out.text =
      fmt::format("joint: 1, {},\n{}{}{};\n", type, node_text(1, scene.joint.a, has_point),
                  node_text(2, scene.joint.b, has_point), law_text(stiffness_of_scene(scene, "MBDyn")));
  if (!has_point && !(scene.joint.a.o.isZero(0) && scene.joint.b.o.isZero(0)))
    out.left_out.push_back("offset_a, offset_b: of no effect on an angular joint");
  out.left_out.push_back(
      "nodes: the statement names node a 1 and node b 2; it is to be included among the elements");
  return out;
}

}  // namespace halfway::imports
