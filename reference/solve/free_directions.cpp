#include "reference/solve/free_directions.hpp"

#include "reference/record/worst.hpp"
#include "reference/scene/joint/free_strains.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace halfway::reference {
namespace {

/// What a load may do on a free direction: rounding of frames and offsets.
constexpr double kNothing = 1e-12;

/// N and N m that the law itself bears on the strains at rest.
Eigen::VectorXd stress_at_rest(const JointSpec& joint) {
  if (joint.kind == Kind::linear_angular)
    return AnyLaw<double, 6>(joint.law)(Eigen::Matrix<double, 6, 1>::Zero()).stress;
  return AnyLaw<double, 3>(joint.law)(Vec3<double>::Zero()).stress;
}

/// The law with a stiffness more, in its own strains.
struct Stiffened {
  const Eigen::MatrixXd& more;

  PlainLawSpec operator()(const LinearSpec& law) const { return LinearSpec{law.matrix + more, false}; }
  PlainLawSpec operator()(const PolynomialSpec& law) const {
    return PolynomialSpec{law.k1 + more.diagonal(), law.k3, law.k5};
  }
  PlainLawSpec operator()(const PerAxisSpec& law) const {
    auto axes = *law.axes;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const double slope = more(Eigen::Index(i), Eigen::Index(i));
      for (std::size_t piece = 0; piece < axes[i].pieces.size(); ++piece) {
        axes[i].pieces[piece][0] += slope * axes[i].origin(piece);
        axes[i].pieces[piece][1] += slope;
      }
    }
    return PerAxisSpec{std::make_shared<const std::vector<PiecewisePolynomial>>(std::move(axes))};
  }
};

/// The same of any law; what is more has its zero at no strain, wherever the law's own is.
LawSpec stiffened(const LawSpec& law, const Eigen::MatrixXd& more) {
  PlainLawSpec own = visit_unshifted(Stiffened{more}, law);
  if (const auto* shifted = std::get_if<ShiftedSpec>(&law))
    return ShiftedSpec{std::move(own), shifted->offset, shifted->preload + more * shifted->offset};
  return std::visit([](auto& plain) -> LawSpec { return std::move(plain); }, own);
}

/// What the scene's loads do on the strains of the joint at rest, N and N m, in its axes.
Eigen::VectorXd load_at_rest(const Scene& scene) {
  const JointSpec& joint = scene.joint;
  // Node a at the origin in global axes: the joint's axes are H_a, node b stands at H_a H_b^T.
  const Mat3<double> R_b = joint.a.H * joint.b.H.transpose();
  Vec3<double> f = Vec3<double>::Zero(), m = Vec3<double>::Zero();
  for (const SceneLoad& load : scene.loads) {
    const Vec3<double> value = follows(load.type) ? Vec3<double>(R_b * load.value) : load.value;
    if (is_force(load.type)) {
      f += value;
      m += (R_b * (load.point - joint.b.o)).cross(value);
    } else {
      m += value;
    }
  }
  Eigen::VectorXd all(6);
  all << joint.a.H.transpose() * f, joint.a.H.transpose() * m;
  if (joint.kind == Kind::linear_angular) return all;
  return joint.kind == Kind::linear ? all.head(3) : all.tail(3);
}

/// How far a curve goes, m or rad.
struct Reach {
  Eigen::Index axis;

  double operator()(const LinearSpec&) const { return 1; }
  double operator()(const PolynomialSpec&) const { return 1; }
  double operator()(const PerAxisSpec& law) const {
    double out = 0;
    for (const double knot : (*law.axes)[std::size_t(axis)].knots) keep_largest(out, std::abs(knot));
    return out > 0 ? out : 1;
  }
};

/// @param units  strain_units of the stiffness
bool works(const Eigen::VectorXd& load, const Eigen::VectorXd& strain, const Eigen::VectorXd& units) {
  return std::abs(load.dot(strain)) > kNothing * load.cwiseAbs().cwiseProduct(units).sum();
}

/// The strains without stiffness at rest: of curves with play on which the load works, and all others.
struct Free {
  explicit Free(const Scene& scene) {
    const Eigen::MatrixXd K = rest_stiffness(scene.joint.law, scene.joint.kind);
    const Eigen::VectorXd load = load_at_rest(scene);
    units = strain_units(K);
    const Eigen::MatrixXd all = free_strains(K);
    for (const auto& column : all.colwise()) {
      const Eigen::VectorXd strain = column;
      const bool begins = is_slack(scene.joint.law, strain) && works(load, strain, units);
      (begins ? with_play : still).push_back(strain);
    }
  }

  Eigen::VectorXd units;
  std::vector<Eigen::VectorXd> with_play{}, still{};
};

/// The scene with a stiffness along some of them, `hold` times their block's largest.
std::optional<Scene> held_by(const Scene& scene, const Free& free,
                             const std::vector<Eigen::VectorXd>& strains, double hold) {
  if (strains.empty()) return std::nullopt;
  const Eigen::VectorXd stiff = free.units.cwiseInverse().cwiseAbs2();
  Eigen::MatrixXd more = Eigen::MatrixXd::Zero(stiff.size(), stiff.size());
  for (const Eigen::VectorXd& strain : strains) {
    const Eigen::VectorXd carried = stiff.cwiseProduct(strain);
    more += hold * carried * carried.transpose();
  }
  Scene out = scene;
  out.joint.law = stiffened(scene.joint.law, more);
  return out;
}

}  // namespace

std::optional<Scene> held(const Scene& scene, double hold) {
  const Free free(scene);
  return held_by(scene, free, free.still, hold);
}

bool has_play(const Scene& scene) { return !Free(scene).with_play.empty(); }

Scene eased(const Scene& scene, double factor) {
  // So soft that the load alone would move the joint far beyond its curve: it leaves the play at once, and
  // what is left is a start near the equilibrium.
  constexpr double kFar = 1000;
  const Eigen::VectorXd load = factor * load_at_rest(scene);
  Eigen::MatrixXd more = Eigen::MatrixXd::Zero(load.size(), load.size());
  for (const Eigen::VectorXd& strain : Free(scene).with_play) {
    Eigen::Index i = 0;
    while (strain[i] == 0) ++i;  // curves are along the axes
    more(i, i) = std::abs(load[i]) / (kFar * visit_unshifted(Reach{i}, scene.joint.law));
  }
  Scene out = scene;
  out.joint.law = stiffened(scene.joint.law, more);
  return out;
}

bool agree(const Curve& a, const Curve& b) {
  if (a.rows.empty() || b.rows.empty()) return false;
  const auto &x = a.rows.back(), &y = b.rows.back();
  double largest = 0, difference = 0;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (i > 0) keep_largest(largest, std::abs(x[i]));  // the first is the load factor
    keep_largest(difference, std::abs(x[i] - y[i]));
  }
  return x.size() == y.size() && difference <= 1e-9 * largest;
}

std::optional<std::string> works_on_free_direction(const Scene& scene) {
  const Free free(scene);
  const std::pair<const char*, Eigen::VectorXd> all[] = {{"the load", load_at_rest(scene)},
                                                         {"the law's preload", stress_at_rest(scene.joint)}};
  for (const auto& [what, load] : all) {
    for (const auto& strain : free.still) {
      if (!works(load, strain, free.units)) continue;
      if (is_slack(scene.joint.law, strain))
        return fmt::format(
            "{} works on the {}, whose curve is flat at rest and stiff beyond: no path leads there "
            "from rest; one does with a load that grows in its place",
            what, strain_name(strain, scene.joint.kind));
      return fmt::format("{} works on a direction without stiffness, free: {}; nothing balances it there",
                         what, strain_name(strain, scene.joint.kind));
    }
  }
  return std::nullopt;
}

}  // namespace halfway::reference
