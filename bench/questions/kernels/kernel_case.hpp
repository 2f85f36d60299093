// A kernel as a benchmark case: timed as a static type, checked at 50 digits from the same quaternions.
#pragma once

#include "bench/harness/check.hpp"
#include "bench/harness/flops.hpp"
#include "bench/questions/kernels/kernel_joint.hpp"

#include <memory>

namespace halfway::bench {

template <Kind kind>
constexpr int load_count() {
  return kind == Kind::angular ? 3 : 12;
}

/// Loads and tangent as an assembly takes them: 3 and 3 x 6, or 12 and 12 x 12.
template <Kind kind, bool with_tangent, class Accuracy, class T, class J>
HALFWAY_INLINE void evaluate_kernel(const J& joint, const kernel::NodePose<T>& a,
                                    const kernel::NodePose<T>& b, T* out) {
  if constexpr (kind == Kind::angular)
    kernel::expand<with_tangent>(kernel::loads<with_tangent, Accuracy>(joint, a.q, b.q), out);
  else
    kernel::expand<with_tangent>(kernel::loads<with_tangent, Accuracy>(joint, a, b), out);
}

template <class T>
struct KernelNodes {
  std::vector<kernel::NodePose<T>> a, b;

  explicit KernelNodes(const Inputs& in) {
    const auto cast = [](const reference::QuaternionPose<double>& p) {
      return reference::plain(reference::QuaternionPose<T>{p.x.cast<T>(), p.q.cast<T>()});
    };
    for (const auto& p : in.qa) a.push_back(cast(p));
    for (const auto& p : in.qb) b.push_back(cast(p));
  }
};

template <Kind kind, bool with_tangent>
constexpr int output_count() {
  return kind == Kind::angular ? (with_tangent ? 3 + 18 : 3) : (with_tangent ? 12 + 144 : 12);
}

template <Kind kind, bool with_tangent, class T>
Evaluated evaluated_from(const T* out) {
  constexpr int n = load_count<kind>(), columns = kind == Kind::angular ? 6 : 12;
  Evaluated e{Eigen::Map<const Eigen::Matrix<T, n, 1>>(out).template cast<double>(), {}};
  if constexpr (with_tangent) {
    e.tangent =
        Eigen::Map<const Eigen::Matrix<T, n, columns, Eigen::RowMajor>>(out + n).template cast<double>();
  }
  return e;
}

/// @param variant, tolerance  what the accuracy leaves out, by name and size; empty and {} for none
template <class F, Kind kind, bool with_tangent, class T = double, class Accuracy = kernel::Accuracy<>,
          class E = kernel::Ends<T>>
Case kernel_case(const std::shared_ptr<const Inputs>& in, const std::string& variant = {},
                 const Tolerance& tolerance = {}) {
  Case c;
  c.formulation = F::name;
  c.kind = to_string(kind);
  c.what = with_tangent ? "residual_tangent" : "residual";
  c.implementation = "kernel";
  c.precision = std::is_same_v<T, float> ? "float" : "double";
  c.variant = variant;
  c.name = c.formulation + '/' + c.kind + '/' + c.what + "/kernel" +
           (c.precision == "float" ? "/float" : "") + (variant.empty() ? "" : '/' + variant);
  c.evaluations = kPoses;
  c.flops = kept_flops(c.name);
  const auto joint = static_kernel_joint<F, kind, T, E>(in->spec);
  const EvaluateAll all = [joint](const Inputs& at) {
    const KernelNodes<T> nodes(at);
    std::vector<Evaluated> values;
    for (std::size_t i = 0; i < nodes.a.size(); ++i) {
      T out[output_count<kind, with_tangent>()];
      evaluate_kernel<kind, with_tangent, Accuracy>(joint, nodes.a[i], nodes.b[i], out);
      values.push_back(evaluated_from<kind, with_tangent>(out));
    }
    return values;
  };
  c.check = [in, all, tolerance] { return compare(F::name, *in, all(*in), Given::quaternions, tolerance); };
  c.errors = [in, all] { return errors_by_range(F::name, *in, all, Given::quaternions); };
  constexpr int read = 2 * (kind == Kind::angular ? 4 : 7);
  c.bytes = (read + output_count<kind, with_tangent>()) * double(sizeof(T));
  time_by(c, [nodes = KernelNodes<T>(*in), joint](int iterations) {
    // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): see residual_tangent.hpp
    const auto local = joint;
    for (int iteration = 0; iteration < iterations; ++iteration) {
      for (int i = 0; i < kPoses; ++i) {
        T out[output_count<kind, with_tangent>()];
        evaluate_kernel<kind, with_tangent, Accuracy>(local, nodes.a[i], nodes.b[i], out);
        benchmark::DoNotOptimize(out);
      }
    }
  });
  return c;
}

}  // namespace halfway::bench
