#include "verify/studies/frames/laws.hpp"

#include "reference/programs/joints.hpp"

namespace halfway::verify {
namespace {

constexpr TurnSequence kSequences[] = {{"field_a", 2, 0, 1, false},
                                       {"field_b", 2, 0, 1, false},
                                       {"simbody_xyz", 0, 1, 2, true},
                                       {"drake_rpy", 2, 1, 0, true}};

struct Partners {
  std::string_view formulation, angular, linear_angular;  ///< empty: none
};
/// A law in the frame of one node is that in the frame of the other, and the transposed rotation has the same
/// angles in the reverse sequence: x-y-z and z-y-x. Chrono's moments alone are those of attached_b, MBDyn's
/// those of attached_a; their forces have no image.
constexpr Partners kPartners[] = {
    {"attached_a", "attached_b", "attached_b"}, {"attached_b", "attached_a", "attached_a"},
    {"simbody_xyz", "drake_rpy", ""},           {"drake_rpy", "simbody_xyz", ""},
    {"chrono_body", "attached_a", ""},          {"mbdyn_joint_inv", "attached_b", ""}};

}  // namespace

const TurnSequence* turn_sequence(std::string_view formulation) {
  for (const TurnSequence& s : kSequences) {
    if (s.formulation == formulation) return &s;
  }
  return nullptr;
}

bool is_tensorial(const reference::Entry& entry) {
  if (turn_sequence(entry.name) || entry.needs_length) return false;
  const auto* joint = reference::find_program_joint(entry.name);
  return joint == nullptr || joint->facts.tensorial;
}

std::optional<LawUnderTest> own(const reference::Entry& entry) {
  return LawUnderTest{&entry, entry.probe_xi};
}

std::optional<LawUnderTest> exchange_partner(const reference::Entry& entry, Kind kind) {
  if (entry.needs_xi) return LawUnderTest{&entry, 1 - entry.probe_xi};
  if (entry.facts.node_order.of(kind).holds()) return own(entry);
  for (const Partners& p : kPartners) {
    const std::string_view partner = kind == Kind::angular ? p.angular : p.linear_angular;
    if (p.formulation == entry.name && !partner.empty()) return own(*reference::find_formulation(partner));
  }
  return std::nullopt;
}

}  // namespace halfway::verify
