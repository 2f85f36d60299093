// Exported and imported again, a joint is the same; what a target cannot say is refused by name.
#include "reports/import/export/export.hpp"
#include "reports/import/tests/support.hpp"

#include <boost/test/unit_test.hpp>

#include <random>

namespace halfway::imports::test {
namespace {

/// Stiffness of 17 digits over twelve decades, generic offsets and frames.
class Scenes {
 public:
  reference::Scene next(Kind kind, bool is_coupled) {
    reference::Scene out;
    out.name = "random";
    out.joint.kind = kind;
    const int n = strains_of(kind);
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i) K(i, i) = std::pow(10, 6 * draw());
    for (int i = 1; is_coupled && i < n; ++i)
      K(i, i - 1) = K(i - 1, i) = 0.3 * draw() * std::sqrt(K(i, i) * K(i - 1, i - 1));
    out.joint.law = reference::LinearSpec{K};
    for (auto* end : {&out.joint.a, &out.joint.b}) {
      const Pose<double> pose = pose_at({3 * draw(), draw(), draw()}, {draw(), draw(), draw()});
      *end = {pose.x, pose.R};
    }
    return out;
  }

 private:
  double draw() { return sided_(draws_); }
  std::mt19937 draws_{11};
  std::uniform_real_distribution<double> sided_{-1, 1};
};

ExportRequest request_of(reference::Scene scene, const char* formulation, bool law_only = false) {
  return {std::move(scene), formulation, law_only};
}

/// Comes back as it was; a scene that differs in one digit or by one frame does not.
void check_round_trip(const Target& target, const ExportRequest& request) {
  const Exported exported = target.write(request);
  BOOST_CHECK_NO_THROW(demand_same(request, exported));
  ExportRequest other = request;
  auto& K = std::get<reference::LinearSpec>(other.scene.joint.law).matrix;
  K(0, 0) = std::nextafter(K(0, 0), 1e9);
  BOOST_CHECK_THROW(demand_same(other, exported), std::runtime_error);
  if (request.law_only) return;
  other = request;
  other.scene.joint.b.H = other.scene.joint.b.H * pose_at({1e-13, 0, 0}, {0, 0, 0}).R;
  BOOST_CHECK_THROW(demand_same(other, exported), std::runtime_error);
  other = request;
  other.formulation = "fasse";
  BOOST_CHECK_THROW(demand_same(other, exported), std::runtime_error);
}

const Target& target(const std::string& name) {
  for (const Target& one : targets()) {
    if (one.name == name) return one;
  }
  throw std::runtime_error(name);
}

std::string complaint(const char* to, const ExportRequest& request) {
  try {
    target(to).write(request);
  } catch (const CannotSay& error) {
    return error.what();
  }
  return "nothing was refused";
}

bool says(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

BOOST_AUTO_TEST_SUITE(exports)

BOOST_AUTO_TEST_CASE(round_trips) {
  Scenes scenes;
  for (int i = 0; i < 50; ++i) {
    check_round_trip(target("osim"), request_of(scenes.next(Kind::linear_angular, false), "simbody_xyz"));
    check_round_trip(target("bus"), request_of(scenes.next(Kind::linear_angular, false), "", true));
    for (bool is_coupled : {false, true}) {
      check_round_trip(target("mbdyn"),
                       request_of(scenes.next(Kind::linear_angular, is_coupled), "attached_a"));
      check_round_trip(target("mbdyn"),
                       request_of(scenes.next(Kind::linear_angular, is_coupled), "mbdyn_joint_inv"));
      for (const char* formulation : {"attached_a", "invariant"}) {
        check_round_trip(target("mbdyn"), request_of(scenes.next(Kind::angular, is_coupled), formulation));
        check_round_trip(target("mbdyn"), request_of(scenes.next(Kind::linear, is_coupled), formulation));
      }
    }
  }
}

/// Body-fixed angles at and beside a right angle, where they are not unique.
BOOST_AUTO_TEST_CASE(right_angles) {
  Scenes scenes;
  for (double angle : {std::numbers::pi / 2, -std::numbers::pi / 2, std::numbers::pi / 2 - 1e-9}) {
    reference::Scene scene = scenes.next(Kind::linear_angular, false);
    scene.joint.a.H = pose_at({0.4, 0, 0}, {0, 0, 0}).R * pose_at({0, angle, 0}, {0, 0, 0}).R *
                      pose_at({0, 0, -0.7}, {0, 0, 0}).R;
    const ExportRequest request = request_of(scene, "simbody_xyz");
    BOOST_CHECK_NO_THROW(demand_same(request, osim_of(request)));
  }
}

BOOST_AUTO_TEST_CASE(what_cannot_be_said) {
  Scenes scenes;
  const auto diagonal = scenes.next(Kind::linear_angular, false),
             coupled = scenes.next(Kind::linear_angular, true);
  const auto angular = scenes.next(Kind::angular, false);
  BOOST_TEST(says(complaint("bus", request_of(diagonal, "")), "offsets and frames"));
  BOOST_TEST(says(complaint("bus", request_of(coupled, "", true)), "couples strains 1 and 2"));
  BOOST_TEST(says(complaint("bus", request_of(angular, "", true)), "joint.kind"));
  auto plain = diagonal;
  plain.joint.a = plain.joint.b = {};
  BOOST_TEST(complaint("bus", request_of(plain, "")) == "nothing was refused");
  BOOST_TEST(says(complaint("bus", request_of(plain, "invariant")), "formulation invariant"));
  BOOST_TEST(says(complaint("osim", request_of(diagonal, "invariant")), "not invariant"));
  BOOST_TEST(says(complaint("osim", request_of(diagonal, "")), "what is not said"));
  BOOST_TEST(says(complaint("osim", request_of(coupled, "simbody_xyz")), "couples strains"));
  BOOST_TEST(says(complaint("osim", request_of(angular, "simbody_xyz")), "joint.kind"));
  BOOST_TEST(says(complaint("mbdyn", request_of(diagonal, "invariant")), "mbdyn_joint_inv"));
  BOOST_TEST(says(complaint("mbdyn", request_of(angular, "quaternion")), "--as invariant"));
  auto curved = diagonal;
  curved.joint.law =
      reference::PolynomialSpec{Eigen::VectorXd::Ones(6), Eigen::VectorXd::Ones(6), Eigen::VectorXd::Zero(6)};
  for (const char* to : {"bus", "osim", "mbdyn"})
    BOOST_TEST(says(
        complaint(to, request_of(curved, std::string(to) == "osim" ? "simbody_xyz" : "attached_a", true)),
        "is not linear"));
  auto compliant = diagonal;
  std::get<reference::LinearSpec>(compliant.joint.law).is_compliance = true;
  BOOST_TEST(says(complaint("mbdyn", request_of(compliant, "attached_a")), "compliance"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace halfway::imports::test
