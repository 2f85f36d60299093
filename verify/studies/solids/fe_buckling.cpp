// The body of C3 under C3's moment: the kept paths are today's, begin as linear and second-order theory say,
// are the same by two elements, and end at critical moments of their own.
#include "reference/truth/fe/studies/study_makers.hpp"
#include "verify/oracle/fe_access.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/worst.hpp"
#include "verify/studies/solids/c3_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfway::verify {
namespace {

namespace fe = reference::fe;
using fe::ElementKind;
using fe::SolidLaw;

/// The law that goes farthest: formulations are held against it.
constexpr SolidLaw kFarthest = SolidLaw::neo_hooke;

Vec3<double> direction() { return fe::scene_load("c3_buckling").m; }

/// The coarsest path, by longer steps: the same equilibria before and behind the limit.
std::vector<Finding> path_again() {
  constexpr double kStep = 100, kLoad = 800, kTurn = 0.1;
  const fe::BlockPath& kept = *block_family(kFarthest, ElementKind::hex20_full, 1).front();
  const fe::Solid solid(block_mesh(kept.mesh), fe::body_named("block").material,
                        fe::body_named("block").face);
  fe::Statics statics(solid);
  fe::Equilibrium at;
  at.state = solid.unloaded();
  for (at.factor = kStep; at.factor <= kLoad; at.factor += kStep)
    at.state = statics.solve(kFarthest, {Vec3<double>::Zero(), at.factor * direction()}, at.state).state;
  at.factor = kLoad;
  const auto same = std::ranges::find(kept.rising, kLoad, [](const auto& p) { return std::round(p.moment); });
  if (same == kept.rising.end() || kept.turned.empty())
    throw std::runtime_error("the kept path is too short");
  const Vec3<double> theta = tapped(at.theta());
  const double end = kept.turned.back().theta[0];
  const fe::Load unit{Vec3<double>::Zero(), direction()};
  for (double theta_1 = at.theta()[0] + kTurn; theta_1 < end; theta_1 += kTurn)
    at = statics.turn(kFarthest, unit, theta_1, at);
  at = statics.turn(kFarthest, unit, end, at);
  const auto add = [](const char* what, double difference) {
    return solid_finding(std::string("c3_block/kept/") + what)
        .in("relative")
        .measured(difference)
        .at_most(1e-8, "the same equilibrium: Newton's own 1e-12, times the condition of the tangent there")
        .by(Oracle::kept);
  };
  return {add("rotation", (theta - same->theta).norm() / same->theta.norm()),
          add("moment_behind_limit", std::abs(tapped(at.factor) / kept.turned.back().moment - 1))};
}

/// theta_1 and theta_3 of the smallest moment over the moment, extrapolated, against the characterisation's
/// compliances; theta_2 against second-order theory with xi = 1/2, which mirror symmetry gives.
std::vector<Finding> small_load(SolidLaw law) {
  std::vector<Finding> out;
  const BodyPoint first = body_curve(law, ElementKind::hex20_full).front();
  const Vec3<double> m = first.moment * direction();
  for (const std::size_t k : {0u, 2u}) {
    const fe::Estimate truth = converged(
        characterisation("block"), ElementKind::hex20,
        [k](const fe::SecondOrder& s) { return s.compliance(Eigen::Index(3 + k), Eigen::Index(3 + k)); });
    const double value = first.theta[k].value / m[Eigen::Index(k)];
    const double bar = first.theta[k].uncertainty / m[Eigen::Index(k)];
    out.push_back(
        solid_finding(fmt::format("c3_block/small_load/{}/theta_{}", to_string(law), k + 1))
            .in("error bars")
            .measured(std::abs(value - truth.value) / (bar + truth.uncertainty),
                      fmt::format("{:.6g} +- {:.1e}, graded meshes {:.6g} +- {:.1e}", value, bar, truth.value,
                                  truth.uncertainty))
            .at_most(1, "even and graded meshes extrapolate to the same solid: the sum of their error bars")
            .by(Oracle::independent));
  }
  const fe::BlockPath& mesh = finest_block(law);
  const Vec3<double> C = mesh.compliance;
  const double second = C[1] * (C[0] - C[2]) * m[0] * m[2] / 2;
  out.push_back(
      solid_finding(fmt::format("c3_block/small_load/{}/theta_2", to_string(law)))
          .in("relative")
          .measured(std::abs(mesh.rising.front().theta[1] / second - 1))
          .at_most(2e-4,
                   "the next term grows with the square of the load: some 13 % at 100 N m, a 1600th of it "
                   "here, twice")
          .by(Oracle::closed_form));
  return out;
}

/// Two elements, one solid, as far as both have error bars.
std::vector<Finding> elements_agree_on_path() {
  const auto a = body_curve(kFarthest, ElementKind::hex20_full),
             b = body_curve(kFarthest, ElementKind::hex27);
  const std::size_t both = std::min(a.size(), b.size());
  std::vector<Finding> out;
  for (std::size_t k = 0; k < 3; ++k) {
    Measurement worst;
    for (std::size_t i = 0; i < both; ++i) {
      const fe::Estimate &p = a[i].theta[k], &q = b[i].theta[k];
      worst.include(std::abs(p.value - q.value) / (p.uncertainty + q.uncertainty),
                    fmt::format("{:g} of {:g} N m", a[i].moment, a[both - 1].moment));
    }
    out.push_back(solid_finding(fmt::format("c3_block/elements/theta_{}", k + 1))
                      .in("error bars")
                      .measured(worst)
                      .at_most(1, "both extrapolate to the same solid: within the sum of their error bars")
                      .by(Oracle::independent));
  }
  return out;
}

/// theta_1 at which the determinant of the face's tangent vanishes, by secants between the points.
double singular_at(const fe::BlockPath& path) {
  std::vector<fe::BlockPoint> all = path.rising;
  all.insert(all.end(), path.turned.begin(), path.turned.end());
  for (std::size_t i = 1; i < all.size(); ++i) {
    const double before = all[i - 1].determinant, after = all[i].determinant;
    if (after > 0) continue;
    return all[i - 1].theta[0] + (all[i].theta[0] - all[i - 1].theta[0]) * before / (before - after);
  }
  return std::nan("");
}

/// Where the moment is largest on the path the tangent is singular: loads and tangents of the same limit.
std::vector<Finding> limits() {
  std::vector<Finding> out;
  for (const fe::BlockPath& path : block_paths()) {
    const auto limit = limit_of(path);
    const fe::BlockMesh& m = path.mesh;
    Draft f = solid_finding(fmt::format("c3_block/limit/{}/{}/{}/graded_{:g}", to_string(m.law),
                                        to_string(m.element), m.level, m.grading));
    if (!limit) {
      out.push_back(f.left_out(fmt::format(
          "no maximum: up to {:.4g} N m, then {}; singular at theta_1 = {:.3g}", path.rising.back().moment,
          path.turned.empty() ? path.rising_end : path.turned_end, singular_at(path))));
      continue;
    }
    out.push_back(
        f.in("rad")
            .measured(std::abs(limit->theta_1 - singular_at(path)),
                      fmt::format("{:.1f} N m at theta_1 = {:.3f}", limit->moment, limit->theta_1))
            .at_most(
                0.01,
                "a parabola and a secant, through points 0.05 rad apart or somewhat more: a fifth of that")
            .by(Oracle::independent));
  }
  return out;
}

/// On the way the body is stable against every small turn of the face.
std::vector<Finding> stable() {
  std::vector<Finding> out;
  for (const SolidLaw law : fe::kLaws) {
    const auto curve = body_curve(law, ElementKind::hex20_full);
    const auto& points = finest_block(law).rising;
    Extent lowest;
    Measurement product;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      lowest.include(curve[i].lowest);
      product.include(std::abs(points[i].stiffness.prod() / points[i].determinant - 1),
                      fmt::format("{:g} N m", curve[i].moment));
    }
    const std::string name = fmt::format("c3_block/stable/{}", to_string(law));
    out.push_back(solid_finding(name)
                      .in("N m/rad")
                      .measured(lowest.low(),
                                fmt::format("up to {:g} N m, {:.2f} rad; {:.1f} unloaded",
                                            curve.back().moment, curve.back().phi(), curve.front().lowest))
                      .at_least(0, "no critical moment on the way: the tangent's eigenvalues stay positive")
                      .by(Oracle::independent));
    out.push_back(solid_finding(name + "/determinant")
                      .in("relative")
                      .measured(product)
                      .at_most(1e-12,
                               "real eigenvalues, whose product is the determinant; rounding, times the "
                               "ratio of the stiffnesses (40)")
                      .by(Oracle::closed_form));
  }
  return out;
}

/// How far the laws of the rubber are apart, beside what the joints' laws differ by.
std::vector<Finding> spread_of_laws() {
  constexpr double kMoment = 200;
  Extent theta_1;
  std::string text;
  for (const SolidLaw law : fe::kLaws) {
    for (const BodyPoint& p : body_curve(law, ElementKind::hex20_full)) {
      if (p.moment != kMoment) continue;
      theta_1.include(p.theta[0].value);
      text += fmt::format("{} {:.4f} +- {:.4f}; ", to_string(law), p.theta[0].value, p.theta[0].uncertainty);
    }
  }
  return {solid_finding("c3_block/spread_of_laws")
              .in("relative")
              .measured(theta_1.high() / theta_1.low() - 1, fmt::format("{}at {:g} N m", text, kMoment))
              .reported("theta_1 of laws of the rubber that agree to first order: largest over smallest")
              .by(Oracle::independent)};
}

}  // namespace

void fe_buckling(Checks& checks) {
  checks.push_back({"fe/c3_block/kept", "fe", path_again});
  for (SolidLaw law : fe::kLaws)
    checks.push_back(
        {fmt::format("fe/c3_block/small_load/{}", to_string(law)), "fe", [law] { return small_load(law); }});
  checks.push_back({"fe/c3_block/elements", "fe", elements_agree_on_path});
  checks.push_back({"fe/c3_block/limit", "fe", limits});
  checks.push_back({"fe/c3_block/stable", "fe", stable});
  checks.push_back({"fe/c3_block/spread_of_laws", "fe", spread_of_laws});
}

}  // namespace halfway::verify
