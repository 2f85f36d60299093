// What the studies of other programs' joints share: who is asked, and how a finding is named.
#pragma once

#include "reference/programs/joints.hpp"
#include "reference/programs/properties.hpp"
#include "verify/check.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/worst.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace halfway::verify {

/// What rounding leaves of a relative defect in double: some fifty roundings of rotations, arms and springs,
/// near a singular angle over its cosine.
inline constexpr double kDoubleRounding = 1e-12;
inline constexpr const char* kDoubleRoundingReason =
    "double precision: some fifty roundings, magnified where a measure is nearly singular";

/// The joint of that name, a program's or the catalog's, in double. Its loads pass a tap.
inline reference::Answerer program_subject(std::string_view name) {
  if (const auto* joint = reference::find_program_joint(name))
    return [joint](const reference::Ask& ask) { return tapped(joint->in_double(ask)); };
  if (const auto* entry = reference::find_formulation(name)) {
    return [answer = reference::answerer(*entry, entry->probe_xi)](const reference::Ask& ask) {
      return tapped(answer(ask));
    };
  }
  throw std::invalid_argument(fmt::format("no joint is called {}", name));
}

/// programs/WHAT/JOINT
inline Draft program_finding(std::string_view what, std::string_view joint) {
  return finding(fmt::format("programs/{}/{}", what, joint)).of(std::string(joint)).about("programs");
}

inline reference::Springs springs_of(const programs::ProgramFacts& facts) {
  return facts.isotropic_moments && facts.isotropic_forces ? reference::Springs::isotropic
                                                           : reference::Springs::diagonal;
}

/// Generic questions that the program can be asked: one stiffness where it takes one.
inline std::vector<reference::Ask> program_asks(const programs::ProgramFacts& facts, int count,
                                                double largest) {
  auto asks = reference::generic_asks(count, 0.05, largest, springs_of(facts), facts.is_bond);
  for (reference::Ask& ask : asks) {
    if (facts.isotropic_moments) ask.K_m = ask.K_m(0, 0) * Mat3<double>::Identity();
    if (facts.isotropic_forces) ask.K_f = ask.K_f(0, 0) * Mat3<double>::Identity();
  }
  return asks;
}

}  // namespace halfway::verify
