#include "reference/scene/scene_joint.hpp"

#include "reference/solve/spectrum.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <cmath>

namespace halfway::reference {
namespace {

/// How far a quaternion's length or R R^T may be from one: typing errors are larger, digits that a
/// person leaves out are smaller. What is accepted is normalised.
constexpr double kFrameTolerance = 1e-6;

/// Smallest eigenvalue of a law scaled to a unit diagonal; below, its inverse has no digit left.
constexpr double kSmallestEigenvalue = 1e-13;

constexpr const char* kAllowedFrame = "a unit quaternion [w, x, y, z] or the 3 rows of a rotation matrix";

Mat3<double> read_quaternion(const Field& frame) {
  const Eigen::VectorXd q = frame.vector(4, kAllowedFrame);
  if (std::abs(q.norm() - 1) > kFrameTolerance) {
    frame.refuse(fmt::format("has length {}", q.norm()), "a unit quaternion [w, x, y, z], to 1e-6");
  }
  return Eigen::Quaterniond(q(0), q(1), q(2), q(3)).normalized().toRotationMatrix();
}

Mat3<double> read_rotation(const Field& frame) {
  const Mat3<double> R = frame.square_matrix(3, kAllowedFrame);
  const double off = (R * R.transpose() - Mat3<double>::Identity()).cwiseAbs().maxCoeff();
  if (!(off <= kFrameTolerance)) {
    frame.refuse(fmt::format("is not orthogonal (off by {:.3g})", off), "a rotation matrix, to 1e-6");
  }
  if (R.determinant() < 0) frame.refuse("is a reflection (determinant -1)", "a rotation matrix");
  return Eigen::Quaterniond(R).normalized().toRotationMatrix();
}

Mat3<double> read_frame(const Field& frame) {
  const auto entries = frame.items(kAllowedFrame);
  return !entries.empty() && entries.front().is_array() ? read_rotation(frame) : read_quaternion(frame);
}

JointEnd<double> read_end(const Field& joint, const std::string& node) {
  JointEnd<double> end;
  if (const auto o = joint.find("offset_" + node)) end.o = o->vector(3, "3 numbers, m, axes of the node");
  if (const auto H = joint.find("frame_" + node)) end.H = read_frame(*H);
  return end;
}

void check_symmetric(const Field& law, const Eigen::MatrixXd& m) {
  for (int i = 0; i < m.rows(); ++i) {
    for (int j = 0; j < i; ++j) {
      if (m(i, j) == m(j, i)) continue;
      law.refuse(fmt::format("is not symmetric: ({0}, {1}) is {2} and ({1}, {0}) is {3}", i + 1, j + 1,
                             m(i, j), m(j, i)),
                 "a symmetric matrix, equal to the last digit");
    }
  }
}

/// N/m and N m/rad do not compare: the matrix is scaled to a unit diagonal first.
void check_positive_definite(const Field& law, const Eigen::MatrixXd& m) {
  const std::string allowed = "a positive definite matrix";
  for (int i = 0; i < m.rows(); ++i) {
    if (!(m(i, i) > 0)) law.refuse(fmt::format("has {} on its diagonal", m(i, i)), allowed);
  }
  const Eigen::VectorXd scale = m.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * m * scale.asDiagonal();
  const double smallest = spectrum(scaled).smallest;
  if (!(smallest > kSmallestEigenvalue)) {
    law.refuse(
        fmt::format("is singular or indefinite: smallest eigenvalue {:.3g} at unit diagonal", smallest),
        allowed);
  }
}

LinearSpec read_linear(const Field& law, int n) {
  law.has_only({"type", "stiffness", "compliance"});
  const std::string either = "exactly one of stiffness, compliance";
  const auto stiffness = law.find("stiffness"), compliance = law.find("compliance");
  if (stiffness && compliance) compliance->refuse("stands beside stiffness", either);
  if (!stiffness && !compliance) law.at("stiffness", either);
  const Field& field = stiffness ? *stiffness : *compliance;

  const std::string allowed =
      fmt::format("{0} numbers (a diagonal) or {0} rows of {0}, translation first", n);
  const auto entries = field.items(allowed);
  const bool is_full = !entries.empty() && entries.front().is_array();
  LinearSpec spec;
  spec.is_compliance = !stiffness;
  spec.matrix =
      is_full ? field.square_matrix(n, allowed) : Eigen::MatrixXd(field.vector(n, allowed).asDiagonal());
  check_symmetric(field, spec.matrix);
  check_positive_definite(field, spec.matrix);
  return spec;
}

PolynomialSpec read_polynomial(const Field& law, int n) {
  law.has_only({"type", "k1", "k3", "k5"});
  const std::string allowed = fmt::format("{} numbers, one for each strain, translation first", n);
  PolynomialSpec spec{{}, Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n)};
  const Field k1 = law.at("k1", allowed);
  spec.k1 = k1.vector(n, allowed);
  if (!(spec.k1.minCoeff() > 0)) k1.refuse("has an entry that is not positive", "numbers > 0");
  if (const auto k3 = law.find("k3")) spec.k3 = k3->vector(n, allowed);
  if (const auto k5 = law.find("k5")) spec.k5 = k5->vector(n, allowed);
  return spec;
}

}  // namespace

JointSpec read_joint(const Field& joint) {
  joint.has_only({"kind", "offset_a", "offset_b", "frame_a", "frame_b", "law"});
  const std::string kinds = "angular, linear, linear_angular";
  JointSpec spec;
  const std::string kind = joint.at("kind", kinds).one_of({"angular", "linear", "linear_angular"});
  spec.kind = kind == "angular" ? Kind::angular : kind == "linear" ? Kind::linear : Kind::linear_angular;
  spec.a = read_end(joint, "a");
  spec.b = read_end(joint, "b");
  const Field law = joint.at("law", "a table [joint.law]");
  const std::string type = law.at("type", "linear, polynomial").one_of({"linear", "polynomial"});
  const int n = strain_count(spec.kind);
  if (type == "linear")
    spec.law = read_linear(law, n);
  else
    spec.law = read_polynomial(law, n);
  return spec;
}

}  // namespace halfway::reference
