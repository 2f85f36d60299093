#include "reference/scene/joint/names.hpp"

#include "reference/scene/joint/convexity.hpp"

namespace halfway::reference {
namespace {

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
