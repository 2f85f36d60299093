#include "reference/truth/fe/statics.hpp"

#include "halfway/rotations/so3.hpp"

#include <Eigen/LU>

#include <stdexcept>

namespace halfway::reference::fe {
namespace {

constexpr int kMostIterations = 60;
constexpr double kFine = 1e-12;   ///< relative update that needs no further iteration: the next is a tenth
constexpr double kCoarse = 1e-8;  ///< coarser than this is no result

}  // namespace

Vec3<double> Equilibrium::theta() const { return so3::log<double>(state.R); }

Equilibrium Statics::solve(SolidLaw law, const Load& load, const State& start) {
  Equilibrium out;
  out.state = start;
  double last = 1;
  bool stale = true;  // the factors are those of a state too far from this one
  Eigen::Matrix<double, Eigen::Dynamic, 6> K_face, Y;
  for (out.iterations = 1; out.iterations <= kMostIterations; ++out.iterations) {
    const Assembly a = solid_.assemble(law, out.state);
    const Vec3<double> m = load.follower ? Vec3<double>(out.state.R * load.m) : load.m;
    Vec6 face = solid_.face_load(out.state, a.force);
    face.head<3>() -= load.f;
    face.tail<3>() -= m;
    Mat6 face_tangent = a.face;
    if (load.follower) face_tangent.bottomRightCorner<3, 3>() += skew<double>(m);
    const Eigen::VectorXd interior = solid_.interior(a.force);

    if (stale) {
      if (!cholesky_.factorize(a.K)) {
        out.reason = "the interior's tangent is not positive definite: the load passes a limit of the solid";
        return out;
      }
      K_face = a.K_face;
      Y = cholesky_.solve(K_face);
    }
    const Eigen::VectorXd y = cholesky_.solve(interior);
    const Mat6 schur = face_tangent - K_face.transpose() * Y;
    const Vec6 dq = -schur.partialPivLu().solve(Vec6(face - K_face.transpose() * y));
    const Eigen::VectorXd du = -y - Y * dq;
    if (!dq.allFinite() || !du.allFinite()) {
      out.reason = "the iteration left the finite numbers";
      return out;
    }
    State before = out.state;
    solid_.move(out.state, du, dq);
    out.update = du.lpNorm<Eigen::Infinity>() / out.state.u.cwiseAbs().maxCoeff();
    // Only a fresh tangent tells rounding from slow convergence.
    const bool stagnates = stale && out.update < kCoarse && out.update > last / 4;
    if (out.update < kFine || stagnates) {
      out.converged = true;
      return out;
    }
    // A factorization costs twenty times an iteration without one. An old one is used while each of its steps
    // gains a digit; a step that does not is taken back, and the state that it left is factored.
    const bool taken_back = !stale && out.update > last / 10;
    if (taken_back)
      out.state = std::move(before);
    else
      last = out.update;
    stale = taken_back;
  }
  out.reason = "no convergence within " + std::to_string(kMostIterations) + " iterations";
  return out;
}

Statics::Linear Statics::linear() {
  const State state = solid_.unloaded();
  const Assembly a = solid_.assemble(SolidLaw::st_venant, state);
  if (!cholesky_.factorize(a.K))
    throw std::domain_error("the interior's stiffness is not positive definite: a part of the mesh is loose");
  const Eigen::MatrixXd Y = cholesky_.solve(a.K_face);
  Linear out;
  const Mat6 stiffness = a.face - a.K_face.transpose() * Y;
  out.compliance = ((stiffness + stiffness.transpose()) / 2).inverse();
  for (int k = 0; k < 6; ++k) {
    const Vec6 q = out.compliance.col(k);
    State moved = solid_.unloaded();
    solid_.move(moved, -Y * q, Vec6::Zero());
    // The face moves linearly here: no finite rotation.
    for (std::size_t i = 0; i < solid_.mesh().rigid.size(); ++i) {
      const Vec3<double> arm = solid_.arms().col(Eigen::Index(i));
      moved.u.col(solid_.mesh().rigid[i]) = q.head<3>() + q.tail<3>().cross(arm);
    }
    out.u[std::size_t(k)] = moved.u;
  }
  return out;
}

}  // namespace halfway::reference::fe
