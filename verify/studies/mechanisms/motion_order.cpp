// Scenes in time against closed forms: the order of each integrator, the tolerance, the error that is told.
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/worst.hpp"
#include "verify/studies/mechanisms/motion.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

using reference::Curve;

constexpr double kMoment = 0.06, kStart = 0.5;  // N m, rad; about joint axis 3, which is (0.96, 0, 0.28)

/// The law of `potential` is of theta itself.
Curve torsion(const std::string& integration, double damping) {
  return moved(scene_of(kTorsion, {{"INTEGRATION", integration},
                                   {"MOMENT", "[0.0576, 0, 0.0168]"},
                                   {"DAMPING", fmt::format("{}", damping)},
                                   {"START", "start = { theta = [0.48, 0, 0.14] }"}}),
               "potential");
}

/// Largest distance from the closed form, rad, and that over the error of the same row that is told.
struct Off {
  double error = 0, over_told = 0;
};
Off off(const Curve& curve, double damping) {
  if (!curve.converged) return {std::nan(""), std::nan("")};
  const Torsion exact{damping, kMoment, kStart};
  Off out;
  for (std::size_t i = 1; i < curve.rows.size(); ++i) {
    const double error = std::abs(tapped(curve.rows[i][1]) - exact.angle(curve.rows[i][0]));
    reference::keep_largest(out.error, error);
    reference::keep_largest(out.over_told, error / tapped(curve.errors[i]));
  }
  return out;
}

std::vector<Finding> order(const char* integrator, int expected, double step) {
  const auto at = [&](double h) {
    return off(torsion(fmt::format("integrator = \"{}\"\nstep = {}", integrator, h), 0), 0);
  };
  const Off coarse = at(step), fine = at(step / 2);
  const std::string name = fmt::format("motion_order/{}", integrator);
  return {finding(name + "/order")
              .about("motion")
              .measured(std::log2(coarse.error / fine.error),
                        fmt::format("steps {:g} s and half of it, {:.2g} and {:.2g} rad off", step,
                                    coarse.error, fine.error))
              .equal(expected, 0.1,
                     "the next power of the step beside the leading one, and rows that are not "
                     "where the error is largest")
              .by(Oracle::closed_form),
          finding(name + "/error_told")
              .about("motion")
              .measured(fine.over_told)
              .in("of the error that is told")
              .equal(1, 0.1, "told from half the step by the order: the next power is missing")
              .by(Oracle::closed_form)};
}

std::vector<Finding> tolerance() {
  std::vector<Finding> out;
  constexpr double kDamping = 6e-3;
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    const Off found = off(torsion(fmt::format("tolerance = {}", tolerance), kDamping), kDamping);
    out.push_back(finding(fmt::format("motion_order/runge_kutta/{:.0e}", tolerance))
                      .about("motion")
                      .measured(found.error, fmt::format("{:.2g} of what is told", found.over_told))
                      .in("rad")
                      .at_most(20 * tolerance,
                               "errors of some twenty to a hundred steps, each of the tolerance at most")
                      .by(Oracle::closed_form));
  }
  return out;
}

/// What a kick of a splitting works for a load that grows, in energies: the balance falls by the order.
std::vector<Finding> work() {
  const auto balance = [](double h) {
    const Curve curve = torsion(fmt::format("integrator = \"splitting_2\"\nstep = {}", h), 0);
    double out = curve.converged ? 0 : std::nan("");
    for (const auto& row : curve.rows) reference::keep_largest(out, std::abs(tapped(row[2])));
    return out;
  };
  const double coarse = balance(0.01), fine = balance(0.005);
  return {
      finding("motion_order/work")
          .about("motion")
          .measured(std::log2(coarse / fine), fmt::format("balance off by {:.2g} and {:.2g} J", coarse, fine))
          .equal(2, 0.1, "of second order: kinetic and strain energies oscillate about what is conserved")
          .by(Oracle::closed_form)};
}

}  // namespace

void motion_order(Checks& checks) {
  checks.push_back({"motion_order/splitting_2", "mechanisms", [] { return order("splitting_2", 2, 0.01); }});
  checks.push_back({"motion_order/splitting_4", "mechanisms", [] { return order("splitting_4", 4, 0.02); }});
  checks.push_back({"motion_order/runge_kutta", "mechanisms", tolerance});
  checks.push_back({"motion_order/work", "mechanisms", work});
}

}  // namespace halfway::verify
