// GSL's hybrid method, with no tangent of ours, finds the same equilibria as Newton.
#include "reference/solve/gsl_solver.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/scene_access.hpp"

namespace halfway::verify {
namespace {

/// Balance of node b with the rotation vector (and displacement) as unknowns, over the load's size.
Eigen::VectorXd residual(const Entry& entry, const JointSpec& spec, const reference::SceneLoad& load,
                         const Eigen::VectorXd& x) {
  Pose<double> b;
  b.R = so3::exp<double>(x.tail<3>());
  if (spec.kind != Kind::angular) b.x = x.head<3>();
  const auto q = reference::node_loads<double>(entry, spec, {}, b, false).q;
  Eigen::VectorXd r = q.tail(x.size());
  if (load.type == reference::LoadType::fixed_force)
    r.head<3>() -= load.value;
  else
    r.tail<3>() -= load.value;
  return r / load.value.norm();
}

Finding compare(const Entry& entry, const std::string& scene_name, Draft f) {
  const reference::Scene& s = scene(scene_name);
  JointSpec spec = s.joint;
  spec.xi = entry.probe_xi;
  const auto fn = [&](const Eigen::VectorXd& x) { return residual(entry, spec, s.loads.front(), x); };
  const auto gsl = reference::gsl_hybrids(fn, Eigen::VectorXd::Zero(strain_count(spec.kind)), 1e-13);
  reference::Path<double> path(s, entry, entry.probe_xi);
  path.advance(1);
  Eigen::VectorXd ours(strain_count(spec.kind));
  ours.tail<3>() << path.output("theta_x"), path.output("theta_y"), path.output("theta_z");
  if (spec.kind != Kind::angular)
    ours.head<3>() << path.output("u_x"), path.output("u_y"), path.output("u_z");
  return f
      .measured(gsl.converged ? (gsl.x - ours).norm() / ours.norm() : std::nan(""),
                scene_name + (gsl.converged ? "" : ": GSL did not converge: " + gsl.message))
      .in("relative")
      .at_most(1e-10, "GSL stops at a residual of 1e-13 of the load; the stiffness spans three decades")
      .by(Oracle::independent);
}

}  // namespace

void second_solver(Checks& checks) {
  add_property(checks, "second_solver", {Kind::angular},
               [](const Entry& e, Kind, Draft f) { return compare(e, "c1_skewed_torque", f); });
  add_property(checks, "second_solver", {Kind::linear_angular},
               [](const Entry& e, Kind, Draft f) { return compare(e, "c6_compression_shear", f); });
}

}  // namespace halfway::verify
