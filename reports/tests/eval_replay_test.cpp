// What a failing check prints to be replayed: `halfway eval` answers it with the loads of the check's own
// worst case.
#include "reference/record/worst.hpp"
#include "reference/scene/joint/convexity.hpp"
#include "reference/solve/solve.hpp"
#include "reports/tests/eval_support.hpp"
#include "verify/oracle/probes.hpp"
#include "verify/oracle/replay.hpp"

#include <unistd.h>
#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <fstream>

using namespace halfway;
using namespace halfway::reports::test;

namespace {

// Poses travel as quaternions, 17 digits each: some roundings, magnified by laws of a spread of 100 near
// poles.
constexpr double kReplayed = 1e-11;

void check_replay(const reference::Entry& entry, const verify::Probe& probe) {
  const std::string request = verify::eval_request(std::string(entry.name), probe.spec, probe.a, probe.b);
  BOOST_TEST(request.find('\n') == std::string::npos);
  const nlohmann::json found = answer(request);
  BOOST_REQUIRE_MESSAGE(!found.contains("error"), found.dump());
  const auto loads = reference::node_loads<double>(entry, probe.spec, probe.a, probe.b, true);
  const auto held = [&](const char* what, const Eigen::MatrixXd& value, const Eigen::MatrixXd& expected) {
    const double error =
        reference::largest_entry<double>(value - expected) / reference::largest_entry<double>(expected);
    BOOST_TEST(error <= kReplayed, what << " off by " << error);
  };
  held("loads", matrix_of(found["loads"]), loads.q);
  held("tangent", matrix_of(found["tangent"]), loads.tangent);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(replay)

BOOST_AUTO_TEST_CASE(same_loads) {
  for (const auto& entry : reference::formulations()) {
    for (Kind kind : kKinds) {
      for (verify::Probe probe : verify::probes(entry, kind, 3, 1.5)) {
        if (probe.phi > reference::convex_radius(entry, probe.spec)) continue;  // eval refuses
        BOOST_TEST_CONTEXT(entry.name << '/' << to_string(kind)) {
          check_replay(entry, probe);
          auto& law = std::get<reference::LinearSpec>(probe.spec.law);
          law = {law.matrix.inverse(), true};
          law.matrix = (law.matrix + law.matrix.transpose()) / 2;
          check_replay(entry, probe);
          const Eigen::VectorXd k = Eigen::VectorXd::LinSpaced(strain_count(kind), 1, 40);
          probe.spec.law = reference::PolynomialSpec{k, k / 3, k / 7};
          check_replay(entry, probe);
        }
      }
    }
  }
}

/// The scene that a failure prints ends where the failing one did.
BOOST_AUTO_TEST_CASE(same_scenes) {
  const auto file =
      std::filesystem::temp_directory_path() / ("halfway_replay_" + std::to_string(getpid()) + ".toml");
  for (reference::Scene scene : reference::canonical_scenes()) {
    for (const auto& entry : reference::formulations()) {
      scene.points = 2;
      std::ofstream(file) << verify::scene_text(scene, entry, 0.45);
      const auto curve = reference::solve_scene(scene, {&entry, 0.45});
      const auto again = reference::solve_scene(reference::read_scene(file), {&entry, 0.45});
      BOOST_TEST(curve.outcome == again.outcome);
      BOOST_TEST((curve.rows == again.rows), entry.name << " in " << scene.name);
    }
  }
  std::filesystem::remove(file);
}

BOOST_AUTO_TEST_SUITE_END()
