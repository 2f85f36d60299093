// Directions that no joint holds: found beside the stiffness of their own block, so that no unit counts.
#include "reference/mechanism/follow.hpp"
#include "reference/numbers/linear_algebra.hpp"
#include "reference/record/worst.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::reference::mechanism {
namespace {

/// A stiffness below this share of its body's largest is none.
constexpr double kNone = 1e-13;

/// What a load may do on a free direction: rounding of frames and levers.
constexpr double kNothing = 1e-12;

/// 1 / sqrt of the largest stiffness of each body against displacements and against rotations.
Vector<double> units(const Model<double>& model, const Matrix<double>& K) {
  Vector<double> out = Vector<double>::Ones(K.rows());
  for (const Body<double>& body : model.bodies()) {
    for (int i = 0; i < body.count(); i += 3) {
      double largest = 0;
      for (int j = 0; j < 3; ++j) keep_largest(largest, std::abs(K(body.first + i + j, body.first + i + j)));
      if (largest > 0) out.segment<3>(body.first + i).setConstant(1 / std::sqrt(largest));
    }
  }
  return out;
}

}  // namespace

FreeDirections free_directions(const Model<double>& model, const Matrix<double>& K, const Matrix<double>& G) {
  const Vector<double> scale = units(model, K);
  const Eigen::Index n = K.rows(), m = G.rows();
  Matrix<double> all(n + m, n);
  all.topRows(n) = scale.asDiagonal() * K * scale.asDiagonal();
  for (Eigen::Index i = 0; i < m; ++i) {
    const Eigen::RowVectorXd row = G.row(i) * scale.asDiagonal();
    all.row(n + i) = row / (row.norm() > 0 ? row.norm() : 1);
  }
  const SingularValues svd = singular_values(all);
  Eigen::Index count = 0;
  while (count < n && svd.values[n - 1 - count] <= kNone * svd.values[0]) ++count;
  FreeDirections out;
  out.share = svd.v.rightCols(count);
  out.motion = scale.asDiagonal() * out.share;
  out.hold = scale.cwiseInverse().asDiagonal() * out.share;
  return out;
}

std::string named_direction(const Model<double>& model, const FreeDirections& free, int i) {
  double largest = 0;
  std::string out;
  for (std::size_t k = 0; k < model.bodies().size(); ++k) {
    const Body<double>& body = model.bodies()[k];
    const Vec6<double> share = model.of_body(free.share.col(i), body);
    for (const bool turns : {true, false}) {
      const Vec3<double> part = body.E * share.segment<3>(turns ? 3 : 0);
      if (!(part.norm() > largest * (1 + 1e-6))) continue;
      largest = part.norm();
      Eigen::Index most = 0;
      part.cwiseAbs().maxCoeff(&most);
      const Vec3<double> n = part / part[most];
      const auto shown = [](double x) { return std::abs(x) < 1e-9 ? 0 : x; };
      out = fmt::format("{} ({:.3g}, {:.3g}, {:.3g}) of body {}",
                        turns ? "rotation about" : "displacement along", shown(n[0]), shown(n[1]),
                        shown(n[2]), model.scene().bodies[k].name);
    }
  }
  return out;
}

bool works_on(const Vector<double>& load, const Vector<double>& motion) {
  return !(std::abs(load.dot(motion)) <= kNothing * load.cwiseAbs().dot(motion.cwiseAbs()));
}

}  // namespace halfway::reference::mechanism
