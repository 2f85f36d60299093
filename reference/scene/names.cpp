#include "reference/scene/names.hpp"

#include "reference/scene/convexity.hpp"
#include "reference/scene/document.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

namespace halfway::reference {
namespace {

/// Letters inserted, left out, replaced or exchanged with their neighbour between a and b.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      row[j + 1] = std::min({row[j] + 1, last[j + 1] + 1, last[j] + (a[i] != b[j])});
      if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j])
        row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
    }
    before = last;
    last = row;
  }
  return last.back();
}

/// 0: an abbreviation; else the edits, and too many for a name that is not like it.
std::size_t unlikeness(std::string_view name, std::string_view candidate) {
  if (name.size() >= 2 && candidate.starts_with(name)) return 0;
  return edits(name, candidate);
}

/// Does the law couple translation and rotation?
struct IsCoupled {
  bool operator()(const LinearSpec& law) const {
    return !law.matrix.topRightCorner(3, 3).isZero(0) || !law.matrix.bottomLeftCorner(3, 3).isZero(0);
  }
  bool operator()(const PolynomialSpec&) const { return false; }
  bool operator()(const PerAxisSpec&) const { return false; }
};

}  // namespace

std::vector<std::string_view> formulation_names() {
  std::vector<std::string_view> names;
  for (const Entry& entry : formulations()) names.push_back(entry.name);
  return names;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& allowed) {
  const auto typed = name.substr(0, 60);
  const auto most = std::max<std::size_t>(1, typed.size() / 3);
  const auto best = std::ranges::min_element(
      allowed, {}, [&](std::string_view candidate) { return unlikeness(typed, candidate); });
  const bool is_like = best != allowed.end() && typed.size() > 1 && unlikeness(typed, *best) <= most;
  if (!is_like) return "";
  return fmt::format(" (did you mean '{}'?)", *best);
}

std::string unknown_name(std::string_view what, std::string_view name,
                         const std::vector<std::string_view>& allowed) {
  return fmt::format("unknown {} '{}'{}; allowed: {}", what, shortened(std::string(name)),
                     did_you_mean(name, allowed), fmt::join(allowed, ", "));
}

const LawRefusal* law_refusal(const Entry& entry, const JointSpec& spec) {
  static constexpr LawRefusal kNotOneStiffness{
      "takes no curves, preload or offset: its series is of one stiffness",
      "a positive definite stiffness or a polynomial without preload and offset",
      "law_of_one_stiffness_only"};
  static constexpr LawRefusal kNotDefinite{"takes no law whose angular stiffness is not positive definite",
                                           "a positive definite stiffness", "singular_law"};
  static constexpr LawRefusal kCoupled{"takes no coupling of translation and rotation",
                                       "off-diagonal 3x3 blocks of zeros", "block_diagonal_law_only"};
  const bool is_series = entry.convex_radius != nullptr && spec.kind != Kind::linear;
  if (is_series &&
      (std::holds_alternative<PerAxisSpec>(spec.law) || std::holds_alternative<ShiftedSpec>(spec.law)))
    return &kNotOneStiffness;
  if (!(convex_radius(entry, spec) > 0)) return &kNotDefinite;
  if (entry.block_diagonal_law_only && spec.kind == Kind::linear_angular &&
      visit_unshifted(IsCoupled{}, spec.law))
    return &kCoupled;
  return nullptr;
}

}  // namespace halfway::reference
