// eval against MBDyn's loads and tangents at prescribed poses.
#include "reference/record/worst.hpp"
#include "reports/tests/eval_support.hpp"

#include <fmt/format.h>
#include <boost/test/unit_test.hpp>

#include <fstream>

using namespace halfway;
using namespace halfway::reports::test;
using nlohmann::json;

namespace {

struct Peer {
  const char* type;  // MBDyn's element
  const char* formulation;
  Kind kind;
  bool has_exact_tangent;  // MBDyn's other tangents are the attached ones, as its provenance says
};

constexpr Peer kPeers[] = {{"att_hinge", "attached_a", Kind::angular, true},
                           {"inv_hinge", "invariant", Kind::angular, true},
                           {"att_disp", "attached_a", Kind::linear, true},
                           {"inv_disp", "invariant", Kind::linear, false},
                           {"att_joint", "attached_a", Kind::linear_angular, true},
                           {"inv_joint", "mbdyn_joint_inv", Kind::linear_angular, false}};

json read_probes() {
  std::ifstream file(HALFWAY_MBDYN_PROBES);
  BOOST_REQUIRE_MESSAGE(file, "cannot read " HALFWAY_MBDYN_PROBES);
  return json::parse(file);
}

json request_of(const json& pose, const Peer& peer) {
  const auto node = [&](const char* x, const char* R, const char* o, const char* h) -> json {
    return {{"x", pose.at(x)},
            {"q", quaternion_of(matrix_of(pose.at(R)))},
            {"o", pose.at(o)},
            {"h", quaternion_of(matrix_of(pose.at(h)))}};
  };
  return {{"formulation", peer.formulation},
          {"kind", to_string(peer.kind)},
          {"law", {{"type", "linear"}, {"K", pose.at(peer.kind == Kind::linear_angular ? "K6" : "K3")}}},
          {"a", node("xA", "RA", "oA", "R1h")},
          {"b", node("xB", "RB", "oB", "R2h")},
          {"want", {"loads", "tangent"}}};
}

/// MBDyn's loads act on the nodes: minus ours.
Eigen::VectorXd expected_loads(const json& result) {
  Eigen::VectorXd q(12);
  q << matrix_of(result.at("force_on_node1")), matrix_of(result.at("moment_on_node1")),
      matrix_of(result.at("force_on_node2")), matrix_of(result.at("moment_on_node2"));
  return -q;
}

/// Minus the derivative of minus our loads: ours. A hinge lists moments and rotations only.
Eigen::MatrixXd expected_tangent(const json& result) {
  const Eigen::MatrixXd given = matrix_of(result.at("jacobian"));
  if (given.rows() == 12) return given;
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(12, 12);
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) out.block<3, 3>(6 * i + 3, 6 * j + 3) = given.block<3, 3>(3 * i, 3 * j);
  }
  return out;
}

/// 1e-13 of the largest entry; or, where all loads vanish (pose 0 of the hinges), what a rotation known
/// to 16 eps makes of the stiffness.
double limit(const Eigen::MatrixXd& truth, const Eigen::MatrixXd& K) {
  constexpr double kEps = 2.2e-16;
  using reference::largest_entry;
  return reference::larger(1e-13 * largest_entry<double>(truth), 16 * kEps * largest_entry<double>(K));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(mbdyn)

BOOST_AUTO_TEST_CASE(pose_probes) {
  const json probes = read_probes();
  for (const Peer& peer : kPeers) {
    int compared = 0;
    reference::Measurement loads, tangent;
    for (const json& result : probes.at("results")) {
      if (result.at("type") != peer.type) continue;
      const json& pose = probes.at("poses")[result.at("pose").get<std::size_t>()];
      const json request = request_of(pose, peer);
      const json found = answer(request);
      BOOST_REQUIRE_MESSAGE(!found.contains("error"), found.dump());
      const Eigen::MatrixXd K = matrix_of(request["law"]["K"]);
      const auto error = [&](const json& ours, const Eigen::MatrixXd& truth) {
        return reference::largest_entry<double>(matrix_of(ours) - truth) / limit(truth, K);
      };
      const std::string at = result.at("pose").dump();
      loads.include(error(found["loads"], expected_loads(result)), at);
      if (peer.has_exact_tangent) tangent.include(error(found["tangent"], expected_tangent(result)), at);
      ++compared;
    }
    BOOST_TEST(compared == 12, peer.type << ": compared " << compared << " poses of 12");
    const auto says = [&](const char* what, const reference::Measurement& worst) {
      return fmt::format("{}: {} {:.2g} of the limit at pose {}", peer.type, what, worst.value(),
                         worst.where());
    };
    BOOST_TEST(loads.value() <= 1, says("loads", loads));
    if (peer.has_exact_tangent) BOOST_TEST(tangent.value() <= 1, says("tangent", tangent));
  }
}

BOOST_AUTO_TEST_SUITE_END()
