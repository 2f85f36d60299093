// The linear analysis, timed as the kernels are: one matrix times the motions of both nodes.
#include "reference/numbers/precision.hpp"
#include "reference/numbers/random.hpp"
#include "reference/record/worst.hpp"
#include "reports/advise/cost/cost.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

namespace halfway::advise {
namespace {

constexpr int kPoses = 256;

template <int rows, int columns>
struct LinearLoads {
  std::array<std::array<double, columns>, rows> tangent;
  std::vector<std::array<double, columns>> motion;  ///< displacements and rotation vectors of both nodes

  LinearLoads() {
    reference::Generator g(2011);
    for (auto& row : tangent)
      for (double& entry : row) entry = g.uniform(-100, 100);
    motion.resize(kPoses);
    for (auto& pose : motion)
      for (double& entry : pose) entry = g.uniform(-1, 1);
  }
  void loads(const std::array<double, columns>& x, double* out) const {
    for (int i = 0; i < rows; ++i) {
      double sum = 0;
      for (int j = 0; j < columns; ++j) sum += tangent[i][j] * x[j];
      out[i] = sum;
    }
  }
  /// Worst error against 50 digits, over |tangent| |motion|.
  double error() const {
    double worst = 0;
    for (const auto& x : motion) {
      double out[rows];
      loads(x, out);
      for (int i = 0; i < rows; ++i) {
        reference::Real50 exact(0), size(0);
        for (int j = 0; j < columns; ++j) {
          const reference::Real50 term = reference::Real50(tangent[i][j]) * reference::Real50(x[j]);
          exact += term, size += term < reference::Real50(0) ? reference::Real50(-term) : term;
        }
        const double off = std::abs(double(reference::Real50(reference::Real50(out[i]) - exact) / size));
        reference::keep_largest(worst, off);
      }
    }
    return worst;
  }
};

template <int rows, int columns>
Cost timed() {
  const LinearLoads<rows, columns> linear;
  constexpr double kRoundings = columns * 1.2e-16;  // a sum of as many products
  const double error = linear.error();
  if (!(error <= kRoundings)) throw std::logic_error("the linear loads are wrong");
  constexpr int kTimes = 9, kCalls = 60;
  std::vector<double> ns;
  double out[rows];
  for (int round = 0; round < kTimes; ++round) {
    const double begin = thread_ns();
    for (int call = 0; call < kCalls; ++call) {
      for (const auto& x : linear.motion) {
        linear.loads(x, out);
        asm volatile("" : : "g"(out) : "memory");
      }
    }
    ns.push_back((thread_ns() - begin) / (kCalls * kPoses));
  }
  Cost cost = of_rounds(ns);
  cost.error = error, cost.flops = 2. * rows * columns - rows;
  return cost;
}

}  // namespace

Cost linear_cost(Kind kind) { return kind == Kind::angular ? timed<3, 6>() : timed<12, 12>(); }

}  // namespace halfway::advise
