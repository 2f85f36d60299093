// The tangent by a step in the imaginary direction: f(x + i h) = f(x) + i h f'(x) + O(h^2), no difference.
#include "bench/questions/methods/complex.hpp"
#include "bench/questions/methods/groups.hpp"
#include "bench/questions/methods/tangent.hpp"

namespace halfway::bench {
namespace {

/// Its square vanishes against 1, and products of two are still normal numbers.
constexpr double kStep = 1e-100;

struct ByComplexStep {
  static constexpr const char* name = "complex_step";
  static constexpr double limit = kRoundingLimit;
  template <Kind>
  using Scalar = Complex;

  template <Kind kind, class J>
  static auto evaluate(const J& joint, const Pose<double>& a, const Pose<double>& b) {
    const Complex step(std::complex<double>(0, kStep));
    return one_unknown_at_a_time<kind>(
        joint, a, b, step, [](const Complex& x) { return std::pair(x.z.real(), x.z.imag() / kStep); });
  }
};

}  // namespace

Cases complex_step_cases() { return invariant_tangents_by<ByComplexStep>(); }

}  // namespace halfway::bench
