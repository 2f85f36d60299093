// Small motions about an equilibrium: M z'' + K z = 0 where nothing is prescribed.
#include "reference/mechanism/invert.hpp"
#include "reference/mechanism/outputs.hpp"
#include "reference/numbers/linear_algebra.hpp"
#include "reference/record/worst.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfway::reference::mechanism {
namespace {

/// About the bodies' reference points, in their axes, as the tangent.
Matrix<double> masses(const Follower<double>& path) {
  const Model<double>& model = path.model();
  Matrix<double> out = Matrix<double>::Zero(model.unknowns(), model.unknowns());
  for (std::size_t i = 0; i < model.bodies().size(); ++i) {
    const Body<double>& body = model.bodies()[i];
    if (!body.moves) continue;
    const SceneBody& scene = model.scene().bodies[i];
    const Mat3<double>& R = path.reached().state.at[i].R;
    const Mat3<double> axes = R * body.E.transpose() * body.rest.R;  // body -> E
    const Mat3<double> s = skew<double>(R * body.arm(scene.center));
    Mat6<double> own;
    own << scene.mass * Mat3<double>::Identity(), -scene.mass * s, scene.mass * s,
        axes * scene.inertia * axes.transpose() - scene.mass * s * s;
    const int first = first_direction(*body.moves), n = body.count();
    out.block(body.first, body.first, n, n) = own.block(first, first, n, n);
  }
  return out;
}

/// A column for each direction that nothing prescribes, orthonormal.
Matrix<double> free_columns(const Matrix<double>& G) {
  if (G.rows() == 0) return Matrix<double>::Identity(G.cols(), G.cols());
  return singular_values(G).v.rightCols(G.cols() - G.rows());
}

/// Z^T A Z
Matrix<double> of_columns(const Matrix<double>& A, const Matrix<double>& Z) {
  const Matrix<double> right = A.lazyProduct(Z);
  return Z.transpose().lazyProduct(right);
}

void add_motion(const Matrix<double>& K, const Matrix<double>& M, Modes& out) {
  Matrix<double> inverse = M;
  invert(inverse);
  const auto squares = eigenvalues(inverse.lazyProduct(K));
  double largest = 0;
  for (const auto& square : squares) keep_largest(largest, std::abs(square));
  // Each is known to a rounding of the largest, and a pair that meets to the root of it.
  constexpr double kRounding = 1e-15, kAtRest = 1e-13;
  for (auto square : squares) {
    const bool is_real = std::abs(square.imag()) <= 30 * std::sqrt(kRounding * largest * std::abs(square));
    if (is_real) square = square.real() < 0 && square.real() > -kAtRest * largest ? 0 : square.real();
    const auto s = std::sqrt(-square);
    out.frequencies.push_back(std::abs(s.imag()) / (2 * std::numbers::pi));
    if (std::abs(s.real()) > out.growth) out.growth = std::abs(s.real()), out.flutters = !is_real;
  }
  std::ranges::sort(out.frequencies);
}

}  // namespace

Modes modes(const Follower<double>& path, bool with_masses) {
  const Equations<double> equations = path.equations();
  const Matrix<double> Z = free_columns(equations.held_directions());
  const Matrix<double> K = of_columns(equations.tangent(), Z);
  Modes out;
  if (Z.cols() == 0) return out;
  for (const auto& value : eigenvalues((K + K.transpose()) / 2)) out.eigenvalues.push_back(value.real());
  std::ranges::sort(out.eigenvalues);
  if (with_masses) add_motion(K, of_columns(masses(path), Z), out);
  return out;
}

}  // namespace halfway::reference::mechanism
