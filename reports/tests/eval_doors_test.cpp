// One joint through both doors: what a request says and what a scene says is taken or refused alike, in the
// same words.
#include "reference/record/worst.hpp"
#include "reference/scene/scene.hpp"
#include "reports/eval/eval_parse.hpp"
#include "reports/eval/eval_request.hpp"
#include "reports/tests/eval_support.hpp"

#include <unistd.h>
#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <fstream>

using namespace halfway;
using namespace halfway::reports::test;
using nlohmann::json;

namespace {

/// Keys of a joint that both doors have, beside kind and law.
struct Case {
  const char* what;
  const char* law;
  const char* ends;
  const char* refused;  ///< a part of what both say; empty: accepted
  int notes;
  const char* free = "";  ///< what a scene says is free; a request is answered whatever is
};

constexpr const char* kDiagonal = R"({"type":"linear","K":[10,20,30]})";

const Case kCases[] = {
    {"a diagonal", kDiagonal, "{}", "", 0},
    {"stiffness", R"({"type":"linear","stiffness":[[10,1,0],[1,20,2],[0,2,30]]})", "{}", "", 0},
    {"compliance", R"({"type":"linear","compliance":[[0.1,0,0],[0,0.2,0.01],[0,0.01,0.3]]})", "{}", "", 0},
    {"a hinge", R"({"type":"linear","K":[30000,30000,0]})", "{}", "", 0, "rotation about joint axis 3"},
    {"a hinge among curves",
     R"({"type":"per_axis","axis":[{"k1":0},{"negative":1,"positive":2},{"k1":0,"k3":1}]})", "{}", "", 0,
     "rotation about joint axis 1, rotation about joint axis 3 at rest"},
    {"an inverse", R"({"type":"linear","K":[[3,1.0000000000000002,0],[1,3,0],[0,0,1]]})", "{}", "", 1},
    {"polynomial", R"({"type":"polynomial","k1":[0,2,3],"k5":[1,0,0]})", "{}", "", 0,
     "rotation about joint axis 1 at rest"},
    {"offsets", kDiagonal, R"({"offset_a":[1,2,3],"b":{"o":[0.1,0,-2]}})", "", 0},
    {"frames", kDiagonal, R"({"a":{"h":[0.6,0.8,0,0]},"frame_b":[[0,-1,0],[1,0,0],[0,0,1]]})", "", 0},
    {"four digits", kDiagonal, R"({"frame_a":[0.9239,0.3827,0,0]})", "", 1},
    {"six digits", kDiagonal,
     R"({"frame_a":[[-0.0309726,-0.789768,-0.612625],[-0.787144,-0.358463,0.501909],[-0.615993,0.497768,-0.61]]})",
     "", 1},
    {"two digits", kDiagonal, R"({"frame_a":[0.92,0.38,0,0]})", "divide each number by the length", 0},
    {"no rotation", kDiagonal, R"({"frame_b":[0,0,0,0]})", "is the zero quaternion", 0},
    {"a reflection", kDiagonal, R"({"frame_b":[[1,0,0],[0,1,0],[0,0,-1]]})", "is a reflection", 0},
    {"asymmetric", R"({"type":"linear","K":[[3,1.00000001,0],[1,3,0],[0,0,1]]})", "{}", "is not symmetric",
     0},
    {"indefinite", R"({"type":"linear","K":[[1,2,0],[2,1,0],[0,0,1]]})", "{}", "is indefinite", 0},
    {"negative", R"({"type":"linear","K":[100,1,-0.001]})", "{}", "on its diagonal", 0},
    {"two words", R"({"type":"linear","K":[1,1,1],"stiffness":[1,1,1]})", "{}", "stands beside", 0},
    {"preload", R"({"type":"linear","K":[1,1,1],"preload":[1,1,1]})", "{}", "", 0},
    {"damping", R"({"type":"linear","K":[1,1,1],"damping":[1,1,1]})", "{}", "is not a known key;", 0},
    {"offset", R"({"type":"polynomial","k1":[1,1,1],"offset":["2 deg",0,0]})", "{}", "", 0},
    {"curves",
     R"({"type":"per_axis","axis":[{"stiffness":"1 N m/deg"},{"negative":1,"positive":2},{"k1":1,"k3":-1}]})",
     "{}", "", 0},
    {"a table",
     R"({"type":"per_axis","axis":[{"x":[-1,0,2],"y":[-3,0,4],"interpolation":"monotone"},{"k1":1},{"k1":2}]})",
     "{}", "", 1},
    {"a short table", R"({"type":"per_axis","axis":[{"x":[1],"y":[-3]},{"k1":1},{"k1":2}]})", "{}",
     "has 1 points", 0},
    {"units", kDiagonal, R"({"offset_a":["12 mm",0,"0.1 in"],"offset_b":{"values":[1,2,3],"unit":"cm"}})", "",
     0},
    {"a wrong unit", kDiagonal, R"({"offset_a":["12 N",0,0]})", "is in N (N in SI) where m is needed", 0},
    {"an unknown unit", kDiagonal, R"({"offset_a":["12 mn",0,0]})", "which is no unit that is known", 0},
    {"principal axes", R"({"type":"linear","K":[10,20,30],"axes":[0.8,0.6,0,0]})", "{}", "", 0},
    {"axes of curves", R"({"type":"polynomial","k1":[1,1,1],"axes":[1,0,0,0]})", "{}",
     "turn frame_a and frame_b", 0},
    {"measured", R"({"type":"linear","K":[[10,1.1,0],[0.9,20,0],[0,0,5]],"tolerance":0.02})", "{}", "", 1},
    {"badly measured", R"({"type":"linear","K":[[10,1.1,0],[0.9,20,0],[0,0,5]],"tolerance":0.5})", "{}",
     "is out of range", 0},
    {"a short row", R"({"type":"linear","K":[[1,0,0],[0,1],[0,0,1]]})", "{}", "has 2 entries", 0},
};

/// JSON as TOML's inline values.
std::string toml(const json& value) {
  if (!value.is_structured()) return value.dump();
  std::string out;
  for (const auto& [key, item] : value.items())
    out += (out.empty() ? "" : ", ") + (value.is_object() ? key + " = " : "") + toml(item);
  return value.is_object() ? "{ " + out + " }" : "[" + out + "]";
}

struct Read {
  std::string refusal;  ///< without place; empty: accepted
  reference::JointSpec spec{};
  std::vector<std::string> notes{};
};

std::string after(const std::string& text, const std::string& mark) {
  const auto at = text.find(mark);
  return at == std::string::npos ? text : text.substr(at + mark.size());
}

/// A message from its value on: keys begin and indices count differently.
std::string unplaced(const std::string& message) { return after(message, " = "); }

Read by_request(const Case& c) {
  json request = generic_request(*reference::find_formulation("invariant"), Kind::angular);
  request["law"] = json::parse(c.law);
  for (const char* node : {"a", "b"}) request[node].erase("o"), request[node].erase("h");
  request.merge_patch(json::parse(c.ends));
  const std::string text = request.dump();
  auto line = reports::parse_line(text);
  try {
    Read read{"", reports::read_request(line.document).spec};
    read.notes = line.document.notes;
    return read;
  } catch (const reference::Refusal& refusal) {
    return {unplaced(refusal.what())};
  }
}

Read by_scene(const Case& c) {
  json joint = json::parse(c.ends);
  joint["kind"] = "angular";
  joint["law"] = json::parse(c.law);
  const auto file =
      std::filesystem::temp_directory_path() / ("halfway_doors_" + std::to_string(getpid()) + ".toml");
  std::ofstream(file) << "title = \"t\"\njoint = " << toml(joint)
                      << "\n[[load]]\ntype = \"fixed_moment\"\nvalue = [0, 0, 1]\n[path]\nfactor_end = 1\n";
  Read read;
  try {
    const auto scene = reference::read_scene(file);
    read.spec = scene.joint;
    read.notes = scene.notes;
  } catch (const reference::SceneError& error) {
    read.refusal = unplaced(error.what());
  }
  std::filesystem::remove(file);
  return read;
}

bool same_law(const reference::LawSpec& a, const reference::LawSpec& b) {
  const Eigen::Vector3d strain(0.1, -0.2, 0.3);
  return reference::AnyLaw<double, 3>(a)(strain).stress == reference::AnyLaw<double, 3>(b)(strain).stress;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(doors)

BOOST_AUTO_TEST_CASE(one_joint) {
  for (const Case& c : kCases) {
    BOOST_TEST_CONTEXT(c.what) {
      const Read request = by_request(c), scene = by_scene(c);
      // The lists of what is allowed name the one door's other keys too: compared up to there.
      const auto said = [](const std::string& text) { return text.substr(0, text.find("; allowed:")); };
      if (!*c.refused) {
        BOOST_TEST(request.refusal == "");
        BOOST_TEST(scene.refusal == "");
        BOOST_TEST(same_law(request.spec.law, scene.spec.law));
        BOOST_TEST((request.spec.a.o == scene.spec.a.o && request.spec.b.o == scene.spec.b.o));
        BOOST_TEST((request.spec.a.H == scene.spec.a.H && request.spec.b.H == scene.spec.b.H));
        BOOST_TEST(request.notes.size() == std::size_t(c.notes));
        const std::size_t free_notes = *c.free ? 1 : 0;
        BOOST_REQUIRE(scene.notes.size() == std::size_t(c.notes) + free_notes);
        if (*c.free) BOOST_TEST(scene.notes.back().find(c.free) != std::string::npos, scene.notes.back());
        for (const auto* end : {&request.spec.a, &request.spec.b})
          BOOST_TEST(reference::largest_entry<double>(end->H * end->H.transpose() -
                                                      Eigen::Matrix3d::Identity()) <= 1e-15);
      } else {
        BOOST_TEST(request.refusal.find(c.refused) != std::string::npos, request.refusal);
        BOOST_TEST(scene.refusal.find(c.refused) != std::string::npos, scene.refusal);
      }
      if (std::string(c.what) != "asymmetric")  // indices count from 0 here, from 1 there
        BOOST_TEST(said(request.refusal) == said(scene.refusal));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
