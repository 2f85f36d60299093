// Drake and Chrono as documented, written down here by angles and Eigen alone: loads of the written scenes at
// bodies anywhere, frames turned and moved on both.
#include "reference/record/worst.hpp"
#include "reports/import/tests/support.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <boost/test/unit_test.hpp>

#include <random>

namespace halfway::imports::test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Loads = Eigen::Matrix<double, 12, 1>;

constexpr double kLimit = 1e-12;  // some tens of roundings, also of angles near a right one
constexpr double kSeen = 1e-2;

Matrix3d about(const Vector3d& axis, double angle) { return AngleAxisd(angle, axis).toRotationMatrix(); }
const Vector3d X = Vector3d::UnitX(), Y = Vector3d::UnitY(), Z = Vector3d::UnitZ();

/// A frame in the world.
struct Place {
  Vector3d p;
  Matrix3d R;
};
Place on(const Pose<double>& body, const Place& frame) {
  return {body.x + body.R * frame.p, body.R * frame.R};
}

/// Force at a point and couple on b's side, turned to both nodes with opposite signs.
Loads loads_from(const Pose<double>& a, const Pose<double>& b, const Vector3d& f, const Vector3d& m,
                 const Vector3d& point_a, const Vector3d& point_b) {
  Loads out;
  out << -f, -m - (point_a - a.x).cross(f), f, m + (point_b - b.x).cross(f);
  return out;
}

/// Drake: roll-pitch-yaw torques conjugate to their rates; force in the half-way frame at the middle.
Loads drake(const Pose<double>& a, const Pose<double>& b, const Place& A, const Place& C, const Vector3d& kt,
            const Vector3d& kf) {
  const Matrix3d R = A.R.transpose() * C.R;
  const double pitch = std::asin(-R(2, 0)), roll = std::atan2(R(2, 1), R(2, 2)),
               yaw = std::atan2(R(1, 0), R(0, 0));
  Matrix3d rates;  // the spin of C in A by the rates of roll, pitch, yaw
  rates << about(Z, yaw) * about(Y, pitch) * X, about(Z, yaw) * Y, Z;
  const Vector3d torque = A.R * rates.transpose().inverse() * kt.cwiseProduct(Vector3d(roll, pitch, yaw));
  const AngleAxisd whole(R);
  const Matrix3d half = A.R * AngleAxisd(whole.angle() / 2, whole.axis()).toRotationMatrix();
  const Vector3d force = half * kf.cwiseProduct(half.transpose() * (C.p - A.p));
  const Vector3d middle = (A.p + C.p) / 2;
  return loads_from(a, b, force, torque, middle, middle);
}

/// Chrono: the motion of frame a seen from frame b, its force and couple in b's axes, each body at its own
/// point.
Loads chrono(const Pose<double>& a, const Pose<double>& b, const Place& A, const Place& B, const Vector3d& kf,
             const Vector3d& kt) {
  const AngleAxisd turned(Matrix3d(B.R.transpose() * A.R));
  const Vector3d force = -B.R * kf.cwiseProduct(B.R.transpose() * (A.p - B.p));
  const Vector3d couple = -B.R * kt.cwiseProduct(turned.angle() * turned.axis());
  return loads_from(a, b, force, couple, A.p, B.p);
}

/// Bodies whose relative angle is below one radian, some centimetres apart.
class Bodies {
 public:
  Pose<double> first() { return pose_at(vector(3), vector(1)); }
  Pose<double> second(const Place& joint, const Place& frame) {
    const Matrix3d turned = joint.R * about(vector(1).normalized(), 0.2 + 0.6 * share_(draws_));
    const Matrix3d R = turned * frame.R.transpose();
    return {joint.p + vector(0.1) - R * frame.p, R};
  }

 private:
  Vector3d vector(double size) { return size * Vector3d(sided_(draws_), sided_(draws_), sided_(draws_)); }
  std::mt19937 draws_{7};
  std::uniform_real_distribution<double> sided_{-1, 1}, share_{0, 1};
};

const Place kChassis{{0.1, 0.2, -0.05}, about(Z, 0.5) * about(Y, -0.2) * about(X, 0.3)};

/// Frames of drake.sdf, where the second is given on another frame that is turned by a right angle.
const Place kFlange{{0.02, 0, 0.01}, about(X, std::numbers::pi / 2)};
const Place kEngine{kFlange.p + kFlange.R * Vector3d(-0.03, 0.04, 0), kFlange.R* about(Z, 0.25)};

void check_drake(const std::string& file, const Place& A, const Place& C) {
  const reference::Scene scene = written_scene(only_joint(sample(file)));
  BOOST_TEST(scene.formulations[0] == "drake_rpy");
  Bodies bodies;
  double worst = 0, exchanged = 0, transposed = 0;
  for (int i = 0; i < 20; ++i) {
    const Pose<double> a = bodies.first(), b = bodies.second(on(a, A), C);
    const auto truth = [&](const Place& first, const Place& second) {
      return drake(a, b, on(a, first), on(b, second), {20, 30, 70}, {1000, 2000, 5000});
    };
    const Loads loads = loads_of(scene, a, b);
    reference::keep_largest(worst, load_error(loads, truth(A, C)));
    reference::keep_largest(exchanged, load_error(loads, truth(C, A)));
    reference::keep_largest(transposed, load_error(loads, truth({A.p, A.R.transpose()}, C)));
  }
  BOOST_TEST(worst <= kLimit);
  BOOST_TEST(exchanged > kSeen);
  BOOST_TEST(transposed > kSeen);
}

BOOST_AUTO_TEST_SUITE(documented)

BOOST_AUTO_TEST_CASE(drake_sdf) { check_drake("drake.sdf", kChassis, kEngine); }

BOOST_AUTO_TEST_CASE(drake_urdf) {
  check_drake("drake.urdf", kChassis, {Vector3d::Zero(), Matrix3d::Identity()});
}

/// A frame given relative to another link is found through the model.
BOOST_AUTO_TEST_CASE(drake_through_the_model) {
  std::string text = sample("drake.sdf");
  const std::string direct = "<pose>0.1 0.2 -0.05 0.3 -0.2 0.5</pose>";
  text.replace(text.find(direct), direct.size(),
               "<pose relative_to=\"engine\">0.4 0.1 0.6 0.1 0.2 0.3</pose>");
  const ImportedJoint joint = only_joint(text);
  const Place link{{0.3, -0.1, 0.7}, about(Z, 1.1) * about(Y, -0.4) * about(X, 0.2)};
  const Place frame{{0.4, 0.1, 0.6}, about(Z, 0.3) * about(Y, 0.2) * about(X, 0.1)};
  BOOST_TEST((joint.a.o - link.R.transpose() * (frame.p - link.p)).norm() < 1e-15);
  BOOST_TEST((joint.a.H - link.R.transpose() * frame.R).norm() < 1e-15);
}

BOOST_AUTO_TEST_CASE(chrono_yaml) {
  const reference::Scene scene = written_scene(only_joint(sample("chrono.yaml")));
  BOOST_TEST(scene.formulations[0] == "chrono_body");
  const double degree = std::numbers::pi / 180;
  const Pose<double> chassis{{0.5, 0, 0.2},
                             about(Z, 30 * degree) * about(Y, -20 * degree) * about(X, 10 * degree)};
  const Pose<double> arm{{0.7, 0.4, 0.1}, about(Y, std::numbers::pi / 4)};
  // Where the file puts the bodies nothing is strained.
  BOOST_TEST(loads_of(scene, chassis, arm).norm() < 1e-10);

  // Axes of the joint in the world: z is the hinge's, and the law the same about it.
  const Vector3d z = Vector3d(1, 2, 0.5).normalized(), x = Vector3d(0, 1, 0).cross(z).normalized();
  Matrix3d H;
  H << x, z.cross(x), z;
  const Vector3d at(0.6, 0.3, 0.15);
  const auto fixed_on = [&](const Pose<double>& body) {
    return Place{body.R.transpose() * (at - body.x), body.R.transpose() * H};
  };
  const Place A = fixed_on(chassis), B = fixed_on(arm);
  Bodies bodies;
  double worst = 0, exchanged = 0, all_stiff = 0;
  for (int i = 0; i < 20; ++i) {
    const Pose<double> a = bodies.first(), b = bodies.second(on(a, A), B);
    const auto truth = [&](const Place& first, const Place& second, double about_z) {
      return chrono(a, b, on(a, first), on(b, second), Vector3d::Constant(7e4), {1e3, 1e3, about_z});
    };
    const Loads loads = loads_of(scene, a, b);
    reference::keep_largest(worst, load_error(loads, truth(A, B, 50)));
    reference::keep_largest(exchanged, load_error(loads, truth(B, A, 50)));
    reference::keep_largest(all_stiff, load_error(loads, truth(A, B, 1e3)));
  }
  BOOST_TEST(worst <= kLimit);
  BOOST_TEST(exchanged > kSeen);
  BOOST_TEST(all_stiff > kSeen);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace halfway::imports::test
