// Moments of dead forces on the last node, which have a potential: critical loads of the rod, and how stiff
// the tip is.
#include "reference/numbers/zeros.hpp"
#include "reference/truth/data.hpp"
#include "verify/check.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/chains/chain_orders.hpp"

#include <fmt/format.h>
#include <Eigen/LU>

#include <cmath>

namespace halfway::verify {
namespace {

namespace chain = reference::chain;
using reference::Entry;
using reference::Measurement;
using Mat6 = Eigen::Matrix<double, 6, 6>;

Draft draft_of(const Entry& entry, const std::string& what) {
  return finding(fmt::format("chains/{}/{}", entry.name, what))
      .about("chains")
      .of(std::string(entry.name), "linear_angular");
}

chain::Solution with_tip(const chain::Chain& c, const chain::EndLoads& loads) {
  chain::Settings settings;
  settings.tip_stiffness = true;
  return chain::solve(c, loads, settings);
}

/// Determinant of the tip's stiffness under a moment about axis 1, of dead forces that are square where the
/// chain is twisted by it. NaN where there is no such state.
double determinant(const chain::Chain& c, double moment) {
  const Vec3<double> m = moment * Vec3<double>::UnitX();
  const chain::Solution fixed = chain::solve(c, {.moment = m});
  const chain::Solution dead =
      with_tip(c, {.virial = chain::semi_tangential(m, chain::pose(fixed.nodes.back()).R)});
  if (!fixed.converged || !dead.converged) return std::nan("");
  return dead.tip_stiffness->determinant();
}

/// C3 as a rod, and its first critical moment by the matrix exponential of its equations.
struct Rod {
  Vec3<double> compliance;
  double critical;
};
Rod c3() {
  static const nlohmann::json row = reference::read_data("rods/values.json")["semi_tangential"][0];
  const auto& c = row["compliance"];
  return {Vec3<double>(c[0], c[1], c[2]), std::stod(row["moment"].get<std::string>())};
}

/// The first zero of the determinant, found by its sign; NaN where there is none up to a tenth beyond the
/// rod's.
double critical(const Entry& entry, const Rod& rod, long links) {
  chain::Chain c;
  c.formulation = entry.name, c.links = links;
  if (entry.needs_xi) c.xi = entry.probe_xi;
  const Vec3<double> k = rod.compliance.cwiseInverse();
  c.section = {k[0], k[1], k[2], 1e6, 1e6, 1e6};
  const auto positive = [&](double moment) { return determinant(c, moment) > 0; };
  const double step = rod.critical / 20;
  for (double m = step; m < 1.1 * rod.critical; m += step) {
    if (!positive(m + step)) return reference::last_where(positive, m, m + step, 45);
  }
  return std::nan("");
}

/// The rod's load is approached with N^-2 by laws of one node as well: what they err by at first order
/// changes its sign with the order of the nodes, and a twisted chain is the same from either end.
std::vector<Finding> critical_of_c3(const Entry& entry) {
  const Rod rod = c3();
  const double coarse = tapped(critical(entry, rod, 16)), fine = tapped(critical(entry, rod, 32));
  const int order = entry.convex_radius ? 4 : 2;
  const double power = std::pow(2., order);
  return {
      draft_of(entry, "c3_semi_tangential/order")
          .measured(std::log2((coarse / rod.critical - 1) / (fine / rod.critical - 1)),
                    fmt::format("{:.9g} N m with 16 links, {:.9g} with 32", coarse, fine))
          .equal(
              order, 0.03,
              "even in the order of the nodes, so that all laws have order 2, and 4 with the fourth order of "
              "a rod's energy; the next order, h^2 higher, leaves less than 0.02")
          .by(Oracle::closed_form),
      draft_of(entry, "c3_semi_tangential/limit")
          .measured((power * fine - coarse) / (power - 1) / rod.critical - 1)
          .in("of the rod's moment")
          .equal(0, 1e-5, "once that order is removed: the next one, 0.1 to 7 times 32^-4")
          .by(Oracle::independent, 1e-12)};
}

/// How much of unit loads on the tip is not K times the motion that they make: the same chain solved again
/// under a little more and a little less.
Measurement against_solutions(const chain::Chain& c, const chain::EndLoads& loads, const Mat6& K) {
  constexpr double kLittle = 3e-5;
  Measurement worst;
  for (int k = 0; k < 6; ++k) {
    const auto tip = [&](double by) {
      chain::EndLoads more = loads;
      (k < 3 ? more.force : more.moment)[k % 3] += by;
      const chain::Solution found = chain::solve(c, more);
      const double solved = found.converged ? 1 : std::nan("");
      const Pose<double> last = chain::pose(found.nodes.back());
      return Pose<double>{solved * last.x, last.R};
    };
    const Pose<double> more = tip(kLittle), less = tip(-kLittle);
    Eigen::Matrix<double, 6, 1> motion;
    motion << more.x - less.x, so3::log<double>(more.R * less.R.transpose());
    const Eigen::Matrix<double, 6, 1> load = tapped(Mat6(K)) * motion / (2 * kLittle);
    worst.include(reference::largest_entry<double>(load - Mat6::Identity().col(k)),
                  fmt::format("load {}", k + 1));
  }
  return worst;
}

std::vector<Finding> stiffness(const Entry& entry) {
  const chain::Chain c = generic_chain(entry);
  const chain::EndLoads loads{.force = {-0.5, 0.4, 0.7}, .virial = kDeadForces};
  const chain::Solution found = with_tip(c, loads);
  const Mat6 K = found.converged ? *found.tip_stiffness : Mat6::Constant(std::nan(""));
  const Mat6 seen = tapped(K);
  Draft symmetry = draft_of(entry, "tip_stiffness/symmetry");
  symmetry.measured((seen - seen.transpose()).norm() / seen.norm()).in("relative");
  return {
      draft_of(entry, "tip_stiffness/solutions")
          .measured(against_solutions(c, loads, K))
          .at_most(
              2e-6,
              "what is cubic in loads of 3e-5, some 500 times their square, and 1e-15 of the positions over "
              "them times the stiffness along the chain, 1e4")
          .by(Oracle::independent),
      entry.has_potential(Kind::linear_angular)
          ? symmetry.at_most(1e-11, "the second derivative of an energy; rounding of stiffnesses 1e4 apart")
                .by(Oracle::closed_form)
          : symmetry.reported("the joints have no potential")};
}

}  // namespace

void chain_couples(Checks& checks) {
  for (const Entry* entry : chain_formulations()) {
    checks.push_back({fmt::format("chains/{}/c3_semi_tangential", entry->name), "chains",
                      [entry] { return critical_of_c3(*entry); }});
    checks.push_back({fmt::format("chains/{}/tip_stiffness", entry->name), "chains",
                      [entry] { return stiffness(*entry); }});
  }
}

}  // namespace halfway::verify
