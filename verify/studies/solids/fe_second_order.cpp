// Second-order couplings of the solids, computed live on coarse meshes: symmetry, swap, Newton, theory.
#include "reference/truth/coupling_fit.hpp"
#include "reference/truth/second_order.hpp"
#include "verify/oracle/fe_access.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/worst.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace halfway::verify {
namespace {

namespace fe = reference::fe;

constexpr int kCoarse = 4;
constexpr std::array<std::array<int, 2>, 3> kPairs = {{{0, 2}, {1, 2}, {0, 1}}};

const fe::MeshRun& coarse(const std::string& name) {
  static std::map<std::pair<Tap, std::string>, fe::MeshRun> runs;
  const std::pair key{passing(), name};
  const auto found = runs.find(key);
  if (found != runs.end()) return found->second;
  const fe::Body& body = fe::body_named(name);
  fe::MeshRun run = characterise(body, joint_point(body), fe::ElementKind::hex20, kCoarse);
  run.result = tapped(run.result);
  return runs.emplace(key, std::move(run)).first->second;
}

/// Mirror symmetry between the ends leaves no other value than 1/2, for any law and any mesh that has it.
std::vector<Finding> symmetric_body() {
  std::vector<Finding> out;
  for (fe::SolidLaw law : fe::kLaws) {
    for (const auto& [i, j] : kPairs) {
      const fe::SecondOrder& s = coarse("block").result;
      const std::string pair = fmt::format("{}{}/{}", i + 1, j + 1, to_string(law));
      const char* reason = "exact by symmetry; rounding grows with the solver's condition, some 1e4 eps";
      out.push_back(solid_finding("block/xi_moments/" + pair)
                        .measured(xi_of_moments(s, law, i, j))
                        .equal(0.5, 1e-9, reason)
                        .by(Oracle::closed_form));
      out.push_back(solid_finding("block/xi_forces/" + pair)
                        .measured(xi_of_forces(s, law, i, j))
                        .equal(0.5, 1e-9, reason)
                        .by(Oracle::closed_form));
    }
  }
  return out;
}

/// Exchanging the clamped and the free face exchanges the nodes: xi becomes 1 - xi, on mirrored meshes
/// exactly.
std::vector<Finding> exchanged_faces() {
  std::vector<Finding> out;
  for (fe::SolidLaw law : fe::kLaws) {
    for (const auto& [i, j] : kPairs) {
      const double sum = xi_of_moments(coarse("frustum_top").result, law, i, j) +
                         xi_of_moments(coarse("frustum_base").result, law, i, j);
      out.push_back(
          solid_finding(fmt::format("frustum/exchange/{}{}/{}", i + 1, j + 1, to_string(law)))
              .measured(sum)
              .equal(1, 1e-9, "exact: the same solid seen from its other face; rounding as for the block")
              .by(Oracle::closed_form));
    }
  }
  return out;
}

/// A potential has one third derivative: the couplings of 1-3, 2-3 and 1-2 moments then follow from a
/// half-way law with one cubic term c theta_1 theta_2 theta_3. c from each pair, spread over the largest.
double cubic_spread(const fe::SecondOrder& s, fe::SolidLaw law) {
  const Vec3<double> k = s.compliance.diagonal().tail<3>().cwiseInverse();
  const double c13 = (xi_of_moments(s, law, 0, 2) - 0.5) * (k[0] - k[2]);
  const double c23 = (xi_of_moments(s, law, 1, 2) - 0.5) * (k[2] - k[1]);
  const double c12 = (xi_of_moments(s, law, 0, 1) - 0.5) * (k[1] - k[0]);
  Extent c;
  for (const double one : {c13, c23, c12}) c.include(one);
  return (c.high() - c.low()) / std::abs(c13);
}

std::vector<Finding> cubic_potential() {
  std::vector<Finding> out;
  for (fe::SolidLaw law : fe::kLaws) {
    Draft f = solid_finding(std::string("frustum/cubic_potential/") + to_string(law))
                  .in("relative")
                  .measured(cubic_spread(coarse("frustum_top").result, law));
    if (law == fe::SolidLaw::cauchy_log)
      f.reported(
          "D : ln V for the Cauchy stress has no potential, so no single coefficient serves: measured");
    else
      f.at_most(1e-7,
                "a hyperelastic solid has one cubic coefficient; rounding times the division by xi - 1/2")
          .by(Oracle::independent);
    out.push_back(f);
  }
  return out;
}

/// theta_2 / M^2 of the paper's moment from Newton at two loads, extrapolated: its next order is M^2.
double newton_coefficient(const fe::Solid& solid, fe::SolidLaw law, double M, bool follower = false) {
  fe::Statics statics(solid);
  const double a = std::atan(0.01);
  const auto quotient = [&](double m) {
    const fe::Equilibrium e = statics.solve(
        law, {Vec3<double>::Zero(), {m * std::cos(a), 0, m * std::sin(a)}, follower}, solid.unloaded());
    return e.converged ? tapped(e.theta()[1]) / (m * m) : std::nan("");
  };
  return (4 * quotient(M / 2) - quotient(M)) / 3;
}

std::vector<Finding> newton() {
  std::vector<Finding> out;
  const double a = std::atan(0.01), product = std::sin(a) * std::cos(a);
  for (const auto& [name, M] : {std::pair<const char*, double>{"block", 4}, {"frustum_top", 0.4}}) {
    const fe::Body& body = fe::body_named(name);
    const fe::Solid solid(body.mesh(fe::ElementKind::hex20, kCoarse), body.material,
                          body.face + joint_point(body));
    for (fe::SolidLaw law : fe::kLaws) {
      const double perturbation = 2 * coarse(name).result.couplings[std::size_t(law)][4](3, 5) * product;
      out.push_back(solid_finding(fmt::format("newton/{}/{}", name, to_string(law)))
                        .in("relative to perturbation")
                        .measured(newton_coefficient(solid, law, M) / perturbation)
                        .equal(1, 1e-4,
                               "two loads leave the fourth order of theta, 1e-5; the solver's rounding "
                               "of theta_2 beside theta_1 is 1e-6")
                        .by(Oracle::independent));
      // A moment that turns with the face is m + theta x m to second order: xi becomes xi - 1.
      const double xi = xi_of_moments(coarse(name).result, law, 0, 2);
      out.push_back(solid_finding(fmt::format("newton/follower/{}/{}", name, to_string(law)))
                        .in("relative to perturbation")
                        .measured(newton_coefficient(solid, law, M, true) / perturbation)
                        .equal((xi - 1) / xi, 1e-4, "as for the fixed moment")
                        .by(Oracle::independent));
    }
  }
  return out;
}

/// The lumped couplings from duals against second-order theory: theta_2 of C2 for frame-xi laws.
std::vector<Finding> lumped() {
  std::vector<Finding> out;
  const Vec3<double> F(1.59343e-3, 1.43837e-2, 4.00635e-4), m(3, -5, 20);
  reference::JointSpec spec;
  spec.kind = Kind::linear_angular;
  spec.law = reference::LinearSpec{
      Eigen::VectorXd((Eigen::VectorXd(6) << 0.03, 0.09, 0.13, F).finished()).asDiagonal(), true};
  for (const auto& [name, xi] :
       {std::pair<const char*, double>{"attached_a", 0}, {"invariant", 0.5}, {"attached_b", 1}}) {
    const auto Q = reference::couplings(*reference::find_formulation(name), spec);
    Vec3<double> second;
    for (int k = 0; k < 3; ++k) second[k] = m.dot(Q[std::size_t(3 + k)].bottomRightCorner<3, 3>() * m);
    const Vec3<double> theory = reference::second_order_rotation<double>(F, m, xi, 0) - F.cwiseProduct(m);
    out.push_back(solid_finding(std::string("lumped_couplings/") + name)
                      .in("relative")
                      .measured((second - theory).norm() / (F.cwiseProduct(m).squaredNorm()))
                      .at_most(1e-12, "rounding of doubles")
                      .by(Oracle::closed_form));
  }
  return out;
}

}  // namespace

void fe_second_order(Checks& checks) {
  checks.push_back({"fe/symmetric_body", "fe", symmetric_body});
  checks.push_back({"fe/exchanged_faces", "fe", exchanged_faces});
  checks.push_back({"fe/cubic_potential", "fe", cubic_potential});
  checks.push_back({"fe/newton", "fe", newton});
  checks.push_back({"fe/lumped_couplings", "fe", lumped});
}

}  // namespace halfway::verify
