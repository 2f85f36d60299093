#include "verify/oracle/saboteurs/claims.hpp"

#include <algorithm>
#include <iterator>

namespace halfway::verify {
namespace {

struct Overlooks {
  std::string_view ending;  ///< of the check's name
  Parts parts;
  std::string_view why;
};

constexpr Overlooks kOverlooked[] = {
    {"/force_balance", {.moments = true}, "adds the forces alone"},
    {"/symmetry", {.forces = true}, "the commutator of the spins is of the moments"},
    {"/linear/modelling_error", {.forces = true}, "judges the moment of a node whose orientation is held"},
    {"/held_orientation", {.moments = true}, "no moment turns a node whose orientation is held"},
    {"/linear/mechanism_of_one_joint", {.moments = true}, "no moment turns a node whose orientation is held"},
    {"/second_order/law_in_other_axes", {.strain = true, .energy = true}, "compares rotations, no energies"},
    {"/second_order/nodes_exchanged", {.strain = true, .energy = true}, "compares rotations, no energies"},
    {"/frames_load_not_turned", {.strain = true, .energy = true}, "compares poses, no energies"},
    {"/frames_frame_transposed", {.strain = true, .energy = true}, "compares poses, no energies"},
    {"/frames_law_not_turned", {.strain = true, .energy = true}, "compares poses, no energies"},
    {"/frames_law_turned_on", {.strain = true, .energy = true}, "compares poses, no energies"},
    {"/long_run",
     {.moments = true, .forces = true},
     "kernels move the bodies; frequencies and energies are asked"},
    {"/six_modes", {.forces = true}, "tangents have the modes, moments the load"},
    {"/flutter_without_load", {.moments = true, .forces = true}, "judges the tangent of the forces"},
    {"/kernel_compensated", {.tangent = true}, "compares loads; /kernel has the tangent"},
    {"/free_spin_x", {.forces = true}, "turns without moves: moments alone"},
    {"/free_spin_z", {.forces = true}, "turns without moves: moments alone"},
    {"/second_order_moments", {.forces = true}, "turns without moves: moments alone"},
    {"programs/turns", {.forces = true}, "turns without moves: moments alone"},
    {"programs/jumps", {.forces = true}, "turns without moves: moments alone"},
    {"programs/cable", {.forces = true}, "turns without moves: moments alone"},
    {"/assembly_eigen",
     {.moments = true, .forces = true, .strain = true},
     "matrices; /assembly has the loads"},
    {"/assembly_transposed_block", {.moments = true, .forces = true, .strain = true}, "compares matrices"},
    {"/assembly_lost_end", {.moments = true, .forces = true, .strain = true}, "compares matrices"},
    {"/assembly_doubled_joint", {.moments = true, .forces = true, .strain = true}, "compares matrices"},
    {"damped_oscillator/invariant", {.moments = true}, "a body on a linear joint alone does not turn"},
    {"release/invariant", {.moments = true}, "a body on a linear joint alone does not turn"},
    {"free_pair/invariant",
     {.strain = true, .energy = true},
     "has momenta; /motion_balance has the energies"},
    {"motion_ends", {.forces = true, .strain = true, .energy = true}, "judges words about turns and steps"},
    {"motion_order/splitting_2", {.energy = true}, "compares angles; motion_order/work has the energies"},
    {"motion_order/splitting_4", {.energy = true}, "compares angles; motion_order/work has the energies"},
    {"motion_order/runge_kutta", {.energy = true}, "compares angles; motion_order/work has the energies"},
    {"/motion_at_rest", {.strain = true, .energy = true}, "compares poses"},
    {"/motion_let_go", {.strain = true, .energy = true}, "compares poses"},
    {"motion_release/runge_kutta", {.energy = true}, "compares angles"},
    {"motion_release/splitting_4", {.energy = true}, "compares angles"},
    {"motion_release", {.strain = true, .energy = true}, "judges words about equilibria"},
    {"motion_order/work", {.strain = true}, "judges the balance of energies"},
    {"/motion_momenta", {.strain = true, .energy = true}, "judges momenta, which loads change"},
    {"/motion_balance",
     {.strain = true},
     "judges energies, which joints with a potential do not ask strains for"},
    {"/rounding_tangent", {.moments = true, .forces = true}, "compares tangents; /rounding has the loads"},
};

constexpr Shown kShown[] = {
    {"*/linear_angular/node_order", "mutants/transposed_frame"},
    {"*/linear_angular/node_order", "mutants/projected_with_node_a"},
    {"*/linear_angular/moment_balance", "mutants/spin_not_transposed"},
    {"*/linear_angular/moment_balance", "mutants/xi_for_one_minus_xi_in_moment"},
    {"*/linear_angular/moment_balance", "mutants/offset_without_arm"},
    {"*/linear_angular/moment_balance", "mutants/no_arm_moment"},
    {"*/linear/energy_gradient", "mutants/eq_29_as_printed"},
    {"*/linear/energy_gradient", "mutants/half_rate_of_halfway_frame"},
    {"*/linear/energy_gradient", "mutants/offset_b_carried_by_a"},
    {"*/angular/energy_gradient", "mutants/secant_of_half_angle"},
    {"*/angular/tangent", "mutants/tangent_without_geometric_term"},
    {"*/angular/tangent", "mutants/tangent_with_gamma_for_inverse"},
    {"*/angular/fingerprint_alpha", "mutants/xi_for_one_minus_xi"},
    {"*/angular/fingerprint_alpha", "mutants/log_of_transpose"},
    {"so3/*/double", "mutants/gamma_late_threshold"},
    {"so3/*/double", "mutants/gamma_series_sign"},
    {"so3/*/double", "mutants/log_by_sine_near_pi"},
    {"identities/eq_29_printed", "mutants/eq_29_as_it_should_be"},
    {"frames/*/other_axes", "mutants/frames_load_not_turned"},
    {"frames/*/other_axes", "mutants/frames_frame_transposed"},
    {"frames/*/other_axes", "mutants/frames_critical_in_node_axes"},
    {"frames/*/other_axes", "mutants/frames_inertia_left_behind"},
    {"frames/*/law_in_other_axes", "mutants/frames_law_not_turned"},
    {"frames/*/law_in_other_axes", "mutants/frames_law_turned_on"},
    {"*/hinges", "mutants/solver/stiffest_entry"},
    {"*/hinges", "mutants/solver/small_step"},
    {"*/hinges", "mutants/solver/positions"},
    {"fe/symmetric_body", "mutants/second_order_without_turning_face"},
    {"fe/calculix/*/*", "mutants/calculix_moment_without_gamma"},
    {"*/linear_angular/assembly", "mutants/assembly_transposed_block"},
    {"*/linear_angular/assembly", "mutants/assembly_lost_end"},
    {"*/linear_angular/assembly", "mutants/assembly_doubled_joint"},
    {"rods/law/third_order", "mutants/third_order_without_stiffness_term"},
    {"rods/law/taper_xi", "mutants/one_xi_for_a_taper"},
    {"rods/critical/tip_force", "mutants/fork_factor_for_tip_force"},
    {"chains/*/order", "mutants/chain_joints_at_ends"},
    {"chains/*/order", "mutants/chain_half_a_link_too_long"},
    {"chains/*/order", "mutants/chain_loads_follow"},
    {"packaging/folds", "packaging/folds_catches"},
    {"packaging/layering", "packaging/layering_catches"},
    {"packaging/add_formulation", "packaging/saboteurs_caught"},
};

}  // namespace

std::span<const Shown> shown_by_mutants() { return kShown; }

std::vector<std::string> mutants_of(const std::string& sort) {
  std::vector<std::string> out;
  for (const Shown& shown : kShown) {
    if (shown.sort == sort) out.emplace_back(shown.mutant);
  }
  return out;
}

Parts overlooked(const std::string& check) {
  const auto it =
      std::ranges::find_if(kOverlooked, [&](const Overlooks& o) { return check.ends_with(o.ending); });
  return it == std::end(kOverlooked) ? Parts{} : it->parts;
}

}  // namespace halfway::verify
