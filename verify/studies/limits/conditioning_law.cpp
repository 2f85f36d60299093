// Stiffnesses far apart, singular and indefinite.
#include "reference/face/instantiations.hpp"
#include "reference/scene/joint/convexity.hpp"
#include "reference/solve/path.hpp"
#include "verify/studies/limits/conditioning.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <limits>

namespace halfway::reference {
namespace {

constexpr double kAngle = 0.3;  ///< rad

JointSpec joint_of(const Entry& entry, const Mat3<double>& K) {
  JointSpec spec;
  spec.kind = Kind::angular;
  spec.xi = entry.probe_xi;
  spec.law = LinearSpec{K, false};
  return spec;
}

/// Of the loads at a generic rotation of 0.3 rad, from the same matrices on both sides.
double loads_error(const Entry& entry, const JointSpec& spec) {
  Pose<double> a, b;
  a.R = so3::exp<double>(Vec3<double>(0.3, -0.8, 0.5));
  b.R = a.R * so3::exp<double>(kAngle * Vec3<double>(2, 3, 6) / 7);
  const Vec3<Real50> exact = entry.in_real50.angular(spec, cast<Real50>(a), cast<Real50>(b), false).m_b;
  const Vec3<double> m = entry.in_double.angular(spec, a, b, false).m_b;
  return double(Real50((m.cast<Real50>() - exact).norm() / exact.norm()));
}

/// A moment that turns the softest axis by 0.3 rad, with half as much across it.
Scene soft_scene(const JointSpec& spec, bool rotated) {
  Vec3<double> axis(1, 0.5, 0.5);
  if (rotated) axis = so3::exp<double>(Vec3<double>(0.7, -0.4, 0.9)) * axis;
  Scene s;
  s.name = "stiffness_ratio";
  s.joint = spec;
  s.loads = {{LoadType::fixed_moment, kAngle * axis}};
  return s;
}

/// The double solution against the one that Newton at 50 digits finds from it.
ErrorRow solve_error(const Entry& entry, const Scene& scene, ErrorRow row) {
  constexpr double kNoise = 8 * std::numeric_limits<double>::epsilon();  // of the stiffest moment
  const double ratio = row.x;
  Path<double> path(scene, entry, scene.joint.xi);
  const auto& state = path.advance(1);
  // An answer that says that it has fewer digits is one: how many, is measured here.
  if (!is_equilibrium(state.status)) {
    row.error = std::nan("");
    row.note = state.status == Status::singular_tangent ? "singular tangent" : "no convergence";
    return row;
  }
  if (!(state.residual <= kNoise * ratio)) {
    row.note = fmt::format("called converged at a residual of {:.1e}", state.residual);
  }
  const EquilibriumProblem<Real50> problem(scene, entry, scene.joint.xi);
  Pose<Real50> found = cast<Real50>(state.joint);
  found.R = so3::matrix(so3::quaternion(found.R));
  const Outcome<Real50> exact = problem.equilibrium_near(found, Real50(1));
  const Mat3<Real50>& R = exact.joint.R;
  const Vec3<Real50> miss = so3::log<Real50>(R.transpose() * found.R), theta = so3::log(R);
  row.error = exact.status == Status::converged ? double(Real50(miss.norm() / theta.norm())) : std::nan("");
  return row;
}

/// A file in a folder of its own for this process; gone with it.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text)
      : folder_(std::filesystem::temp_directory_path() / fmt::format("halfway_stiffness_{}", getpid())) {
    std::filesystem::create_directories(folder_);
    std::ofstream(path(), std::ios::binary) << text;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  std::filesystem::path path() const { return folder_ / "scene.toml"; }

 private:
  std::filesystem::path folder_;
};

std::string row_text(const Mat3<double>& K, int i) {
  return fmt::format("[{}, {}, {}]", K(i, 0), K(i, 1), K(i, 2));
}

}  // namespace

ErrorRows errors_over_ratio(const Entry& entry) {
  ErrorRows rows;
  for (const bool rotated : {false, true}) {
    const std::string series = rotated ? "ratio_rotated" : "ratio_diagonal";
    for (int decade = 0; decade <= 8; ++decade) {
      const double ratio = std::pow(10., decade);
      const JointSpec spec = joint_of(entry, spread_stiffness(ratio, rotated));
      if (kAngle > convex_radius(entry, spec)) continue;  // refused there
      const std::string name(entry.name);
      rows.push_back({series + "/loads", name, ratio, loads_error(entry, spec)});
      rows.push_back(solve_error(entry, soft_scene(spec, rotated), {series + "/solve", name, ratio}));
    }
  }
  return rows;
}

ErrorRows errors_at_bad_stiffness(const Entry& entry) {
  ErrorRows rows;
  for (const double smallest : {1e-14, 0., -1.}) {
    const Mat3<double> K = Vec3<double>(smallest, 1, 2).asDiagonal();
    if (kAngle > convex_radius(entry, joint_of(entry, K))) continue;  // refused there
    rows.push_back(
        {"singular/loads", std::string(entry.name), smallest, loads_error(entry, joint_of(entry, K))});
  }
  return rows;
}

std::string scene_refusal(const Mat3<double>& K) {
  const TemporaryFile file(
      fmt::format("title = \"stiffness\"\n[joint]\nkind = \"angular\"\n[joint.law]\ntype = \"linear\"\n"
                  "stiffness = [{}, {}, {}]\n[[load]]\ntype = \"fixed_moment\"\nvalue = [0, 0, 1]\n"
                  "[path]\nfactor_end = 1\n",
                  row_text(K, 0), row_text(K, 1), row_text(K, 2)));
  try {
    read_scene(file.path());
  } catch (const SceneError& error) {
    const std::string message = error.what(), place = file.path().string() + ":";
    return message.starts_with(place) ? message.substr(place.size()) : message;
  }
  return "";
}

}  // namespace halfway::reference
