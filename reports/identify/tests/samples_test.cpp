// What the shipped curves say, against numbers that came by another road.
#include "reference/truth/data.hpp"
#include "reports/identify/tests/support.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>

namespace id = halfway::reference::identify;
using halfway::Vec3;
using halfway::reports::Identified;
using namespace halfway::reports::tests;

namespace {

const id::Fit& per_pair(const Identified& what) { return what.found.stage(id::Stage::per_pair).fit; }

/// xi_i = { int C_i (G_k - G_j) + 1/2 int (G_j C_k - G_k C_j) } / (Cb_i (Cb_k - Cb_j)), G = int_0^s C, Cb =
/// G(1): a rod whose compliances C(s) vary in their ratios. By Simpson's rule.
Vec3<double> rod_xi() {
  constexpr int kSteps = 2000;
  const auto C = [](double s) -> Vec3<double> {
    const double u = 1 - s / 2;
    return {std::pow(u, -3), 2 / u, 0.3 * std::pow(u, -3)};
  };
  const auto G = [](double s) -> Vec3<double> {
    const double u = 1 - s / 2, cubed = 1 / (u * u) - 1;
    return {cubed, -4 * std::log(u), 0.3 * cubed};
  };
  Vec3<double> sum = Vec3<double>::Zero();
  for (int n = 0; n <= kSteps; ++n) {
    const double s = double(n) / kSteps, weight = (n == 0 || n == kSteps ? 1 : n % 2 ? 4 : 2) / (3. * kSteps);
    const Vec3<double> c = C(s), g = G(s);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      sum[i] += weight * (c[i] * (g[k] - g[j]) + (g[j] * c[k] - g[k] * c[j]) / 2);
    }
  }
  const Vec3<double> total = G(1);
  for (int i = 0; i < 3; ++i) sum[i] /= total[i] * (total[(i + 2) % 3] - total[(i + 1) % 3]);
  return sum;
}

/// The same of the frustum, neo-Hooke, by perturbation on a mesh of that level.
Vec3<double> frustum_xi(int level) {
  const auto json = halfway::reference::read_data("fe/linear_frustum_top.json");
  for (const auto& run : json.at("result").at("runs")) {
    if (run.at("element") != "hex20" || run.at("level") != level) continue;
    const auto entry = [&](const nlohmann::json& rows, int i, int j) {
      return rows.at(std::size_t(i)).at(std::size_t(j)).get<double>();
    };
    const auto F = [&](int i) { return entry(run.at("compliance"), 3 + i, 3 + i); };
    Vec3<double> out;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const auto& Q = run.at("couplings").at("neo_hooke").at(std::size_t(3 + i));
      out[i] = -2 * entry(Q, 3 + j, 3 + k) / (F(i) * (F(j) - F(k)));
    }
    return out;
  }
  throw std::runtime_error("no run of the sample's mesh");
}

void check_xi(const Identified& what, const Vec3<double>& expected, double widest = 0.05) {
  const id::Fit& fit = per_pair(what);
  for (int i = 0; i < 3; ++i) {
    const double xi = fit.p[id::kXiAngular + i], half = fit.half_width(id::kXiAngular + i);
    BOOST_TEST_CONTEXT("rotation about axis " << i + 1 << ": " << xi << " +- " << half << ", expected "
                                              << expected[i]) {
      BOOST_TEST(std::abs(xi - expected[i]) <= half);
      BOOST_TEST(half < widest * std::abs(expected[i]));  // else an interval of any width would do
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(samples)

BOOST_AUTO_TEST_CASE(tapered_rod) {
  const Vec3<double> xi = rod_xi();
  BOOST_TEST((xi - Vec3<double>(0.6161, 0.3880, 3.686)).cwiseAbs().maxCoeff() <
             6e-4);  // half of the last digit of 3.686
  const Identified what = identified(sample("tapered_rod.csv"));
  check_xi(what, xi);
  BOOST_TEST(what.found.stage(id::Stage::one_xi).probability < id::kRejected);
  // The energy of an elastic rod has one cubic term.
  BOOST_TEST(what.found.stage(id::Stage::cubic).probability >= id::kRejected);
}

BOOST_AUTO_TEST_CASE(frustum) {
  const Vec3<double> xi = frustum_xi(6);  // of the sample
  BOOST_TEST((xi - Vec3<double>(0.448, 0.557, 1.051)).cwiseAbs().maxCoeff() <
             5e-3);  // the printed ones are of finer meshes
  const Identified what = identified(sample("frustum.csv"));
  check_xi(what, xi);
  BOOST_TEST(what.found.stage(id::Stage::one_xi).probability < id::kRejected);
}

/// The kept couplings themselves: of the finest mesh, as README and the paper's table have them.
BOOST_AUTO_TEST_CASE(kept_results) {
  const Identified what = identified(fe_result("linear_frustum_top.json"), "neo_hooke");
  check_xi(what, frustum_xi(15));
  const Identified block = identified(fe_result("linear_block.json"), "hencky");
  check_xi(block, {0.5, 0.5, 0.5}, 0.1);
}

/// A skew moment alone: two stiffnesses, by which the third and xi cannot be told apart.
BOOST_AUTO_TEST_CASE(one_curve) {
  const Identified what = identified(fe_result("fig_6.json"), "neo_hooke");
  const id::Fit& fit = what.found.chosen_stage().fit;
  BOOST_TEST(what.found.values(fit).angular[0] == 15.5145,
             boost::test_tools::tolerance(2e-3));  // mesh of level 9, 4 degrees
  BOOST_TEST(!fit.is_active(id::kAngularStiffness + 1));
  BOOST_TEST(!per_pair(what).is_active(id::kXiAngular + 1));
}

/// 100 N/mm at rest and 450 at 2 mm: k1 + k3 x^2 through (1 mm, 200 N), (2 mm, 900 N).
BOOST_AUTO_TEST_CASE(property_file) {
  const Identified what = identified(bushing("mount.bus"));
  const id::JointValues v = what.found.values(what.found.chosen_stage().fit);
  BOOST_TEST(v.linear[0] == 350e3 / 3, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(v.linear_cube[0] == 250e9 / 3, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(v.linear[1] == 500e3, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(!what.found.left_open.empty());
}

/// Mirror symmetry leaves no other xi than 1/2, and the joint point in the middle.
BOOST_AUTO_TEST_CASE(block) {
  const Identified what = identified(sample("block.csv"));
  const id::Fit& one = what.found.stage(id::Stage::one_xi).fit;
  BOOST_TEST(std::abs(one.p[id::kXiAngular] - 0.5) <= one.half_width(id::kXiAngular));
  BOOST_TEST(one.half_width(id::kXiAngular) < 0.005);
  BOOST_TEST(what.found.stage(id::Stage::one_xi).probability >= id::kRejected);
  const id::Fit& fit = per_pair(what);
  for (int i = 0; i < 3; ++i) {
    for (const int place : {id::kXiAngular + i, id::kXiLinear + i}) {
      if (fit.is_active(place))
        BOOST_TEST(std::abs(fit.p[place] - 0.5) <= fit.half_width(place), id::name_of(place));
    }
  }
  const id::Fit& shown = what.found.chosen_stage().fit;
  const id::JointValues v = what.found.values(shown);
  for (int i = 0; i < 3; ++i)
    BOOST_TEST(std::abs(v.point[i] - (i == 0 ? -2.5 : 0)) <=
               shown.half_width(id::kJointPoint + i) * what.found.frame.length);
  // Which half-way law it is the data do not tell; that no law at a node will do they do.
  for (const id::CatalogFit& fitted : what.found.catalog) {
    if (fitted.name == "attached_a" || fitted.name == "attached_b")
      BOOST_TEST(fitted.probability < id::kRejected);
    if (fitted.name == "invariant" || fitted.name == "potential")
      BOOST_TEST(fitted.probability >= id::kRejected);
  }
}

BOOST_AUTO_TEST_SUITE_END()
