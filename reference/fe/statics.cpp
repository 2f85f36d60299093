#include "reference/fe/statics.hpp"

#include "formulations/so3.hpp"

#include <Eigen/LU>

// OpenBLAS's own, absent from other BLAS libraries.
extern "C" __attribute__((weak)) void openblas_set_num_threads(int);

namespace halfway::reference::fe {
namespace {

constexpr int kMostIterations = 60;
constexpr double kFine = 1e-13;   ///< relative update that needs no further iteration
constexpr double kCoarse = 1e-8;  ///< coarser than this is no result

}  // namespace

Vec3<double> Equilibrium::theta() const { return so3::log<double>(state.R); }

Statics::Statics(const Solid& solid) : solid_(solid) {
  // Its threads spin: on a shared machine they cost thirty times what they gain on these small blocks.
  if (openblas_set_num_threads) openblas_set_num_threads(1);
  cholesky_.cholmod().nmethods = 1;
  cholesky_.cholmod().method[0].ordering = CHOLMOD_METIS;
  cholesky_.cholmod().postorder = 1;
  cholesky_.cholmod().print = 0;
}

void Statics::factorize(const Eigen::SparseMatrix<double>& K) {
  if (!analyzed_) cholesky_.analyzePattern(K);
  analyzed_ = true;
  cholesky_.factorize(K);
}

Equilibrium Statics::solve(Law law, const Load& load, const State& start) {
  Equilibrium out;
  out.state = start;
  double last = 1;
  for (out.iterations = 1; out.iterations <= kMostIterations; ++out.iterations) {
    const Assembly a = solid_.assemble(law, out.state);
    const Vec3<double> m = load.follower ? Vec3<double>(out.state.R * load.m) : load.m;
    Vec6 face = solid_.face_load(out.state, a.force);
    face.head<3>() -= load.f;
    face.tail<3>() -= m;
    Mat6 face_tangent = a.face;
    if (load.follower) face_tangent.bottomRightCorner<3, 3>() += skew<double>(m);
    const Eigen::VectorXd interior = solid_.interior(a.force);
    out.residual = interior.lpNorm<Eigen::Infinity>() / a.force.cwiseAbs().maxCoeff();

    factorize(a.K);
    if (cholesky_.info() != Eigen::Success) {
      out.reason = "the interior's tangent is not positive definite: the load passes a limit of the solid";
      return out;
    }
    Eigen::MatrixXd right(interior.size(), 7);
    right << a.K_face, interior;
    const Eigen::MatrixXd solved = cholesky_.solve(right);
    const Mat6 schur = face_tangent - a.K_face.transpose() * solved.leftCols<6>();
    const Vec6 dq = -schur.partialPivLu().solve(Vec6(face - a.K_face.transpose() * solved.col(6)));
    const Eigen::VectorXd du = -solved.col(6) - solved.leftCols<6>() * dq;
    if (!dq.allFinite() || !du.allFinite()) {
      out.reason = "the iteration left the finite numbers";
      return out;
    }
    solid_.move(out.state, du, dq);
    out.update = du.lpNorm<Eigen::Infinity>() / out.state.u.cwiseAbs().maxCoeff();
    const bool stagnates = out.update < kCoarse && out.update > last / 4;
    if (out.update < kFine || stagnates) {
      out.converged = true;
      return out;
    }
    last = out.update;
  }
  out.reason = "no convergence within " + std::to_string(kMostIterations) + " iterations";
  return out;
}

Statics::Linear Statics::linear() {
  const State state = solid_.unloaded();
  const Assembly a = solid_.assemble(Law::st_venant, state);
  factorize(a.K);
  const Eigen::MatrixXd Y = cholesky_.solve(Eigen::MatrixXd(a.K_face));
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
