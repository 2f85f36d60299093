// Simbody's own bushing, run: loads and energy at its poses against simbody_xyz.
#include "reference/truth/data.hpp"
#include "verify/oracle/property.hpp"

#include <fmt/format.h>

namespace halfway::verify {
namespace {

using nlohmann::json;
using Loads50 = Eigen::Matrix<Real50, 12, 1>;

Vec3<double> vector(const json& v) {
  return Vec3<double>(v[0].get<double>(), v[1].get<double>(), v[2].get<double>());
}

Mat3<Real50> rotation(const json& q) {
  const Vec3<Real50> v(Real50(q[1].get<double>()), Real50(q[2].get<double>()), Real50(q[3].get<double>()));
  const Real50 w(q[0].get<double>()), length = sqrt(w * w + v.squaredNorm());
  return so3::matrix<Real50>({w / length, v / length});
}

/// Both nodes at the bodies' poses: frames are products at 50 digits, so that a double's rounding is in none.
struct Bushing {
  JointSpec spec;
  Pose<Real50> a, b;
  explicit Bushing(const json& pose) {
    spec.kind = Kind::linear_angular;
    Eigen::VectorXd k(6);
    k << vector(pose.at("k_trans")), vector(pose.at("k_rot"));
    spec.law = reference::LinearSpec{k.asDiagonal(), false};
    const auto place = [](const json& node, JointEnd<double>& end) {
      const Mat3<Real50> R = rotation(node.at("q")), H = rotation(node.at("h"));
      end.o = vector(node.at("o"));
      end.H = H.cast<double>();
      return Pose<Real50>{vector(node.at("x")).cast<Real50>(), R * H * end.H.cast<Real50>().inverse()};
    };
    a = place(pose.at("a"), spec.a);
    b = place(pose.at("b"), spec.b);
  }
};

std::vector<Finding> against_simbody() {
  const Entry& entry = *reference::find_formulation("simbody_xyz");
  const json data = reference::read_data("programs/simbody.json");
  Measurement loads, energy;
  for (const json& pose : data.at("poses")) {
    const Bushing bushing(pose);
    Eigen::Matrix<double, 12, 1> theirs;
    theirs << vector(pose.at("f_a")), vector(pose.at("m_a")), vector(pose.at("f_b")), vector(pose.at("m_b"));
    const Loads50 on_bodies = theirs.cast<Real50>();
    const auto ours = reference::node_loads<Real50>(entry, bushing.spec, bushing.a, bushing.b, false).q;
    const std::string at = "pose " + pose.at("id").dump();
    loads.include(loads_apart(-on_bodies, ours), at);
    const auto stored = entry.in_dual50.energy(bushing.spec, reference::cast<Dual50>(bushing.a),
                                               reference::cast<Dual50>(bushing.b));
    energy.include(stored ? std::abs(double(stored->v) / pose.at("energy").get<double>() - 1) : std::nan(""),
                   at);
  }
  const auto held = [](const char* what, const Measurement& worst, const char* why) {
    return finding(fmt::format("programs/simbody/{}", what))
        .of("simbody_xyz", to_string(Kind::linear_angular))
        .about("programs")
        .measured(worst)
        .in("relative")
        .at_most(2e-14, why)
        .by(Oracle::other_program);
  };
  return {held("loads", loads,
               "Simbody 3.7 in double: some forty roundings of rotations and arms, near its gimbal lock "
               "divided by "
               "cos(pitch), 0.34 at the least; known to 1e-14"),
          held("energy", energy, "Simbody 3.7 in double: as the loads")};
}

}  // namespace

void simbody(Checks& checks) { checks.push_back({"programs/simbody", "", against_simbody}); }

}  // namespace halfway::verify
