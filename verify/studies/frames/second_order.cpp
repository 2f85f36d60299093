// What the other axes change for a law on angles about axes in turn, by second-order theory.
//
// R_i(e_i) R_j(e_j) R_k(e_k) = exp(e + Q(e)/2 + O(3)) with Q = e_i e_j u_i x u_j + e_i e_k u_i x u_k + e_j
// e_k u_j x u_k (Baker, Campbell, Hausdorff), so the law strains by e = theta - Q(theta)/2 where a tensorial
// one does by theta. Turned by H it has H Q(H^T theta) for Q; under the same moment m = K theta the rotation
// then changes by
//   dQ/2                             m = K e in a node's frame,
//   dQ/2 + K^-1 (d dQ/d theta)^T m/2 moments of the energy e . K e/2.
// In the other order of the nodes the angles are those of R^T, -theta - Q(theta)/2: Q changes its sign.
#include "verify/studies/frames/frames.hpp"

#include "verify/oracle/scene_access.hpp"
#include "verify/studies/frames/laws.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

namespace halfway::verify {
namespace {

using reference::Scene;

using Quadratic = std::function<Vec3<double>(const Vec3<double>&)>;

Quadratic deviation(const TurnSequence& s) {
  const Vec3<double> u_i = Vec3<double>::Unit(s.i), u_j = Vec3<double>::Unit(s.j),
                     u_k = Vec3<double>::Unit(s.k);
  return [=](const Vec3<double>& v) -> Vec3<double> {
    return v[s.i] * v[s.j] * u_i.cross(u_j) + v[s.i] * v[s.k] * u_i.cross(u_k) +
           v[s.j] * v[s.k] * u_j.cross(u_k);
  };
}

/// At the rotation theta, when Q becomes Q + dQ.
Vec3<double> predicted(const TurnSequence& s, const Quadratic& dQ, const Scene& scene,
                       const Vec3<double>& theta) {
  Vec3<double> out = dQ(theta) / 2;
  if (!s.conjugate) return out;
  Mat3<double> slope;  // of a quadratic: central differences are exact
  for (int k = 0; k < 3; ++k) {
    const Vec3<double> e = theta.norm() * Vec3<double>::Unit(k);
    slope.col(k) = (dQ(theta + e) - dQ(theta - e)) / (2 * theta.norm());
  }
  const Eigen::VectorXd K = std::get<reference::LinearSpec>(scene.joint.law).matrix.diagonal();
  return out + (slope.transpose() * K.cwiseProduct(theta)).cwiseQuotient(K) / 2;
}

/// C1 at a thousandth of its load: theta is 1e-5 rad.
Scene small_load() {
  Scene out = scene("c1_skewed_torque");
  out.factor_end = 1e-3;
  return out;
}

/// NaN of a path that arrives nowhere.
Vec3<double> theta_of(const LawUnderTest& law, const Written& written) {
  const auto theta = curve_answers(law, written).theta;
  return theta.empty() ? Vec3<double>::Constant(std::nan("")) : theta.back();
}

Finding compared(const TurnSequence& s, const char* what, const Quadratic& dQ, const LawUnderTest& changed,
                 const Written& written) {
  const Scene original = small_load();
  const LawUnderTest law = *own(*reference::find_formulation(s.formulation));
  const Vec3<double> theta = theta_of(law, as_it_is(original, {}));
  const Vec3<double> change = theta_of(changed, written) - theta;
  const Vec3<double> expected = predicted(s, dQ, original, theta);
  Finding f;
  f.name = fmt::format("frames/{}/second_order/{}", s.formulation, what);
  f.formulation = s.formulation;
  f.subject = "frames";
  f.value = (change - expected).norm() / expected.norm();
  f.parameter =
      fmt::format("changes by {:.4g} of itself at {:.3g} rad", change.norm() / theta.norm(), theta.norm());
  f.unit = "of the change";
  f.oracle = Oracle::closed_form;
  f.high = 5e-3;
  f.reason =
      "second-order theory; the third order is 1e-5 rad times the ratio of the stiffnesses, 100, and some";
  return judged(f);
}

std::vector<Finding> law_turned(const TurnSequence& s) {
  const Mat3<double> H = so3::exp<double>(kTurns[0]);
  const Quadratic Q = deviation(s);
  const Quadratic dQ = [=](const Vec3<double>& v) -> Vec3<double> { return H * Q(H.transpose() * v) - Q(v); };
  return {compared(s, "law_in_other_axes", dQ, *own(*reference::find_formulation(s.formulation)),
                   law_in_other_axes(small_load(), H))};
}

/// field_a is not the image of field_b, nor field_b that of field_a.
std::vector<Finding> exchanged(const TurnSequence& s, const char* other) {
  const Quadratic Q = deviation(s);
  const Quadratic dQ = [=](const Vec3<double>& v) -> Vec3<double> { return -2 * Q(v); };
  return {compared(s, "nodes_exchanged", dQ, *own(*reference::find_formulation(other)),
                   nodes_exchanged(small_load(), {}))};
}

}  // namespace

void add_frames_second_order(Checks& checks) {
  for (const auto& entry : reference::formulations()) {
    const TurnSequence* s = turn_sequence(entry.name);
    if (!s) continue;
    const std::string name = fmt::format("frames/{}/", entry.name);
    checks.push_back({name + "second_order/law_in_other_axes", "cases", [s] { return law_turned(*s); }});
    if (s->conjugate) continue;  // their partner is exact
    const char* other = entry.name == "field_a" ? "field_b" : "field_a";
    checks.push_back({name + "second_order/nodes_exchanged", "cases", [=] { return exchanged(*s, other); }});
  }
}

}  // namespace halfway::verify
