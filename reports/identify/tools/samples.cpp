// The curves of reports/identify/samples, computed: solids by 3D finite elements, a tapered rod by
// integration.
#include "halfway/rotations/so3.hpp"
#include "reference/truth/fe/statics.hpp"
#include "reference/truth/fe/studies/bodies.hpp"
#include "reference/truth/rod/rod.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <stdexcept>

namespace {

using halfway::Vec3;
namespace fe = halfway::reference::fe;
namespace rod = halfway::reference::rod;

/// Both ways, so that what is odd in the load does not enter what is even in it.
constexpr double kFactors[] = {-1, -2. / 3, -1. / 3, 1. / 3, 2. / 3, 1};

/// Of the place that is measured: what moved, and the moment about it.
struct Motion {
  Vec3<double> u, theta, moment;
};
using Answer = std::function<Motion(const Vec3<double>& f, const Vec3<double>& m)>;

std::string angular_case(const std::string& name, const Vec3<double>& moment, const Answer& answer) {
  std::string out = fmt::format(
      "# case: {}\nm_x [N m],m_y [N m],m_z [N m],theta_x [rad],theta_y [rad],theta_z [rad]\n", name);
  for (const double factor : kFactors) {
    const Vec3<double> m = factor * moment, theta = answer(Vec3<double>::Zero(), m).theta;
    out += fmt::format("{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g}\n", m[0] + 0., m[1] + 0., m[2] + 0.,
                       theta[0] + 0., theta[1] + 0., theta[2] + 0.);
  }
  return out + "\n";
}

std::string full_case(const std::string& name, const Vec3<double>& force, const Vec3<double>& moment,
                      const Answer& answer) {
  std::string out = fmt::format(
      "# case: {}\nf_x [N],f_y [N],f_z [N],m_x [N m],m_y [N m],m_z [N m],u_x [m],u_y [m],u_z [m],theta_x "
      "[rad],theta_y [rad],theta_z [rad]\n",
      name);
  for (const double factor : kFactors) {
    const Vec3<double> f = factor * force;
    const Motion motion = answer(f, factor * moment);
    std::string row;
    for (const Vec3<double>& v : {f, motion.moment, motion.u, motion.theta})
      row +=
          fmt::format("{}{:.10g},{:.10g},{:.10g}", row.empty() ? "" : ",", v[0] + 0., v[1] + 0., v[2] + 0.);
    out += row + "\n";
  }
  return out + "\n";
}

/// Every pair of axes is turned about by that angle, as far as the stiffness tells.
std::string three_pairs(const Vec3<double>& compliance, double angle, const Answer& answer) {
  std::string out;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    Vec3<double> moment = Vec3<double>::Zero();
    moment[i] = angle / compliance[i], moment[j] = angle / compliance[j];
    out += angular_case(fmt::format("moments about {} and {}", i + 1, j + 1), moment, answer);
  }
  return out;
}

Answer solid_answer(const fe::Solid& solid, fe::Statics& statics, fe::SolidLaw law) {
  return [&solid, &statics, law](const Vec3<double>& f, const Vec3<double>& m) -> Motion {
    const fe::Equilibrium e = statics.solve(law, {f, m, false}, solid.unloaded());
    if (!e.converged) throw std::runtime_error("solid: " + e.reason);
    return {e.state.d, e.theta(), m};
  };
}

std::string frustum() {
  constexpr int kLevel = 6;
  const fe::Body& body = fe::body_named("frustum_top");
  const fe::Solid solid(body.mesh(fe::ElementKind::hex20, kLevel), body.material, body.face);
  fe::Statics statics(solid);
  const Vec3<double> compliance = statics.linear().compliance.diagonal().tail<3>();
  return fmt::format(
             "# Frustum of height 20 m, top (10 x 5) clamped, base (30 x 5) loaded; neo-Hooke, E = 1 Pa, nu "
             "= 0.3; 3D finite elements, hex20, level {}.\n",
             kLevel) +
         three_pairs(compliance, 0.005, solid_answer(solid, statics, fe::SolidLaw::neo_hooke));
}

/// Loaded at its middle, measured at the centre of the free face: the joint point is 2.5 m from there.
std::string block() {
  constexpr int kLevel = 4;
  const Vec3<double> middle(-2.5, 0, 0);  // from the centre of the face, axes of the face
  const fe::Body& body = fe::body_named("block");
  const fe::Solid solid(body.mesh(fe::ElementKind::hex20, kLevel), body.material, body.face + middle);
  fe::Statics statics(solid);
  const Answer at_middle = solid_answer(solid, statics, fe::SolidLaw::st_venant);
  const Answer answer = [&](const Vec3<double>& f, const Vec3<double>& m) -> Motion {
    const Motion there = at_middle(f, m);
    const Vec3<double> arm = halfway::so3::exp<double>(there.theta) * middle;
    return {there.u - arm + middle, there.theta, m + arm.cross(f)};
  };
  const halfway::reference::fe::Mat6 C = statics.linear().compliance;
  std::string out = fmt::format(
      "# Parallelepiped 5 x 30 x 5 m between rigid faces normal to axis 1; St. Venant-Kirchhoff, E = 1 Pa, "
      "nu = 0.3; 3D finite elements, hex20, level {}.\n# Loaded at its middle; loads and motion are those of "
      "the centre of the free face.\n",
      kLevel);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    Vec3<double> force = Vec3<double>::Zero(), moment = Vec3<double>::Zero();
    moment[i] = 0.005 / C(3 + i, 3 + i), moment[j] = 0.005 / C(3 + j, 3 + j);
    out += full_case(fmt::format("moments about {} and {}", i + 1, j + 1), force, moment, answer);
    moment.setZero();
    force[i] = 0.02 / C(i, i), force[j] = 0.02 / C(j, j);
    out += full_case(fmt::format("forces along {} and {}", i + 1, j + 1), force, moment, answer);
  }
  return out;
}

std::string tapered_rod() {
  rod::Rod rod;
  rod.taper = [](double s) {
    const double u = 1 - s / 2;
    return rod::Section{{std::pow(u, -3), 2 / u, 0.3 * std::pow(u, -3)}, {0, 0, 0}};
  };
  const Vec3<double> compliance(3, 4 * std::log(2.), 0.9);  // the integrals of the three along s
  const Answer answer = [&rod](const Vec3<double>&, const Vec3<double>& m) -> Motion {
    const rod::Tip tip = rod::tip_under_moment(rod, m);
    return {tip.x, halfway::so3::log(halfway::so3::quaternion<double>(tip.R)), m};
  };
  return "# Tapered rod of length 1 m under end moments: compliances u^-3, 2/u, 0.3 u^-3 rad/(N m^2), u = 1 "
         "- s/2; the geometrically exact rod.\n" +
         three_pairs(compliance, 0.005, answer);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: halfway_identify_samples FOLDER\n", stderr);
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  halfway::reports::write_file(folder / "tapered_rod.csv", tapered_rod());
  halfway::reports::write_file(folder / "block.csv", block());
  halfway::reports::write_file(folder / "frustum.csv", frustum());
  return 0;
}
