#include "verify/studies/rods/one_joint.hpp"

#include "reference/numbers/random.hpp"
#include "reference/record/effort.hpp"
#include "reference/scene/names.hpp"
#include "reference/solve/path.hpp"
#include "reference/solve/stability/critical.hpp"
#include "reference/truth/rod/rod.hpp"
#include "verify/once.hpp"
#include "verify/oracle/scene_access.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace halfway::verify {
namespace {

using reference::Entry, reference::Scene;
namespace rod = reference::rod;

constexpr double kLost = std::numeric_limits<double>::quiet_NaN();

/// A joint with this law under a fixed moment: its path, and nothing that would be drawn.
Scene moment_scene(const Vec3<double>& stiffness, const Vec3<double>& moment) {
  Scene out;
  out.joint.law = reference::LinearSpec{Eigen::MatrixXd(stiffness.asDiagonal()), false};
  out.loads = {{reference::LoadType::fixed_moment, moment, Vec3<double>::Zero()}};
  return out;
}

bool arrived(const reference::Outcome<double>& state) {
  return state.status == Status::converged || state.status == Status::inaccurate;
}

constexpr double kSkewStep = 10, kSkewEnd = 1800;  // N m: as the scene

SkewMoment made_skew_moment() {
  const Scene& block = scene("c3_buckling");
  SkewMoment out;
  for (double m = kSkewStep; m <= kSkewEnd; m += kSkewStep) out.moment.push_back(m);
  const Vec3<double> stiffness = compliances(block).cwiseInverse();
  for (const rod::Tip& tip :
       rod::tips_under_moment(rod::slender(stiffness), block.loads.front().value, out.moment)) {
    out.rod.push_back(so3::log<double>(tip.R));
    out.rod_angle.push_back(out.rod.back().norm());
  }
  return out;
}

Followed followed(const Entry& entry) {
  const SkewMoment& truth = skew_moment();
  const Scene& block = scene("c3_buckling");
  reference::Path<double> path(block, entry, entry.probe_xi);
  Followed out;
  for (std::size_t i = 0; i < truth.moment.size(); ++i) {
    const auto& state = path.advance(truth.moment[i]);
    if (!arrived(state)) break;
    const Vec3<double> theta = so3::log<double>(path.node().R);
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

Draws drawn(const RandomMoments& of) {
  reference::Generator random(2026);
  Draws out;
  for (int i = 0; i < kRandomMoments; ++i) {
    const Vec3<double> linear_turn = of.size * random.direction();
    out.moment.push_back(of.stiffness.cwiseProduct(linear_turn));
    out.rod.push_back(rod::tips_under_moment(rod::slender(of.stiffness), out.moment.back(), {1}).front().R);
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
  const std::size_t count = by_effort(std::size_t(kRandomMoments), std::size_t(20));
  for (std::size_t i = 0; i < count; ++i) {
    const Scene scene = moment_scene(of.stiffness, all.moment[i]);
    reference::Path<double> path(scene, entry, entry.probe_xi);
    const bool there = arrived(path.advance(1));
    out.lost += !there;
    const Mat3<double> apart = all.rod[i].transpose() * path.node().R;
    errors.push_back(there ? so3::log<double>(apart).norm() / so3::log<double>(all.rod[i]).norm()
                           : std::numeric_limits<double>::infinity());
  }
  const auto middle = errors.begin() + std::ptrdiff_t(count / 2);
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

std::optional<double> Followed::within(double tolerance) const {
  const auto& load = skew_moment().moment;
  for (std::size_t i = 0; i < error.size(); ++i)
    if (!(error[i] <= tolerance)) return i == 0 ? std::nullopt : std::optional(load[i - 1]);
  return load.back();
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
    for (const double size : {0.2, 1.0}) {
      out.push_back({"1:2:3", {1, 2, 3}, size});
      out.push_back({"c3", block_stiffness(), size});
      out.push_back({"1:10:100", {1, 10, 100}, size});
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
    const auto add = [&](const char* name, const Vec3<double>& k) {
      out.push_back({name, k, rod::critical_semi_tangential(k)});
    };
    add("c3", block_stiffness());
    add("2:1:3", {2, 1, 3});
    add("strip_10", {10, 1, 0.65});
    add("strip_100", {100, 1, 0.65});
    return out;
  }();
  return all;
}

const std::optional<double>& critical_of(const Entry& entry, const SemiTangential& of) {
  static Once<std::optional<double>, const SemiTangential*> once;
  return once(entry, &of, [&] { return first_divergence(entry, of.stiffness); });
}

}  // namespace halfway::verify
