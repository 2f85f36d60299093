// Table 1's static solve by Newton on the kernel.
#include "halfway/kernels/equilibrium.hpp"

#include "bench/questions/equilibrium.hpp"
#include "bench/questions/kernels/kernel_joint.hpp"
#include "halfway/systems/attached.hpp"
#include "halfway/systems/intrinsic.hpp"

#include <memory>

namespace halfway::bench {

Cases kernel_statics_cases();

namespace {

template <class F>
Case solve_case(const std::shared_ptr<const Problem>& p) {
  reference::JointSpec spec;
  spec.law = reference::LinearSpec{p->law.K, false};
  const auto joint = static_kernel_joint<F, Kind::angular, double, kernel::NoEnds>(spec);
  const kernel::V3<double> moment = reference::plain<double>(p->moment);
  const kernel::Quat<double> one{1, {0, 0, 0}};
  Case c;
  c.formulation = F::name;
  c.kind = "angular";
  c.what = "equilibrium_newton";
  c.implementation = "kernel";
  c.name = p->scene.name + '/' + F::name + "/equilibrium_newton/kernel";
  c.check = [=] {
    const auto out = kernel::solve(joint, one, one, moment);
    if (out.iterations == 0) return Checked{.message = "Newton did not converge"};
    const reference::QuaternionPose<double> b{{}, {out.b.w, out.b.v.x, out.b.v.y, out.b.v.z}};
    return compare_end(*p, F::name, reference::matrix_pose(b), 1e-12);  // as the transcription's Newton
  };
  c.timed = [=](benchmark::State& state) {
    kernel::V3<double> load = moment;
    for (auto _ : state) {
      benchmark::DoNotOptimize(load);
      auto out = kernel::solve(joint, one, one, load);
      benchmark::DoNotOptimize(out);
    }
  };
  c.evaluate = [=](int iterations) {
    kernel::V3<double> load = moment;
    for (int i = 0; i < iterations; ++i) {
      benchmark::DoNotOptimize(load);
      auto out = kernel::solve(joint, one, one, load);
      benchmark::DoNotOptimize(out);
    }
  };
  return c;
}

}  // namespace

Cases kernel_statics_cases() {
  const auto p = std::make_shared<const Problem>(problem("c1_skewed_torque", false));
  return {solve_case<AttachedA>(p), solve_case<Invariant>(p)};
}

}  // namespace halfway::bench
