#include "reference/programs/identify.hpp"

#include "reference/programs/joints.hpp"
#include "reference/record/worst.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfway::reference {
namespace {

/// Vectors of theirs and ours, each question's over its own size.
struct Pairs {
  std::vector<std::pair<Vec3<double>, Vec3<double>>> all;

  void add(const Vec3<double>& their, const Vec3<double>& our, double size) {
    if (size > 0) all.emplace_back(their / size, our / size);
  }
  bool has_ours() const {
    return std::ranges::any_of(all, [](const auto& pair) { return !pair.second.isZero(0); });
  }
  /// Ours so many times is nearest to theirs.
  double scale() const {
    double both = 0, ours = 0;
    for (const auto& [their, our] : all) both += their.dot(our), ours += our.squaredNorm();
    return ours > 0 ? both / ours : 1;
  }
  double left(double scale) const {
    double sum = 0;
    for (const auto& [their, our] : all) sum += (their - scale * our).squaredNorm();
    return sum;
  }
};

struct Fit {
  Pairs forces, moments;
  int count = 0;

  void add(const TwelveLoads& their, const TwelveLoads& our, bool moments_first) {
    for (int kind = 0; kind < 2; ++kind) {
      const int i = moments_first ? 1 - kind : kind;
      const double size = std::hypot(part(their, i).norm(), part(their, i + 2).norm());
      for (int node = 0; node < 2; ++node)
        (kind == 0 ? forces : moments).add(part(their, i + 2 * node), part(our, i + 2 * node), size);
    }
    ++count;
  }

  double distance(double force_scale, double moment_scale) const {
    return count == 0 ? std::nan("")
                      : std::sqrt((forces.left(force_scale) + moments.left(moment_scale)) / count);
  }
};

/// A scale that a person would give a name: 1, or as it is where nothing near it will do.
double named_scale(double scale, double tolerance) {
  for (const double plain : {1., 180 / std::numbers::pi, std::numbers::pi / 180, 0.5, 2., 0.25, 4.})
    if (std::abs(std::abs(scale) / plain - 1) <= tolerance) return std::copysign(plain, scale);
  return scale;
}

constexpr double kNamed = 1e-3;  // how far a scale may be from one that has a name

struct Near {
  Identity identity;
  int oddities = 0;
};

}  // namespace

std::vector<Candidate> known_joints() {
  std::vector<Candidate> out;
  for (const Entry& entry : formulations())
    if (!entry.needs_xi)
      out.push_back(
          {std::string(entry.name), answerer(entry, entry.probe_xi), false, !entry.block_diagonal_law_only});
  for (const ProgramJoint& joint : program_joints())
    out.push_back({std::string(joint.name), joint.in_double, joint.facts.isotropic_moments});
  return out;
}

Identity identify(const std::vector<Answered>& answers, const std::vector<Candidate>& candidates,
                  double tolerance) {
  std::vector<Near> all;
  const auto ways = conventions();
  for (const Candidate& candidate : candidates) {
    std::vector<std::vector<TwelveLoads>> by_hearing(5);
    for (int hearing = 0; hearing < 5; ++hearing) {
      for (const Answered& a : answers)
        by_hearing[std::size_t(hearing)].push_back(candidate.answer(heard(a.ask, Hearing(hearing))));
    }
    for (Convention c : ways) {
      Fit fit;
      for (std::size_t i = 0; i < answers.size(); ++i) {
        // The law sees what was heard; points and axes are those of the bodies as the program has them.
        const Ask seen = heard(answers[i].ask, c.hearing);
        const TwelveLoads ours = in_their_words(by_hearing[std::size_t(c.hearing)][i], seen, c);
        const bool is_exchanged = (c.hearing == Hearing::bodies_exchanged) != c.answers_exchanged;
        fit.add(answers[i].loads, is_exchanged ? exchanged(ours) : ours, c.moments_first);
      }
      const auto keep = [&](double force_scale, double moment_scale, double most) {
        // Of no forces, or no moments, the scale is the other one's.
        c.force_scale = !fit.forces.has_ours() ? std::copysign(1., moment_scale) : force_scale;
        c.moment_scale = !fit.moments.has_ours() ? std::copysign(1., force_scale) : moment_scale;
        const double distance = fit.distance(c.force_scale, c.moment_scale);
        if (distance <= most) all.push_back({{candidate.name, c, distance, {}}, c.oddities()});
      };
      const double force = fit.forces.scale(), moment = fit.moments.scale();
      keep(std::copysign(1., force), std::copysign(1., moment), std::numeric_limits<double>::max());
      // Other scales alone where they make it the same joint: they would bring a stranger nearer, too.
      keep(named_scale(force, kNamed), named_scale(moment, kNamed), tolerance);
    }
  }
  if (all.empty()) return {};
  const double best =
      std::ranges::min_element(all, {}, [](const Near& n) { return n.identity.distance; })->identity.distance;
  const double near = larger(3 * best, tolerance);
  const bool is_stranger = best > tolerance;  // then the nearest counts, else the list's order
  const Near* chosen = nullptr;
  for (const Near& n : all) {
    if (n.identity.distance > near) continue;
    const bool simpler = chosen == nullptr || n.oddities < chosen->oddities;
    const bool nearer = chosen != nullptr && n.oddities == chosen->oddities &&
                        n.identity.distance < chosen->identity.distance;
    if (simpler || (is_stranger && nearer)) chosen = &n;
  }
  Identity out = chosen->identity;
  for (const Near& n : all) {
    const bool same =
        n.oddities == chosen->oddities && n.identity.distance <= near && n.identity.name != out.name;
    if (same && std::ranges::find(out.as_well, n.identity.name) == out.as_well.end())
      out.as_well.push_back(n.identity.name);
  }
  return out;
}

}  // namespace halfway::reference
