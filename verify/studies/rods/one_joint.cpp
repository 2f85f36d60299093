#include "verify/studies/rods/one_joint.hpp"

#include "reference/numbers/random.hpp"
#include "reference/record/effort.hpp"
#include "reference/record/worst.hpp"
#include "reference/scene/joint/convexity.hpp"
#include "reference/solve/path.hpp"
#include "reference/solve/stability/critical.hpp"
#include "reference/truth/rod/critical.hpp"
#include "verify/once.hpp"
#include "verify/oracle/scene_access.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace halfway::verify {
namespace {

using reference::Entry, reference::Scene, reference::by_effort;
namespace rod = reference::rod;

constexpr double kLost = std::numeric_limits<double>::quiet_NaN();

/// One metre long, and neither stretches nor shears.
rod::Rod rod_of(const Vec3<double>& stiffness) { return rod::straight(1, rod::of_stiffness(stiffness)); }

/// A joint with this law under a fixed moment: its path, and nothing that would be drawn.
Scene moment_scene(const Vec3<double>& stiffness, const Vec3<double>& moment) {
  Scene out;
  out.joint.law = reference::LinearSpec{Eigen::MatrixXd(stiffness.asDiagonal()), false};
  out.loads = {{reference::LoadType::fixed_moment, moment, Vec3<double>::Zero()}};
  return out;
}

constexpr double kSkewStep = 5, kSkewEnd = 1800;  // N m: as the scene

SkewMoment made_skew_moment() {
  const Scene& block = scene("c3_buckling");
  SkewMoment out;
  for (double m = kSkewStep; m <= kSkewEnd; m += kSkewStep) out.moment.push_back(m);
  const Vec3<double> stiffness = compliances(block).cwiseInverse();
  for (const rod::Tip& tip :
       rod::tips_under_moment(rod_of(stiffness), block.loads.front().value, out.moment)) {
    out.rod.push_back(so3::log<double>(tip.R));
    out.rod_angle.push_back(out.rod.back().norm());
  }
  return out;
}

Followed followed(const Entry& entry) {
  const SkewMoment& truth = skew_moment();
  const Scene& block = scene("c3_buckling");
  reference::Path<double> path(block, entry, entry.probe_xi);
  const double radius = reference::convex_radius(entry, block.joint);
  Followed out;
  for (std::size_t i = 0; i < truth.moment.size(); ++i) {
    const auto& state = path.advance(truth.moment[i]);
    if (!is_equilibrium(state.status)) break;
    const Vec3<double> theta = so3::log<double>(path.node().R);
    if (theta.norm() > radius) break;  // refused from here on
    out.error.push_back((theta - truth.rod[i]).norm() / truth.rod_angle[i]);
  }
  out.error.resize(truth.moment.size(), kLost);
  return out;
}

/// The same for every formulation, so that none is lucky.
struct Draws {
  std::vector<Vec3<double>> moment;
  std::vector<Mat3<double>> rod;
};

/// Uniform on the sphere.
Vec3<double> any_direction(reference::Generator& random) {
  Vec3<double> v = random.vector(1);
  while (v.norm() < 0.1 || v.norm() > 1) v = random.vector(1);
  return v.normalized();
}

Draws drawn(const RandomMoments& of) {
  reference::Generator random(2026);
  Draws out;
  for (int i = 0; i < by_effort(200, 100); ++i) {
    Vec3<double> turn = any_direction(random);
    if (of.drawn == Drawn::moment) turn = turn.cwiseQuotient(of.stiffness).normalized();
    out.moment.push_back(of.size * of.stiffness.cwiseProduct(turn));
    out.rod.push_back(rod::tips_under_moment(rod_of(of.stiffness), out.moment.back(), {1}).front().R);
  }
  return out;
}
const Draws& draws(const RandomMoments& of) {
  static std::map<const RandomMoments*, Draws> kept;
  const auto known = kept.find(&of);
  return known != kept.end() ? known->second : kept.emplace(&of, drawn(of)).first->second;
}

Spread spread(const Entry& entry, const RandomMoments& of) {
  const Draws& all = draws(of);
  std::vector<double> errors;
  Spread out;
  out.of = int(all.moment.size());
  for (std::size_t i = 0; i < all.moment.size(); ++i) {
    const Scene scene = moment_scene(of.stiffness, all.moment[i]);
    reference::Path<double> path(scene, entry, entry.probe_xi);
    const bool there = is_equilibrium(path.advance(1).status);
    out.lost += !there;
    const Mat3<double> apart = all.rod[i].transpose() * path.node().R;
    errors.push_back(there ? so3::log<double>(apart).norm() / so3::log<double>(all.rod[i]).norm()
                           : std::numeric_limits<double>::infinity());
  }
  const auto middle = errors.begin() + std::ptrdiff_t(errors.size() / 2);
  std::ranges::nth_element(errors, middle);
  out.median = std::isfinite(*middle) ? *middle : kLost;
  return out;
}

const Vec3<double>& block_stiffness() {
  static const Vec3<double> k = compliances(scene("c3_buckling")).cwiseInverse();
  return k;
}

std::optional<double> first_divergence(const Entry& entry, const Vec3<double>& stiffness) {
  const reference::JointSpec spec = moment_scene(stiffness, Vec3<double>::UnitX()).joint;
  const auto found = reference::PrimaryPath(entry, spec, 0)
                         .critical({reference::MomentType::semi_tangential, false}, {})
                         .divergence;
  return found ? std::optional(double(found->load)) : std::nullopt;
}

}  // namespace

const char* to_string(Drawn drawn) { return drawn == Drawn::moment ? "moment" : "turn"; }

std::optional<std::size_t> Followed::last_within(double tolerance) const {
  const auto beyond = std::ranges::find_if_not(error, [&](double e) { return e <= tolerance; });
  return beyond == error.begin() ? std::nullopt : std::optional(std::size_t(beyond - error.begin()) - 1);
}

const SkewMoment& skew_moment() {
  static const SkewMoment made = made_skew_moment();
  return made;
}

const Followed& follows_skew_moment(const Entry& entry) {
  static Once<Followed> once;
  return once(entry, [&] { return followed(entry); });
}

const std::vector<RandomMoments>& random_moments() {
  static const std::vector<RandomMoments> all = [] {
    std::vector<RandomMoments> out;
    for (const Drawn drawn : {Drawn::moment, Drawn::turn}) {
      for (const double size : {0.2, 1.0}) {
        out.push_back({"1:2:3", {1, 2, 3}, drawn, size});
        out.push_back({"c3", block_stiffness(), drawn, size});
        out.push_back({"1:10:100", {1, 10, 100}, drawn, size});
      }
    }
    return out;
  }();
  return all;
}

const Spread& error_of_random(const Entry& entry, const RandomMoments& moments) {
  static Once<Spread, const RandomMoments*> once;
  return once(entry, &moments, [&] { return spread(entry, moments); });
}

const std::vector<SemiTangential>& semi_tangential() {
  static const std::vector<SemiTangential> all = [] {
    std::vector<SemiTangential> out;
    const auto add = [&](const char* name, const Vec3<double>& k, double below) {
      out.push_back({name, k, rod::critical_semi_tangential(rod_of(k), 0, below).load});
    };
    add("c3", block_stiffness(), 2500);
    add("2:1:3", {2, 1, 3}, 8);
    add("strip_10", {10, 1, 0.65}, 4);
    add("strip_100", {100, 1, 0.65}, 4);
    return out;
  }();
  return all;
}

const std::optional<double>& critical_of(const Entry& entry, const SemiTangential& of) {
  static Once<std::optional<double>, const SemiTangential*> once;
  return once(entry, &of, [&] { return first_divergence(entry, of.stiffness); });
}

}  // namespace halfway::verify
