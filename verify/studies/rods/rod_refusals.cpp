// What is no rod, no stiffness or no list of loads is refused by name, and what cannot be reached says how
// far it came.
#include "reference/truth/rod/closed/loads.hpp"
#include "reference/truth/rod/closed/third_order.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/rods/rod_access.hpp"

#include <functional>
#include <limits>

namespace halfway::verify {
namespace {

namespace rod = reference::rod;

struct Refusal {
  const char* name;
  const char* says;
  std::function<void()> run;
};

rod::Rod curved() {
  rod::Rod out = straight_rod(1, {1, 2, 3});
  out.curvature0 = {0, 0, 1};
  return out;
}

std::vector<Refusal> refusals() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const rod::Rod straight = straight_rod(1, {1, 2, 3});
  const auto one_shape = [](double) { return rod::Section{{1, 1, 2}}; };
  return {{"negative_stiffness", "not positive",
           [] {
             rod::of_stiffness({1, -2, 3});
           }},
          {"stiffness_nan", "not positive",
           [=] {
             rod::of_stiffness({1, 2, 3}, {1, nan, 1});
           }},
          {"curve_of_curved_rod", "straight uniform rod",
           [] {
             tips_under_moment(curved(), {1, 0, 0}, {1});
           }},
          {"amounts_descend", "ascend from 0",
           [=] {
             tips_under_moment(straight, {1, 0, 0}, {2, 1});
           }},
          {"amount_nan", "ascend from 0",
           [=] {
             tips_under_moment(straight, {1, 0, 0}, {nan});
           }},
          {"indefinite", "positive definite",
           [] {
             rod::end_rotation(Vec3<double>(1, -1, 2).asDiagonal(), {1, 0, 0});
           }},
          {"degree", "degree of 8", [] { collocate(curved(), {}, 5); }},
          {"force_nan", "came no further than 0 ",
           [=] {
             solve(curved(), {.force = {nan, 0, 0}});
           }},
          {"no_zero", "no change of sign", [=] { critical_semi_tangential(straight, 0, 0.1); }},
          {"equal_compliances", "two compliances are equal", [=] { rod::closed::xi_of_taper(one_shape, 1); }},
          {"ends", "these ends", [] { rod::closed::torque_determinant(rod::TorqueEnds::clamped, 1); }}};
}

std::vector<Finding> refused() {
  std::vector<Finding> out;
  for (const Refusal& r : refusals()) {
    std::string said = "nothing";
    try {
      r.run();
    } catch (const std::exception& e) {
      said = e.what();
    }
    said = tapped(said);
    out.push_back(rod_finding(std::string("refusals/") + r.name)
                      .measured(said.find(r.says) == std::string::npos ? 1 : 0, said)
                      .in("messages missed")
                      .equal(0, 0, std::string("says: ") + r.says)
                      .by(Oracle::independent));
  }
  return out;
}

}  // namespace

void rod_refusals(Checks& checks) { checks.push_back({"rods/refusals", "", refused}); }

}  // namespace halfway::verify
