#include "reports/import/scene/spread.hpp"

#include "reference/face/registry.hpp"
#include "reference/scene/joint/names.hpp"
#include "reports/import/record/frames.hpp"
#include "reports/import/scene/scene_text.hpp"

#include <fmt/format.h>

namespace halfway::imports {
namespace {

constexpr double kAngles[] = {5, 20, 45};   // degrees
const Vec3<double> kAxis(0.48, 0.6, 0.64);  // of length one, near none of the joint's axes

bool is_candidate(const reference::Entry& entry) { return !entry.needs_xi && !entry.needs_length; }

/// The moment on b where b is turned from the unstrained pose, joint axes.
Vec3<double> moment(const reference::Entry& entry, const reference::JointSpec& spec, double degrees) {
  const Pose<double> a{Vec3<double>::Zero(), Mat3<double>::Identity()};
  const Pose<double> b{Vec3<double>::Zero(), so3::exp<double>(Vec3<double>(degrees * kDegree * kAxis))};
  return entry.in_double.angular(spec, a, b, false).m_b;
}

}  // namespace

std::vector<std::string_view> candidates() {
  std::vector<std::string_view> out;
  for (const auto& entry : reference::formulations()) {
    if (is_candidate(entry)) out.push_back(entry.name);
  }
  return out;
}

std::string spread_table(const ImportedJoint& joint) {
  const auto* invariant = reference::find_formulation("invariant");
  const Eigen::MatrixXd K = stiffness_at_rest(joint);
  if (joint.kind == Kind::linear || K.diagonal().tail<3>().isZero(0) || !invariant) return {};
  reference::JointSpec spec;
  spec.kind = Kind::angular;
  spec.law = reference::LinearSpec{K.bottomRightCorner<3, 3>()};
  std::string out = fmt::format(
      "Moments of the candidates where this joint is turned about its axis ({}, {}, {}), by their difference "
      "from invariant's, %{}:\n"
      "  {:<18}",
      kAxis[0], kAxis[1], kAxis[2], joint.axes.empty() ? "" : " (stiffness at rest)", "--as");
  for (double angle : kAngles) out += fmt::format("{:>9} deg", angle);
  out += fmt::format("\n  {:<18}", "invariant, N m");
  for (double angle : kAngles) out += fmt::format("{:>13.5g}", moment(*invariant, spec, angle).norm());
  for (const auto& entry : reference::formulations()) {
    if (!is_candidate(entry) || !reference::accepts_law(entry, spec)) continue;
    out += fmt::format("\n  {:<18}", entry.name);
    for (double angle : kAngles) {
      const Vec3<double> truth = moment(*invariant, spec, angle);
      out += fmt::format("{:>13.3g}", 100 * (moment(entry, spec, angle) - truth).norm() / truth.norm());
    }
  }
  return out + "\n";
}

}  // namespace halfway::imports
