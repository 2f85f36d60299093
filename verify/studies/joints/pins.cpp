// Euler-angle joints against mechanisms of three pins and three slides, whose angles are given and never read
// off.
#include "reference/truth/pins.hpp"

#include "reference/numbers/random.hpp"
#include "verify/oracle/property.hpp"

#include <fmt/format.h>

namespace halfway::verify {
namespace {

namespace pins = reference::pins;
using V50 = Vec3<Real50>;
using M50 = Mat3<Real50>;
using Loads50 = Eigen::Matrix<Real50, 12, 1>;

/// Where the slides are, and how the torques of the springs act.
struct Mechanism {
  const char* formulation;
  pins::Order order;
  bool on_pins;      ///< torques by springs in the pins; else by couples along the axes of the slides' node
  bool slides_on_b;  ///< and the force acts at a's joint point
};
constexpr Mechanism kMechanisms[] = {{"simbody_xyz", {0, 1, 2}, true, false},
                                     {"field_a", {2, 0, 1}, false, false},
                                     {"field_b", {2, 0, 1}, false, true}};

/// Both nodes, and what the mechanism carries.
struct Carried {
  Pose<Real50> a, b;
  Loads50 q;
};

Carried carried(const Mechanism& m, const JointSpec& spec, const M50& P_a, const V50& e, const V50& slide) {
  const auto chain = pins::chain<Real50>(P_a, m.order, e);
  const M50& base = m.slides_on_b ? chain.P_b : chain.P_a;
  const auto springs = pins::springs<Real50>(spec, slide, e);
  Carried out;
  // Node frames by the inverse of H: doubles are no rotation to 50 digits, joint frames are.
  out.a.R = P_a * spec.a.H.cast<Real50>().inverse();
  out.b.R = chain.P_b * spec.b.H.cast<Real50>().inverse();
  out.a.x = V50(Real50(0.3), Real50(-1.1), Real50(0.7));
  const V50 p_a = out.a.x + out.a.R * spec.a.o.cast<Real50>(), p_b = p_a + base * slide;
  out.b.x = p_b - out.b.R * spec.b.o.cast<Real50>();
  const V50 moment =
      m.on_pins ? pins::moment_of_pins<Real50>(chain.axes, springs.torque) : V50(base * springs.torque);
  out.q = pins::at_nodes<Real50>(base * springs.force, moment, m.slides_on_b ? p_a : p_b, out.a.x, out.b.x);
  return out;
}

V50 drawn(reference::Generator& g, const Vec3<double>& largest) {
  V50 out;
  for (int i = 0; i < 3; ++i) out[i] = Real50(g.uniform(-largest[i], largest[i]));
  return out;
}

/// Outer pins turn by up to 3 rad, the middle one by up to 1.5: beyond pi/2 it locks.
Finding compared(const Mechanism& m, const Entry& entry, Kind kind) {
  reference::Generator g(312);
  Vec3<double> largest(3, 3, 3);
  largest[m.order[1]] = 1.5;
  Measurement worst;
  for (const Probe& probe : probes(entry, kind, 12, 1)) {
    const V50 turn = drawn(g, Vec3<double>::Constant(3)), e = drawn(g, largest);
    const V50 slide = drawn(g, Vec3<double>::Constant(0.5));
    const M50 P_a = pins::turn(0, turn[0]) * pins::turn(1, turn[1]) * pins::turn(2, turn[2]);
    const Carried exact = carried(m, probe.spec, P_a, e, slide);
    const auto q = reference::node_loads<Real50>(entry, probe.spec, exact.a, exact.b, false).q;
    worst.include(loads_apart(exact.q, q), fmt::format("pins at {:.3g}, {:.3g}, {:.3g} rad", double(e[0]),
                                                       double(e[1]), double(e[2])));
  }
  return finding(fmt::format("pins/{}/{}", m.formulation, to_string(kind)))
      .of(m.formulation, to_string(kind))
      .about("pins")
      .measured(worst)
      .in("relative")
      .at_most(kRounding, kRoundingReason)
      .by(Oracle::independent);
}

}  // namespace

void pins(Checks& checks) {
  for (const Mechanism& m : kMechanisms) {
    for (const Kind kind : kKinds) {
      checks.push_back({fmt::format("pins/{}/{}", m.formulation, to_string(kind)), "", [&m, kind] {
                          const Entry& entry = *reference::find_formulation(m.formulation);
                          return std::vector{compared(m, entry, kind)};
                        }});
    }
  }
}

}  // namespace halfway::verify
