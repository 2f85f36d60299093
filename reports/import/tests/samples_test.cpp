// What each sample says, worked out by hand: numbers in SI, from which lines, and what was lost.
#include "reports/import/scene/scene_text.hpp"
#include "reports/import/scene/spread.hpp"
#include "reports/import/tests/support.hpp"

#include <Eigen/Geometry>
#include <boost/test/unit_test.hpp>

#include <algorithm>

namespace halfway::imports::test {
namespace {

constexpr double kDegrees = std::numbers::pi / 180;

Eigen::VectorXd six(double x, double y, double z, double rx, double ry, double rz) {
  Eigen::VectorXd out(6);
  out << x, y, z, rx, ry, rz;
  return out;
}

bool has(const std::vector<std::string>& texts, const std::string& part) {
  return std::ranges::any_of(texts,
                             [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

bool has_line(const std::vector<Source>& from, int line, const std::string& key) {
  return std::ranges::any_of(
      from, [&](const Source& at) { return at.line == line && at.key.find(key) != std::string::npos; });
}

double off_diagonal(const Eigen::MatrixXd& K, const Eigen::VectorXd& k) {
  return (K - Eigen::MatrixXd(k.asDiagonal())).cwiseAbs().maxCoeff();
}

BOOST_AUTO_TEST_SUITE(samples)

BOOST_AUTO_TEST_CASE(lines_and_losses) {
  const ImportedJoint joint = only_joint(sample("drake.sdf"));
  BOOST_TEST(joint.line == 19);
  BOOST_TEST(has_line(joint.law_from, 24, "force_stiffness"));
  BOOST_TEST(has_line(joint.law_from, 22, "torque_stiffness"));
  BOOST_TEST(has_line(joint.a_from, 10, "pose"));
  BOOST_TEST(has_line(joint.b_from, 14, "pose"));
  BOOST_TEST(joint.lost.size() == 1u);  // damping of zeros is none
  BOOST_TEST(has(joint.lost, "drake:bushing_torque_damping = 0.4 0.5 0.6 (line 23)"));
  BOOST_TEST(off_diagonal(joint.K, six(1000, 2000, 5000, 20, 30, 70)) == 0);
}

BOOST_AUTO_TEST_CASE(opensim_layouts_agree) {
  const auto both = read_joints(sample("opensim_new.osim"), {});
  const ImportedJoint old = only_joint(sample("opensim_old.osim"));
  BOOST_TEST(both.size() == 2u);
  BOOST_TEST(both[0].name == "L1_L2");
  BOOST_TEST((both[0].K == old.K));
  BOOST_TEST((both[0].a.o == old.a.o));
  BOOST_TEST((both[0].b.H == old.b.H));
  BOOST_TEST((old.a.H != Eigen::Matrix3d::Identity()));
  BOOST_TEST(has(both[0].notes, "ExpressionBasedBushingForce = by_function (line 39)"));
  BOOST_TEST((both[1].a.H == Eigen::Matrix3d::Identity()));
  BOOST_TEST(has_line(old.law_from, 14, "rotational_stiffness"));
}

BOOST_AUTO_TEST_CASE(chrono_joint_types) {
  const ImportedJoint json = only_joint(sample("chrono.json"));
  BOOST_TEST(off_diagonal(json.K, six(7e7, 7e7, 7e7, 1e5, 1e5, 500)) == 0);
  BOOST_TEST(has_line(json.law_from, 23, "Stiffness Rotational"));
  BOOST_TEST(has(json.lost, "Position (line 11)"));
  std::string text = sample("chrono.json");
  const auto typed = [&](const std::string& type) {
    std::string other = text;
    other.replace(other.find("Revolute"), 8, type);
    return only_joint(other).K.diagonal().tail<3>().eval();
  };
  BOOST_TEST((typed("Lock") == Eigen::Vector3d(1e5, 1e5, 1e5)));
  BOOST_TEST((typed("Universal") == Eigen::Vector3d(500, 500, 1e5)));
  BOOST_TEST((typed("Spherical") == Eigen::Vector3d(500, 500, 500)));
  text.replace(text.find("\"Type\""), 6, "\"Kind\"");
  BOOST_TEST(only_joint(text, {.units = {}, .joint_type = "universal"}).K(3, 3) == 500);
}

BOOST_AUTO_TEST_CASE(mbdyn_expressions_and_laws) {
  const auto joints = read_joints(sample("mbdyn.mbd"), {});
  BOOST_TEST(joints.size() == 4u);  // the clamp is none
  BOOST_TEST(off_diagonal(joints[0].K, six(1e3, 2e3, 5e3, 20, 30, 70)) == 0);
  BOOST_TEST(
      (joints[0].a.H - Eigen::AngleAxisd(std::atan2(0.6, 0.8), Eigen::Vector3d::UnitZ()).toRotationMatrix())
          .norm() < 1e-15);
  BOOST_TEST(has(joints[0].lost, "proportional = 0.001 (line 10)"));
  Eigen::Matrix3d K;
  K << 20, 1, 0, 1, 30, -2, 0, -2, 70;
  BOOST_TEST((joints[1].K == K));
  BOOST_TEST((joints[1].b.H - Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()).toRotationMatrix()).norm() <
             1e-15);
  BOOST_TEST((joints[2].kind == Kind::linear));
  BOOST_TEST((joints[2].b.o == Eigen::Vector3d(0.1, 0, 0)));
  BOOST_TEST(joints[3].formulation == "mbdyn_joint_inv");
  const auto in_mm = read_joints(sample("mbdyn.mbd"), {.units = "mm", .joint_type = {}});
  BOOST_TEST((in_mm[0].K.diagonal() - six(1e6, 2e6, 5e6, 0.02, 0.03, 0.07)).norm() < 1e-9);
  BOOST_TEST((in_mm[0].a.o - Eigen::Vector3d(1e-4, 2e-4, -5e-5)).norm() < 1e-18);
}

/// Millimetres, newtons and degrees.
BOOST_AUTO_TEST_CASE(adams_curves) {
  const ImportedJoint joint = only_joint(sample("mount.bus"));
  BOOST_TEST(joint.formulation.empty());
  BOOST_TEST(joint.axes.size() == 6u);
  const auto near = [](double x, double y) { return std::abs(x - y) <= 1e-15 * std::abs(y); };
  const AxisLaw& fx = joint.axes[0];
  BOOST_TEST(fx.x.size() == 5u);
  BOOST_TEST(near(fx.x[1], -1e-3));
  BOOST_TEST(fx.y[1] == -200);
  BOOST_TEST(fx.y[4] == 900);
  BOOST_TEST(joint.axes[1].x.empty());  // three rows on a line
  BOOST_TEST(near(joint.axes[1].stiffness, 5e5));
  BOOST_TEST(near(joint.axes[2].stiffness, 3e5));
  BOOST_TEST(near(joint.axes[3].stiffness, 0.12 / kDegrees));
  const AxisLaw& ty = joint.axes[4];
  BOOST_TEST(near(ty.x[0], -10 * kDegrees));
  BOOST_TEST(near(ty.y[0], -4));
  BOOST_TEST(near(joint.axes[5].stiffness, 0.18 / kDegrees));
  BOOST_TEST(has(joint.lost, "FX_DAMPING = 1.2 (line 17)"));
  // At rest, for the example load and the table of candidates: the slope beside zero.
  BOOST_TEST(near(stiffness_at_rest(joint)(0, 0), 2e5));
  BOOST_TEST(std::abs(stiffness_at_rest(joint)(4, 4) - 0.2 / kDegrees) < 1e-12);
}

BOOST_AUTO_TEST_CASE(adams_straight_lines) {
  const ImportedJoint joint = only_joint(sample("straight.bus"));
  BOOST_TEST(joint.axes.empty());
  const reference::Scene scene = written_scene(joint, "field_a");
  // Pulled by 1 mm along x; turned by 20 degrees about it: 200 N, 2400 N mm.
  const Pose<double> a = pose_at({1, 0, 0}, {0, 0, 0});
  const Pose<double> rest{a.x, a.R};
  Pose<double> pulled = rest, turned = rest;
  pulled.x += a.R * Eigen::Vector3d(1e-3, 0, 0);
  turned.R = a.R * Eigen::AngleAxisd(20 * kDegrees, Eigen::Vector3d::UnitX()).toRotationMatrix();
  BOOST_TEST((loads_of(scene, a, pulled).segment<3>(6) - a.R * Eigen::Vector3d(200, 0, 0)).norm() < 1e-10);
  BOOST_TEST((loads_of(scene, a, turned).segment<3>(9) - a.R * Eigen::Vector3d(2.4, 0, 0)).norm() < 1e-12);
}

BOOST_AUTO_TEST_CASE(adams_solver) {
  const ImportedJoint joint = only_joint(sample("bushing.adm"));
  BOOST_TEST((joint.K.diagonal() - six(1e6, 2e6, 5e6, 20, 30, 70)).norm() < 1e-9);
  const auto z = Eigen::Vector3d::UnitZ(), x = Eigen::Vector3d::UnitX();
  const auto euler = [&](double first, double second, double third) {
    return Eigen::Matrix3d(Eigen::AngleAxisd(first, z) * Eigen::AngleAxisd(second, x) *
                           Eigen::AngleAxisd(third, z));
  };
  // J is node a, I is node b.
  BOOST_TEST((joint.a.H - euler(0.5, 0.25, 0)).norm() < 1e-15);
  BOOST_TEST((joint.b.H - euler(30 * kDegrees, 45 * kDegrees, -10 * kDegrees)).norm() < 1e-15);
  BOOST_TEST((joint.b.o - Eigen::Vector3d(0.1, 0.05, -0.02)).norm() < 1e-16);
  BOOST_TEST(joint.preload.size() == 0);
  BOOST_TEST(has(joint.lost, "C = 1, 1, 1 (line 16)"));
  const ImportedJoint loaded = only_joint(sample("bushing_force.adm"));
  // 10 N on I along y of J at rest: to hold it there takes -10 N.
  BOOST_TEST((loaded.preload == six(0, -10, 0, 0, 0, 0)));
}

BOOST_AUTO_TEST_CASE(nastran_fields) {
  const auto joints = read_joints(sample("bush.bdf"), {});
  BOOST_TEST(joints.size() == 2u);
  for (const auto& joint : joints) BOOST_TEST(off_diagonal(joint.K, six(1e3, 2e3, 5e3, 20, 30, 70)) == 0);
  BOOST_TEST((joints[0].a.o == Eigen::Vector3d(0.1, 0, 0.05)));
  BOOST_TEST((joints[0].b.o == Eigen::Vector3d(-0.1, 0, -0.05)));
  // CORD2R: z along (.6, 0, .8), x towards (.8, 0, -.6).
  BOOST_TEST((joints[0].a.H.col(2) - Eigen::Vector3d(0.6, 0, 0.8)).norm() < 1e-15);
  BOOST_TEST((joints[0].a.H.col(0) - Eigen::Vector3d(0.8, 0, -0.6)).norm() < 1e-15);
  // x from GA to GB, y in the plane of the vector.
  BOOST_TEST((joints[1].a.H.col(0) - Eigen::Vector3d(2, 0, 1).normalized()).norm() < 1e-15);
  BOOST_TEST((joints[1].a.H.col(1) - Eigen::Vector3d(0, 1, 0)).norm() < 1e-15);
  BOOST_TEST(has(joints[0].lost, "PBUSH B = 1., 2., -, -, -, - (line 10)"));
}

/// Nothing of a file reaches the scene as a command of TOML, and the example load is small.
BOOST_AUTO_TEST_CASE(scenes_are_read_back) {
  ImportedJoint joint = only_joint(sample("opensim_old.osim"));
  joint.name = "a\"\\\n\x1b[31m#]='";
  joint.lost = {"x\ny = 1"};
  joint.K(0, 0) = 9238795325112868.0;  // an integer beyond 2^53
  const reference::Scene scene = written_scene(joint);
  BOOST_TEST((scene.joint.a.o == joint.a.o));
  BOOST_TEST((std::get<reference::LinearSpec>(scene.joint.law).matrix == joint.K));
  BOOST_TEST((scene.joint.a.H - joint.a.H).norm() < 1e-15);
  BOOST_TEST(scene.loads[0].value.norm() < 0.1001 * 20);
  BOOST_TEST(scene.loads[0].value.norm() > 0.05 * 20);
}

BOOST_AUTO_TEST_CASE(table_of_candidates) {
  const std::string table = spread_table(only_joint(sample("bushing.adm")));
  for (const auto name : candidates()) BOOST_TEST(table.find(std::string(name)) != std::string::npos);
  BOOST_TEST(table.find("45 deg") != std::string::npos);
  BOOST_TEST(table.find("intrinsic ") !=
             std::string::npos);  // exudyn_intrinsic; intrinsic itself needs a value
  BOOST_TEST(table.find("\n  intrinsic") == std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace halfway::imports::test
