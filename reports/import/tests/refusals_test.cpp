// What is wrong in a file is said with its line, key, value and what is allowed, whatever the file.
#include "reference/scene/text/document.hpp"
#include "reports/import/tests/support.hpp"

#include <boost/test/unit_test.hpp>

#include <string>
#include <vector>

namespace halfway::imports::test {
namespace {

struct Bad {
  const char* sample;  ///< of tests/samples, or nullptr: `put` is the file
  std::string cut, put;
  int line;
  const char* said;
};

std::string text_of(const Bad& bad) {
  if (!bad.sample) return bad.put;
  std::string text = sample(bad.sample);
  const std::size_t at = text.find(bad.cut);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, bad.cut);
  return text.replace(at, bad.cut.size(), bad.put);
}

/// The refusal; fails the test where there is none.
reference::Refusal refused(const std::string& text) {
  try {
    read_joints(text, {});
  } catch (const reference::Refusal& refusal) {
    return refusal;
  }
  return {"", "nothing was refused", "", 0};
}

std::string nested(int levels, const std::string& open, const std::string& close) {
  std::string out, end;
  for (int i = 0; i < levels; ++i) out += open, end += close;
  return out + end;
}

std::vector<Bad> bad_files() {
  return {
      // Kinds.
      {nullptr, "", "", 1, "is empty"},
      {nullptr, "", "hello\nworld\n", 1, "is of no kind known here; allowed: Drake SDF"},
      {nullptr, "",
       std::string("\x7f"
                   "ELF\0\0\1",
                   7),
       1, "is no text"},
      {nullptr, "", "PK\x03\x04 something", 1, "is a Simulink model"},
      {nullptr, "", "Model {\n  Name \"x\"\n}\n", 1, "is a Simulink model"},
      {nullptr, "", "<mujoco>\n<equality><weld body1=\"a\"/></equality></mujoco>", 1, "is MJCF"},
      {nullptr, "", "<html><body/></html>", 1, "the root element = html: is no format known here"},
      {nullptr, "", "import exudyn as exu\nmbs.AddObject(RigidBodySpringDamper())\n", 1,
       "is a program in Python"},
      {nullptr, "", std::string(kLargestFile + 1, 'x'), 1, "is too long; allowed: up to 16 MB"},
      // XML.
      {"drake.sdf", "</sdf>", "", 28, "is not XML"},
      {"drake.sdf", "<drake:bushing_frameA>", "<drake:bushing_frame>", 20, "is not XML"},
      {nullptr, "", "<sdf>" + nested(100, "<a>", "</a>") + "</sdf>", 1, "is nested deeper than 64 levels"},
      {"drake.sdf", "20 30 70", "20 30", 22,
       "drake:bushing_torque_stiffness = 20 30: has 2 numbers; allowed: 3 numbers"},
      {"drake.sdf", "20 30 70", "20 30 70 80", 22, "has more numbers"},
      {"drake.sdf", "20 30 70", "20 nan 70", 22, "= nan: is not finite"},
      {"drake.sdf", "20 30 70", "20 1e400 70", 22, "= 1e400: is not finite"},
      {"drake.sdf", "20 30 70", "20 3O 70", 22, "= 3O: is no number"},
      {"drake.sdf", "20 30 70", "20 -30 70", 22, "negative stiffness -30; allowed: numbers >= 0"},
      {"drake.sdf", "<drake:bushing_torque_damping>0.4 0.5 0.6</drake:bushing_torque_damping>", "", 19,
       "drake:bushing_torque_damping = nothing: is missing"},
      {"drake.sdf", ">mount_engine</", ">nowhere</", 21, "which is no link or frame of its model"},
      {"drake.sdf", "attached_to=\"chassis\"", "attached_to=\"mount_chassis\"", 20, "circle"},
      {"drake.sdf", "relative_to=\"flange\"", "relative_to=\"mount_engine\"", 21, "circle"},
      {"drake.sdf", "drake:linear_bushing_rpy>\n  </model>",
       "drake:linear_bushing_rpy>\n<drake:linear_bushing_rpy/>\n  </model>", 27, "is missing"},
      {nullptr, "", "<sdf><model name='x'/></sdf>", 1, "has no bushing"},
      {"drake.urdf", "name=\"engine\"/>\n    <drake:bushing_torque",
       "name=\"motor\"/>\n    <drake:bushing_torque", 8, "is no frame or link of the robot"},
      {"drake.urdf", "value=\"7 8 9\"", "", 12, "@value = nothing: is missing"},
      {"opensim_old.osim", "<body_2>lumbar2</body_2>", "", 6, "BushingForce/body_2 = nothing: is missing"},
      {"opensim_old.osim", "<body_1>", "<body_1>x</body_1><body_1>", 8, "stands twice, also in line 8"},
      {"opensim_new.osim", "<socket_frame1>lumbar1_offset", "<socket_frame1>elsewhere", 26,
       "which is no offset frame or body"},
      {"opensim_new.osim", "<socket_parent>/bodyset/lumbar1", "<socket_parent>lumbar1_offset", 26, "circle"},
      {nullptr, "", "<OpenSimDocument><ExpressionBasedBushingForce name=\"e\"/></OpenSimDocument>", 1,
       "is a law of functions"},
      // JSON and YAML.
      {"chrono.json", "\"Stiffness Linear\": 7e7", "\"Stiffness Linear\": -7e7", 15,
       "Stiffness Linear = -70000000: is a negative stiffness"},
      {"chrono.json", "\"Stiffness Linear\": 7e7,", "", 14, "Stiffness Linear = nothing: is missing"},
      {"chrono.json", "7e7", "\"stiff\"", 15, "is a text"},
      {"chrono.json", "7e7", "7e777", 15, "a number = 7e777: is too large for double precision"},
      {"chrono.json", "\"Damping Linear\"", "\"Stiffness Linear\"", 26, "stands twice in one object"},
      {"chrono.json", "Revolute", "Prismatic", 8,
       "Type = Prismatic: has no bushing in Chrono; allowed: LOCK"},
      {"chrono.json", "\"Type\": \"Revolute\",", "", 14, "--joint lock, revolute"},
      {"chrono.json", "  ]\n}", "", 28, "is not JSON"},
      {nullptr, "", "{\"a\": " + nested(100, "[", "]") + "}", 1, "nested deeper than 32 levels"},
      {"chrono.yaml", "body1: chassis", "body1: nobody", 20, "body1 = nobody: is no body of the file"},
      {"chrono.yaml", "stiffness_linear: 7e4", "stiffness_linear: .inf", 25, "is a text"},
      {"chrono.yaml", "axis: [1, 2, 0.5]", "axis: [0, 0, 0]", 23, "is no direction"},
      {"chrono.yaml", "axis: [1, 2, 0.5]", "axis: *there", 23, "is not YAML"},
      {"chrono.yaml", "axis: [1, 2, 0.5]", "axis: [1, 2", 24, "is not YAML"},
      {"chrono.yaml", "orientation: [30, -20, 10]", "orientation: [30, -20]", 10, "is no rotation"},
      {"chrono.yaml", "name: front_bushing", "title: front_bushing", 18, "name = nothing: is missing"},
      // MBDyn.
      {"mbdyn.mbd", "2*KT", "2*KX", 9, "has the name 'KX', which was not set before"},
      {"mbdyn.mbd", "2*KT", "2*(KT", 9, "is no number or expression"},
      {"mbdyn.mbd", "2*KT", "KT/0", 9, "is not finite"},
      {"mbdyn.mbd", "2*KT", nested(100, "(", ")"), 9, "is nested too deep"},
      {"mbdyn.mbd", "linear viscoelastic generic", "cubic elastic generic", 9,
       "constitutive law = cubic elastic generic: is not read"},
      {"mbdyn.mbd", "sym, 20., 1., 0., 30., -2., 70.", "sym, 20., 1., 0., 30., -2.", 14,
       "ends the statement where a number is missing"},
      {"mbdyn.mbd", "reference, node, null", "reference, other node, null", 8,
       "reference = other node: is another frame"},
      {"mbdyn.mbd", "1, 0.8, 0.6, 0., 2, -0.6, 0.8, 0.", "1, 0.8, 0.6, 0., 2, 0.8, 0.6, 0.", 7,
       "parallel to the first"},
      {"mbdyn.mbd", "linear elastic, KT", "linear elastic, KT, prestrain, single, 1, 0, 0, const, 1", 16,
       "is a strain that may change in time"},
      {"mbdyn.mbd", "end: elements;", "end: elements", 20,
       "has no end; allowed: a statement that ends with ;"},
      {nullptr, "", "begin: elements;\njoint: 1, clamp, 1, node, node;\nend: elements;\n", 1,
       "has no deformable joint"},
      // Adams.
      {"mount.bus", "'mm'", "'furlong'", 11, "LENGTH = furlong: is no unit known here; allowed: METER"},
      {"mount.bus", " FORCE   =  'newton'\n", "", 10, "FORCE = nothing: is missing in [UNITS]"},
      {"mount.bus", "[TZ_CURVE]\n-10 -1800\n 10  1800\n", "", 1, "[TZ_CURVE] = nothing: is missing"},
      {"mount.bus", "-10 -1800\n", "", 49, "is no curve"},
      {"mount.bus", " 10  4000", " 4  4000", 48, "does not go up"},
      {"mount.bus", " 5  1000", " 5  1000 3", 47, "has more numbers"},
      {"mount.bus", "FILE_TYPE     =  'bus'", "FILE_TYPE = 'tir'", 3,
       "FILE_TYPE = tir: is no bushing's property file"},
      {"mount.bus", "[FY_CURVE]", "[FX_CURVE]", 30, "stands twice, also in line 23"},
      {"mount.bus", "FX_DAMPING = 1.2", "FX_DAMPING = soft", 17, "FX_DAMPING = soft: is no number"},
      {"bushing.adm", ", I = 5", ", I = 55", 14, "I = 55: is no MARKER of the file"},
      {"bushing.adm", ", J = 6\n", "", 13, "J = nothing: is missing in BUSHING/1"},
      {"bushing.adm", "1000, 2000, 5000", "1000, 2000", 17, "has 2 numbers; allowed: 3 numbers"},
      {"bushing.adm", "1000, 2000, 5000", "1000, -2000, 5000", 17, "negative stiffness"},
      {"bushing.adm", "LENGTH = MILLIMETER", "LENGTH = PARSEC", 5, "is no unit known here"},
      {"bushing.adm", "REULER = 30D", "ZP = 30D", 11, "is a way to place a marker that is not read"},
      // Nastran.
      {"bush.bdf", "     20.", "     2x.", 9, "PBUSH K4 = 2x.: is no number"},
      {"bush.bdf", "     20.", "    -20.", 9, "PBUSH K4 = -20.: is a negative stiffness"},
      {"bush.bdf", "CBUSH,101,8", "CBUSH,101,9", 8, "CBUSH PID = 9: is no PBUSH of the file"},
      {"bush.bdf", "CBUSH,101,8,1,2,0.,1.,0.", "CBUSH,101,8,1,2,2.,0.,1.", 8, "gives no axes"},
      {"bush.bdf", "CBUSH,101,8,1,2", "CBUSH,101,8,1,3", 8, "CBUSH GB = 3: is no GRID"},
      {"bush.bdf", "GRID,2,,", "GRID,2,9,", 4, "GRID CP = 9: is another coordinate system"},
      {"bush.bdf", "PBUSH,8,K,1.E3", "PBUSH,8,K,1.E3,,,,,,\n,,K,1.E3", 12,
       "PBUSH flag = K: stands twice in its card"},
      {"bush.bdf", "PBUSH,8,K", "PBUSH,7,K", 11, "PBUSH id = 7: stands twice"},
  };
}

BOOST_AUTO_TEST_SUITE(refusals)

BOOST_AUTO_TEST_CASE(each_names_its_line) {
  const auto all = bad_files();
  BOOST_TEST(all.size() >= 30u);
  for (const Bad& bad : all) {
    const std::string text = text_of(bad);
    BOOST_TEST_CONTEXT((bad.sample ? bad.sample : "a text") << ": " << bad.put.substr(0, 60)) {
      const reference::Refusal refusal = refused(text);
      const std::string said = refusal.what();
      BOOST_TEST_CONTEXT("said: " << said) {
        BOOST_TEST(said.find(bad.said) != std::string::npos);
        BOOST_TEST(refusal.line == bad.line);
        BOOST_TEST(said.size() < 700u);
      }
    }
  }
}

/// Truncated anywhere, a sample is refused or read, and nothing else happens.
BOOST_AUTO_TEST_CASE(truncated_anywhere) {
  int refusals = 0, read = 0;
  for (const char* name : {"drake.sdf", "drake.urdf", "opensim_new.osim", "chrono.yaml", "chrono.json",
                           "mbdyn.mbd", "mount.bus", "bushing.adm", "bush.bdf"}) {
    const std::string text = sample(name);
    for (std::size_t size = 0; size < text.size(); size += 3) {
      try {
        read_joints(text.substr(0, size), {});
        ++read;
      } catch (const reference::Refusal&) {
        ++refusals;
      }
    }
  }
  BOOST_TEST(refusals > read);
  BOOST_TEST(read > 0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace halfway::imports::test
