// Files written after what programs were given, imported, and the loads of the written scenes against what
// those programs answered (reference/data): frames and offsets on both bodies, all axes apart.
#include "reference/record/worst.hpp"
#include "reports/import/tests/support.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace halfway::imports::test {
namespace {

using nlohmann::json;

/// The data are good to 1e-14; angles and products of frames add some tens of roundings.
constexpr double kLimit = 1e-12;
/// What a wrong reading is off by at least: its terms are of the size of the loads.
constexpr double kSeen = 1e-2;

json data_of(const char* file) {
  return json::parse(reports::read_file(std::filesystem::path(HALFWAY_DATA_FOLDER) / file));
}

Eigen::VectorXd vector_of(const json& values) {
  Eigen::VectorXd out(Eigen::Index(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) out[Eigen::Index(i)] = values[i];
  return out;
}

Eigen::MatrixXd matrix_of(const json& rows) {
  Eigen::MatrixXd out(Eigen::Index(rows.size()), Eigen::Index(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) out.row(Eigen::Index(i)) = vector_of(rows[i]).transpose();
  return out;
}

Mat3<double> rotation_of(const json& q) {
  const Eigen::Vector4d v = vector_of(q);
  return so3::matrix<double>({v[0], v.tail<3>()});
}

/// Body-fixed x-y-z angles by the entries of a quaternion's matrix.
Eigen::Vector3d xyz_angles(const json& quaternion) {
  const Eigen::Vector4d q = vector_of(quaternion);
  return {std::atan2(2 * (q[0] * q[1] - q[2] * q[3]), 1 - 2 * (q[1] * q[1] + q[2] * q[2])),
          std::asin(2 * (q[1] * q[3] + q[0] * q[2])),
          std::atan2(2 * (q[0] * q[3] - q[1] * q[2]), 1 - 2 * (q[2] * q[2] + q[3] * q[3]))};
}

std::string osim_old(const json& pose) {
  const auto& a = pose["a"];
  const auto& b = pose["b"];
  return fmt::format(
      "<OpenSimDocument Version=\"30000\"><BushingForce name=\"x\"><body_1>a</body_1><body_2>b</body_2>"
      "<location_body_1>{}</location_body_1><orientation_body_1>{}</orientation_body_1>"
      "<location_body_2>{}</location_body_2><orientation_body_2>{}</orientation_body_2>"
      "<rotational_stiffness>{}</rotational_stiffness><translational_stiffness>{}</translational_stiffness>"
      "</BushingForce></OpenSimDocument>",
      words(vector_of(a["o"]), " "), words(xyz_angles(a["h"]), " "), words(vector_of(b["o"]), " "),
      words(xyz_angles(b["h"]), " "), words(vector_of(pose["k_rot"]), " "),
      words(vector_of(pose["k_trans"]), " "));
}

/// The same in today's layout, frame 2 in two steps: moved, then turned.
std::string osim_new(const json& pose) {
  const auto& a = pose["a"];
  const auto& b = pose["b"];
  return fmt::format(
      "<OpenSimDocument Version=\"40500\"><Body name=\"a\"/><Body name=\"b\"/>"
      "<PhysicalOffsetFrame "
      "name=\"moved\"><socket_parent>/bodyset/b</socket_parent><translation>{}</translation>"
      "</PhysicalOffsetFrame><BushingForce name=\"x\"><frames>"
      "<PhysicalOffsetFrame "
      "name=\"first\"><socket_parent>/bodyset/a</socket_parent><translation>{}</translation>"
      "<orientation>{}</orientation></PhysicalOffsetFrame>"
      "<PhysicalOffsetFrame "
      "name=\"second\"><socket_parent>/moved</socket_parent><orientation>{}</orientation>"
      "</PhysicalOffsetFrame></frames><socket_frame1>first</socket_frame1><socket_frame2>second</"
      "socket_frame2>"
      "<rotational_stiffness>{}</rotational_stiffness><translational_stiffness>{}</translational_stiffness>"
      "</BushingForce></OpenSimDocument>",
      words(vector_of(b["o"]), " "), words(vector_of(a["o"]), " "), words(xyz_angles(a["h"]), " "),
      words(xyz_angles(b["h"]), " "), words(vector_of(pose["k_rot"]), " "),
      words(vector_of(pose["k_trans"]), " "));
}

/// Loads of the data act on the bodies: the opposite of ours.
Eigen::Matrix<double, 12, 1> simbody_loads(const json& pose) {
  Eigen::Matrix<double, 12, 1> out;
  out << -vector_of(pose["f_a"]), -vector_of(pose["m_a"]), -vector_of(pose["f_b"]), -vector_of(pose["m_b"]);
  return out;
}

Pose<double> simbody_pose(const json& body) { return {vector_of(body["x"]), rotation_of(body["q"])}; }

/// Readings that are wrong: each has to be seen.
std::vector<ImportedJoint> misread(const ImportedJoint& joint) {
  std::vector<ImportedJoint> out(4, joint);
  std::swap(out[0].a, out[0].b);
  out[1].a.H.transposeInPlace();
  out[2].b.o = -out[2].b.o;
  const auto K = joint.K;
  if (K.rows() == 6) {
    out[3].K << K.bottomRightCorner<3, 3>(), K.bottomLeftCorner<3, 3>(), K.topRightCorner<3, 3>(),
        K.topLeftCorner<3, 3>();
  } else {
    out[3].K = K.reverse();
  }
  return out;
}

BOOST_AUTO_TEST_SUITE(measured)

BOOST_AUTO_TEST_CASE(opensim_is_simbody) {
  const json data = data_of("programs/simbody.json");
  double worst = 0;
  std::array<double, 4> wrong{};
  for (const json& pose : data["poses"]) {
    const Pose<double> a = simbody_pose(pose["a"]), b = simbody_pose(pose["b"]);
    const auto truth = simbody_loads(pose);
    for (const std::string& text : {osim_old(pose), osim_new(pose)}) {
      const ImportedJoint joint = only_joint(text);
      reference::keep_largest(worst, load_error(loads_of(written_scene(joint), a, b), truth));
      const auto twins = misread(joint);
      for (std::size_t i = 0; i < twins.size(); ++i)
        reference::keep_largest(wrong[i], load_error(loads_of(written_scene(twins[i]), a, b), truth));
    }
  }
  BOOST_TEST(data["poses"].size() == 32u);
  BOOST_TEST(worst <= kLimit);
  for (double error : wrong) BOOST_TEST(error > kSeen);
}

/// One of MBDyn's joints at a pose of the probes, as its input file says it.
struct Probe {
  const char* type;
  const char* words;
  const char* formulation;
  bool has_point;
  int n;
};
constexpr Probe kProbes[] = {{"att_hinge", "deformable hinge", "attached_a", false, 3},
                             {"inv_hinge", "invariant deformable hinge", "invariant", false, 3},
                             {"att_disp", "deformable displacement joint", "attached_a", true, 3},
                             {"inv_disp", "invariant deformable displacement joint", "invariant", true, 3},
                             {"att_joint", "deformable joint", "attached_a", true, 6},
                             {"inv_joint", "invariant deformable joint", "mbdyn_joint_inv", true, 6}};

std::string mbdyn_rows(const Eigen::MatrixXd& m) {
  std::string out;
  for (Eigen::Index i = 0; i < m.rows(); ++i) out += (i ? ", " : "") + words(m.row(i).transpose(), ", ");
  return out;
}

std::string mbdyn_upper(const Eigen::MatrixXd& K) {
  std::string out;
  for (Eigen::Index i = 0; i < K.rows(); ++i)
    out += (i ? ", " : "") + words(K.row(i).tail(K.cols() - i).transpose(), ", ");
  return out;
}

std::string mbdyn_text(const Probe& probe, const json& pose) {
  const auto node = [&](int label, const char* o, const char* H) {
    const std::string point =
        probe.has_point ? fmt::format(", position, {}", words(vector_of(pose[o]), ", ")) : "";
    return fmt::format("{}{}, orientation, matr, {}", label, point, mbdyn_rows(matrix_of(pose[H])));
  };
  return fmt::format("joint: 7, {}, {}, {}, linear elastic generic, sym, {};\n", probe.words,
                     node(1, "oA", "R1h"), node(2, "oB", "R2h"),
                     mbdyn_upper(matrix_of(pose[probe.n == 6 ? "K6" : "K3"])));
}

BOOST_AUTO_TEST_CASE(mbdyn) {
  const json data = data_of("mbdyn/pose_probes.json");
  for (const Probe& probe : kProbes) {
    double worst = 0;
    int poses = 0;
    std::array<double, 4> wrong{};
    for (const json& result : data["results"]) {
      if (result["type"] != probe.type) continue;
      ++poses;
      const json& pose = data["poses"][result["pose"].get<std::size_t>()];
      const Pose<double> a{vector_of(pose["xA"]), matrix_of(pose["RA"])};
      const Pose<double> b{vector_of(pose["xB"]), matrix_of(pose["RB"])};
      Eigen::Matrix<double, 12, 1> truth;
      truth << -vector_of(result["force_on_node1"]), -vector_of(result["moment_on_node1"]),
          -vector_of(result["force_on_node2"]), -vector_of(result["moment_on_node2"]);
      const ImportedJoint joint = only_joint(mbdyn_text(probe, pose));
      BOOST_TEST(joint.formulation == probe.formulation);
      reference::keep_largest(worst, load_error(loads_of(written_scene(joint), a, b), truth));
      const auto twins = misread(joint);
      for (std::size_t i = 0; i < twins.size(); ++i)
        reference::keep_largest(wrong[i], load_error(loads_of(written_scene(twins[i]), a, b), truth));
    }
    BOOST_TEST_CONTEXT(probe.type) {
      BOOST_TEST(poses == 12);
      BOOST_TEST(worst <= kLimit);
      for (std::size_t i = 0; i < wrong.size(); ++i) {
        if (i != 2 || probe.has_point) BOOST_TEST(wrong[i] > kSeen);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace halfway::imports::test
