#include "reference/truth/fe/statics.hpp"

#include "halfway/rotations/so3.hpp"

#include <Eigen/LU>

#include <stdexcept>

namespace halfway::reference::fe {
namespace {

constexpr int kMostIterations = 60;
constexpr double kFine = 1e-12;   ///< relative update that needs no further iteration: the next is a tenth
constexpr double kCoarse = 1e-8;  ///< coarser than this is no result

/// Force and moment on the face at factor 1 of a load.
Vec6 applied(const Load& load, const State& state) {
  Vec6 out;
  out << load.f, load.follower ? Vec3<double>(state.R * load.m) : load.m;
  return out;
}

/// A follower moment turns with the face: d(R m) = dw x m.
void take_off_change(const Load& load, double factor, const State& state, Mat6& face) {
  if (load.follower) face.bottomRightCorner<3, 3>() += skew<double>(factor * (state.R * load.m));
}

struct FaceStep {
  Vec6 q;             ///< (dx, dw), m and rad
  double factor = 0;  ///< change of the load's
};

/// stiffness q - unit_load factor = -rest; where theta_1 is given, its rate Gamma^-1 dw is what is missing to
/// it.
FaceStep face_step(const Mat6& stiffness, const Vec6& rest, const Vec6& unit_load, const State& state,
                   std::optional<double> theta_1) {
  if (!theta_1) return {-stiffness.partialPivLu().solve(rest)};
  const Vec3<double> theta = so3::log<double>(state.R);
  Eigen::Matrix<double, 7, 7> bordered = Eigen::Matrix<double, 7, 7>::Zero();
  bordered.topLeftCorner<6, 6>() = stiffness;
  bordered.topRightCorner<6, 1>() = -unit_load;
  bordered.block<1, 3>(6, 3) = so3::gamma_inverse<double>(theta).row(0);
  Eigen::Matrix<double, 7, 1> right;
  right << -rest, *theta_1 - theta[0];
  const Eigen::Matrix<double, 7, 1> x = bordered.partialPivLu().solve(right);
  return {x.head<6>(), x[6]};
}

}  // namespace

Vec3<double> Equilibrium::theta() const { return so3::log<double>(state.R); }

Equilibrium Statics::solve(SolidLaw law, const Load& load, const State& start) {
  Equilibrium at;
  at.state = start;
  return iterate(law, load, at, {});
}

Equilibrium Statics::turn(SolidLaw law, const Load& load, double theta_1, const Equilibrium& start) {
  return iterate(law, load, start, theta_1);
}

Equilibrium Statics::iterate(SolidLaw law, const Load& load, const Equilibrium& start,
                             std::optional<double> theta_1) {
  Equilibrium out;
  out.state = start.state;
  out.factor = start.factor;
  double last = 1;
  bool stale = true;  // the factors are those of a state too far from this one
  Eigen::Matrix<double, Eigen::Dynamic, 6> K_face, Y;
  for (out.iterations = 1; out.iterations <= kMostIterations; ++out.iterations) {
    const Assembly a = solid_.assemble(law, out.state);
    const Vec6 at_one = applied(load, out.state);
    const Vec6 face = solid_.face_load(out.state, a.force) - out.factor * at_one;
    Mat6 face_tangent = a.face;
    take_off_change(load, out.factor, out.state, face_tangent);
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
    const auto [dq, d_factor] =
        face_step(schur, Vec6(face - K_face.transpose() * y), at_one, out.state, theta_1);
    const Eigen::VectorXd du = -y - Y * dq;
    if (!dq.allFinite() || !du.allFinite()) {
      out.reason = "the iteration left the finite numbers";
      return out;
    }
    State before = out.state;
    solid_.move(out.state, du, dq);
    out.factor += d_factor;
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
    if (taken_back) {
      out.state = std::move(before);
      out.factor -= d_factor;
    } else {
      last = out.update;
    }
    stale = taken_back;
  }
  out.reason = "no convergence within " + std::to_string(kMostIterations) + " iterations";
  return out;
}

std::optional<Mat6> Statics::condensed(SolidLaw law, const Load& load, const State& state) {
  Assembly a = solid_.assemble(law, state);
  if (!cholesky_.factorize(a.K)) return {};
  take_off_change(load, 1, state, a.face);
  return Mat6(a.face - a.K_face.transpose() * cholesky_.solve(a.K_face));
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
