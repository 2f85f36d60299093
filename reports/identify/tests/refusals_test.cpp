// What a person may bring: wrong files, too few numbers, wrong units, data that cannot tell.
#include "reports/identify/tests/support.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>

namespace id = halfway::reference::identify;
using namespace halfway::reports::tests;

namespace {

constexpr const char* kHead = "m_x [N m],m_y [N m],m_z [N m],theta_x [rad],theta_y [rad],theta_z [rad]\n";

/// Rotations of a diagonal angular joint under moments, with a scatter that no model follows.
std::string rows(const halfway::Vec3<double>& k, const halfway::Vec3<double>& turn, int count) {
  std::string out;
  for (int n = 1; n <= count; ++n) {
    const halfway::Vec3<double> theta = turn * n / count;
    const double wiggle = 1e-4 * std::sin(37. * n);
    out += std::to_string(k[0] * theta[0]) + "," + std::to_string(k[1] * theta[1]) + "," +
           std::to_string(k[2] * theta[2]) + ",";
    out += std::to_string(theta[0] + wiggle) + "," + std::to_string(theta[1] - wiggle) + "," +
           std::to_string(theta[2] + wiggle * wiggle) + "\n";
  }
  return out;
}

std::string reason(const halfway::reports::Identified& what, int place) {
  for (const id::LeftOpen& one : what.found.left_open) {
    if (one.place == place) return one.reason;
  }
  return "";
}

bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_SUITE(refusals)

BOOST_AUTO_TEST_CASE(wrong_files) {
  const std::string good = kHead + rows({10, 20, 40}, {0.1, 0.1, 0}, 8);
  BOOST_TEST(refusal_of(good) == "");
  const std::pair<std::string, const char*> texts[] = {
      {"", "1: the file: has no row of numbers"},
      {"\n\n# nothing\n", "has no row of numbers"},
      {kHead, "has no row of numbers"},
      {"title = \"a scene\"\n", "1: title = \"a scene\": is no head of columns that are known"},
      {"1,2,3\n", "1: 1,2,3: numbers before a head"},
      {"\x7f"
       "ELF\x01\x02,\x03\n",
       "is no head of columns that are known"},
      {"m_x,theta_x [rad]\n1,1\n", "1: m_x: has no unit; allowed: m_x [N m]"},
      {"m_x [N m,theta_x [rad]\n1,1\n", "m_x [N m: its bracket is not closed"},
      {"m_x [N],theta_x [rad]\n1,1\n", "1: m_x [N]: is in N, which is no N m; allowed: a unit such as"},
      {"m_x [N m],theta_x [mm]\n1,1\n", "theta_x [mm]: is in mm, which is no rad"},
      {"m_x [furlong],theta_x [rad]\n1,1\n", "m_x [furlong]"},
      {"m_x [N m],m_x [N m],theta_x [rad]\n1,1,1\n", "1: m_x: stands twice"},
      {"m_x [N m],theta_x [rad]\n1\n", "2: 1: 1 cells below 2 columns"},
      {"m_x [N m],theta_x [rad]\n1,2,3\n", "3 cells below 2 columns"},
      {"m_x [N m],theta_x [rad]\n1,\n", "theta_x = : an empty cell"},
      {"m_x [N m],theta_x [rad]\n1,abc\n", "theta_x = abc: is no finite number"},
      {"m_x [N m],theta_x [rad]\n1,nan\n", "is no finite number"},
      {"m_x [N m],theta_x [rad]\n1,inf\n", "is no finite number"},
      {"m_x [N m],theta_x [rad]\n1,20\n", "2: theta: a rotation of 20 rad"},
      {"# held: theta_q\nm_x [N m],theta_x [rad]\n1,1\n", "1: held = theta_q: is no motion"},
      {"# held: m_x\nm_x [N m],theta_x [rad]\n1,1\n", "held = m_x: is no motion"},
      {"# sigma: u = 3\nm_x [N m],theta_x [rad]\n1,1\n", "sigma: u = 3"},
      {"# sigma: theta = -1 deg\nm_x [N m],theta_x [rad]\n1,1\n", "is not positive"},
      {"{\"a\": 1}", "is JSON, but no result of reference/data/fe"},
      {"{", "is JSON, but no result of reference/data/fe"},
      {"[MDI_HEADER]\n", "1: "},
      {"# sigma: speed = 1 mm\nm_x [N m],theta_x [rad]\n1,1\n", "is no noise"},
  };
  for (const auto& [text, words] : texts) {
    const std::string said = refusal_of(text);
    BOOST_TEST(has(said, words), "'" << text << "' is refused with '" << said << "', not '" << words << "'");
  }
}

BOOST_AUTO_TEST_CASE(too_little) {
  BOOST_TEST(has(refusal_of("m_x [N m],theta_x [rad]\n0,0.1\n0,0.2\n"), "all loads are zero"));
  BOOST_TEST(
      has(refusal_of("m_x [N m],theta_x [rad]\n1,0\n2,0\n"), "all displacements and rotations are zero"));
  BOOST_TEST(has(refusal_of("m_x [N m]\n1\n2\n"), "all displacements and rotations are zero"));
  BOOST_TEST(has(refusal_of("m_x [N m],theta_x [rad]\n1,0.1\n"), "1 measured numbers for 1 unknowns"));
}

BOOST_AUTO_TEST_CASE(material_laws) {
  BOOST_TEST(has(refusal_of(fe_result("fig_6.json")),
                 "has results of several material laws; allowed: --law with one of st_venant, neo_hooke"));
}

/// One case about one axis: that stiffness, and by name what it does not tell.
BOOST_AUTO_TEST_CASE(one_axis) {
  const auto what = identified("m_x [N m],theta_x [deg]\n1,5.73\n2,11.45\n3,17.2\n4,22.91\n");
  const id::Fit& fit = what.found.chosen_stage().fit;
  BOOST_TEST(what.found.values(fit).angular[0] == 10, boost::test_tools::tolerance(0.01));
  BOOST_TEST(has(reason(what, id::kAngularStiffness + 1), "no case turns the joint about it"));
  BOOST_TEST(has(reason(what, id::kXiAngular + 2), "the stiffness about axis 2 is open"));
  BOOST_TEST(!fit.is_active(id::kAngularStiffness + 1));
}

/// A law that stiffens: f = 1.2 u + 0.03 u^3 in kN and mm, and the same data without the cube.
BOOST_AUTO_TEST_CASE(curved_law) {
  for (const double cube : {0.03, 0.}) {
    std::string text = "u_x [mm],f_x [kN]\n";
    for (int n = -10; n <= 10; ++n) {
      const double u = 0.5 * n;
      text += std::to_string(u + 1e-3 * std::sin(41. * n)) + "," +
              std::to_string(1.2 * u + cube * u * u * u) + "\n";
    }
    const auto what = identified(text);
    const bool is_curved = what.found.chosen_stage().stage == id::Stage::axis_laws;
    BOOST_TEST(is_curved == (cube > 0));
    const id::JointValues v = what.found.values(what.found.chosen_stage().fit);
    BOOST_TEST(v.linear[0] == 1.2e6, boost::test_tools::tolerance(2e-3));  // 1e-3 mm of the first 0.5
    if (is_curved) BOOST_TEST(v.linear_cube[0] == 3e10, boost::test_tools::tolerance(5e-3));
    const auto scene = identify_scene(what);
    BOOST_TEST(has(scene, is_curved ? "type = \"polynomial\"" : "type = \"linear\""));
  }
}

BOOST_AUTO_TEST_CASE(isotropic) {
  const auto what = identified(kHead + rows({20, 20, 20}, {0.3, 0.3, 0}, 20) + "\n" + kHead +
                               rows({20, 20, 20}, {0, 0.3, 0.3}, 20) + "\n" + kHead +
                               rows({20, 20, 20}, {0.3, 0, 0.3}, 20));
  for (int i = 0; i < 3; ++i)
    BOOST_TEST(has(reason(what, id::kXiAngular + i), "there xi has no effect"),
               reason(what, id::kXiAngular + i));
}

BOOST_AUTO_TEST_CASE(small_rotations) {
  const halfway::Vec3<double> k(10, 20, 40);
  const auto what =
      identified(kHead + rows(k, {0.003, 0.003, 0}, 20) + "\n" + kHead + rows(k, {0, 0.003, 0.003}, 20) +
                 "\n" + kHead + rows(k, {0.003, 0, 0.003}, 20));
  for (int i = 0; i < 3; ++i)
    BOOST_TEST(has(reason(what, id::kXiAngular + i), "too small beside the noise"),
               reason(what, id::kXiAngular + i));
}

/// Units, separators and names as people have them are one and the same curve.
BOOST_AUTO_TEST_CASE(dialects) {
  const auto angular = [](const std::string& text) {
    const auto what = identified(text);
    return what.found.values(what.found.chosen_stage().fit).angular[0];
  };
  const double expected = angular("m_x [N m],theta_x [rad]\n1,0.1001\n2,0.2\n3,0.2999\n");
  for (const char* text : {"theta_x [mrad],m_x [N mm]\n100.1,1000\n200,2000\n299.9,3000\n",
                           "\xEF\xBB\xBFm_x [N m];theta_x [rad]\r\n1;0,1001\r\n2;0,2\r\n3;0,2999\r\n",
                           "Mx (Nm)\tThetaX (rad)\n1\t0.1001\n2\t0.2\n3\t0.2999\n",
                           "\"time [s]\",\"m_x [N m]\",\"theta_x [rad]\"\n0,1,0.1001\n1,2,0.2\n2,3,0.2999\n"})
    BOOST_TEST(angular(text) == expected, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_SUITE_END()
