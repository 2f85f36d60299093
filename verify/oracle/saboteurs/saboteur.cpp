#include "verify/oracle/saboteurs/saboteur.hpp"

#include "verify/oracle/saboteurs/sabotage.hpp"

#include <algorithm>

namespace halfway::verify {
namespace {

using namespace sabotage;

/// In each of the three scalars.
template <class Change>
Entry changed(const Entry& healthy, const Change& change) {
  Entry out = healthy;
  change(out.in_double), change(out.in_real50), change(out.in_dual50);
  return out;
}

Entry strain_nan(const Entry& healthy) {
  return changed(healthy, []<class T>(Evaluators<T>& e) {
    e.strain = [strain = e.strain](const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
      auto out = strain(spec, a, b);
      for (T& x : out) spoil(x);
      return out;
    };
  });
}

Entry strain_off(const Entry& healthy) {
  return changed(healthy, []<class T>(Evaluators<T>& e) {
    e.strain = [strain = e.strain](const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
      auto out = strain(spec, a, b);
      const auto whole = out;
      for (int i = 0; i < out.size(); ++i) out[i] += T(0.01) * whole[(i + 1) % out.size()];
      return out;
    };
  });
}

Entry untouched(const Entry& healthy) { return healthy; }

Entry energy_nan(const Entry& healthy) {
  return changed(healthy, []<class T>(Evaluators<T>& e) {
    e.energy = [energy = e.energy](const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
      std::optional<T> out = energy(spec, a, b);
      if (out) spoil(*out);
      return out;
    };
  });
}

Entry energy_off(const Entry& healthy) {
  return changed(healthy, []<class T>(Evaluators<T>& e) {
    e.energy = [energy = e.energy](const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
      std::optional<T> out = energy(spec, a, b);
      if (out) *out = *out * T(1 + 1e-6);
      return out;
    };
  });
}

constexpr Saboteur kAll[] = {
    {"moments_nan", "moments are NaN", {.moments = true}, &wrapped<PartNan<3>>},
    {"forces_nan", "forces are NaN", {.forces = true}, &wrapped<PartNan<0>>},
    {"tangent_nan", "the tangent is NaN", {.tangent = true}, &wrapped<TangentNan>},
    {"strain_nan", "strains are NaN", {.strain = true}, &strain_nan},
    {"energy_nan", "the energy is NaN", {.energy = true}, &energy_nan},
    {"tap_nan", "numbers of what has no face are NaN", {.taps = true}, &untouched, Tap::nan},
    {"throws", "loads throw", {}, &wrapped<Throws>},
    {"loads_too_large", "loads and tangent are 1e-6 too large", {}, &wrapped<LoadsTooLarge>},
    {"strain_off", "each strain has a hundredth of the next one in it", {}, &strain_off},
    {"energy_off", "the energy is 1e-6 too large", {}, &energy_off},
    {"transposed_frame", "loads are turned by P_a P_b^T", {}, &wrapped<TransposedFrame>},
    {"tangent_off", "one entry of the tangent is off by 1e-6 of its norm", {}, &wrapped<TangentOff>},
    {"half_rate", "the half-way frame turns at half the sum of the spins", {}, &wrapped<HalfRate>},
    {"wrong_point", "moments are about the origin", {}, &wrapped<WrongPoint>},
    {"transposed_axes",
     "loads leave the axes of node a by the transposed rotation",
     {},
     &wrapped<TransposedAxes>},
    {"no_reaction", "node a has no loads", {}, &wrapped<NoReaction>},
    {"exchanged", "loads of a and b are exchanged beyond 1 rad", {}, &wrapped<Exchanged>},
    {"beyond_two", "loads are 1 % too large beyond 2 rad", {}, &wrapped<WrongBeyondTwo>},
    {"non_deterministic", "loads differ by up to 1e-9 from call to call", {}, &wrapped<NonDeterministic>},
    {"no_loads", "loads and tangent are zero", {}, &wrapped<NoLoads>},
    {"tap_slight", "numbers of what has no face are off by up to 1e-6", {}, &untouched, Tap::slight},
    {"tap_gross", "numbers of what has no face are off by up to a tenth", {}, &untouched, Tap::gross},
};

/// Notes what is asked for. An answer without energy was not an energy.
Entry witness(const Entry& healthy, Parts& seen) {
  return changed(healthy, [&seen]<class T>(Evaluators<T>& e) {
    e.strain = [&seen, strain = e.strain](const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
      seen.strain = true;
      return strain(spec, a, b);
    };
    e.angular = [&seen, angular = e.angular](const JointSpec& spec, const Pose<T>& a, const Pose<T>& b,
                                             bool with_tangent) {
      seen.moments = true, seen.tangent |= with_tangent;
      return angular(spec, a, b, with_tangent);
    };
    e.point = [&seen, point = e.point](const JointSpec& spec, const Pose<T>& a, const Pose<T>& b,
                                       bool with_tangent) {
      seen.moments = seen.forces = true, seen.tangent |= with_tangent;
      return point(spec, a, b, with_tangent);
    };
    e.energy = [&seen, energy = e.energy](const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
      std::optional<T> out = energy(spec, a, b);
      seen.energy |= out.has_value();
      return out;
    };
  });
}

template <class Change>
std::vector<Entry> catalog_with(const Change& change) {
  std::vector<Entry> out;
  for (const Entry& entry : reference::catalogued()) out.push_back(change(entry));
  return out;
}

}  // namespace

std::span<const Saboteur> saboteurs() { return kAll; }

const Saboteur* find_saboteur(std::string_view name) {
  const auto it = std::ranges::find(kAll, name, &Saboteur::name);
  return it == std::end(kAll) ? nullptr : &*it;
}

ScopedSabotage::ScopedSabotage(const Saboteur& saboteur, std::string_view formulation)
    : registry_(catalog_with([&](const Entry& entry) {
        return formulation.empty() || entry.name == formulation ? saboteur.of(entry) : entry;
      })),
      tap_(saboteur.tap) {}

std::vector<Entry> witnessed(Parts& seen) {
  return catalog_with([&](const Entry& entry) { return witness(entry, seen); });
}

}  // namespace halfway::verify
