#include "reference/chain/newton.hpp"

#include "reference/chain/joints.hpp"
#include "reference/chain/sweeps.hpp"
#include "reference/record/worst.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfway::reference::chain::detail {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

/// Entries of the factors beyond which elimination without pivots is not trusted: its rounding, so many times
/// eps, would be all that an iteration gains.
constexpr double kMostGrowth = 1e8;
/// What is left of the increments where an iteration stops, rad or over L: less than positions are known to.
constexpr double kLeft = 1e-14;
/// Increments among which rounding may be found, rad or over L.
constexpr double kSmall = 1e-9;
/// Imbalance that is still called rounding, over its estimate.
constexpr double kMostImbalance = 64;

double largest(const double (&x)[6], int first) {
  return larger(x[first], larger(x[first + 1], x[first + 2]));
}

class Newton {
 public:
  Newton(const Chain& chain, const Settings& settings, State& state, Tip& tip, AtTip& at_tip)
      : chain_(chain),
        settings_(settings),
        state_(state),
        tip_(tip),
        at_tip_(at_tip),
        joints_(chain, settings),
        sweeps_(sweeps(batch::choose(settings.isa))) {}

  Solution run() {
    bool good = true;
    for (int k = 1; good && k <= settings_.load_steps; ++k) {
      good = load_step(double(k) / settings_.load_steps);
      out_.load_steps += good;
    }
    out_.converged = good;
    if (good) out_.outcome = "converged";
    if (good && settings_.tip_stiffness) {
      eliminate();
      out_.tip_stiffness = tip_.stiffness(state_, at_tip_);
    }
    out_.nodes = state_.nodes();
    return std::move(out_);
  }

 private:
  enum class End { balanced, away, not_finite, too_many, stopped };

  bool load_step(double factor) {
    cap_ = settings_.uncapped_first ? std::numeric_limits<double>::infinity() : settings_.spin_cap;
    End end = iterate(factor);
    if (end == End::away) {
      state_.restore();
      ++out_.restarts;
      cap_ = settings_.spin_cap;
      end = iterate(factor);
    }
    if (end == End::balanced) return true;
    out_.outcome = words(end, factor);
    return false;
  }

  /// Until the increments are nothing, or shrink no more, and what is left of the loads is rounding.
  End iterate(double factor) {
    double previous = std::numeric_limits<double>::quiet_NaN();
    scale_ = 0;
    for (int i = 0; i < settings_.most_iterations; ++i) {
      const double size = increment(factor, i == 0);
      const double rate = size / previous;
      const bool bold = cap_ > settings_.spin_cap;
      if (bold && i > 0 && !(rate < 0.5) && !(size < settings_.spin_cap)) return End::away;
      if (!std::isfinite(size)) return End::not_finite;
      if (bold && i == 0) state_.save();
      if (settings_.progress && !settings_.progress(i + 1, settings_.most_iterations)) return End::stopped;
      const double left = rate < 0.5 ? size * rate / (1 - rate) : size;
      if (scale_ == 1 && (left < kLeft || (size < kSmall && !(rate < 0.25))) && balanced(factor)) {
        out_.tip_error = left;
        return End::balanced;
      }
      previous = size;
    }
    return End::too_many;
  }

  /// Moves the state by the last one and finds the next; its size.
  double increment(double factor, bool first) {
    const bool frozen =
        settings_.tangent == Tangent::frozen_first || settings_.tangent == Tangent::frozen_step;
    const bool fresh = !frozen || (first && (settings_.tangent == Tangent::frozen_step || !has_tangent_));
    if (fresh)
      eliminate();
    else
      sweeps_.reduce(state_.links(), joints_.how(), scale_, at_tip_);
    has_tangent_ = true;
    const Vec6 last = tip_.increment(state_, factor, at_tip_, fresh);
    double at_end[6], size[6];
    std::copy_n(last.data(), 6, at_end);
    sweeps_.substitute(state_.links(), at_end, size);
    const double spin = largest(size, 3), whole = larger(spin, largest(size, 0) / chain_.length);
    scale_ = spin > cap_ ? cap_ / spin : 1;
    out_.iterations.push_back({whole, scale_});
    return whole;
  }

  void eliminate() {
    if (!out_.pivoted) {
      const bool any = joints_.how().symmetrised || state_.links().kept != nullptr;
      eliminate(any ? sweeps_.eliminate_any : sweeps_.eliminate);
      if (std::sqrt(at_tip_.growth) < kMostGrowth) return;  // no entry is larger; a NaN is no good either
      out_.pivoted = true;
      scale_ = 0;
    }
    eliminate(sweeps_.eliminate_pivoted);
  }
  void eliminate(void (*sweep)(const Links&, const Evaluation&, double, AtTip&)) {
    sweep(state_.links(), joints_.how(), scale_, at_tip_);
    out_.growth = std::sqrt(at_tip_.growth / double(6 * chain_.links));
  }

  /// Moves the state, and says whether what is left of the loads is rounding: increments may be small where
  /// nothing is in balance.
  bool balanced(double factor) {
    sweeps_.balance(state_.links(), joints_.how(), scale_, at_tip_);
    scale_ = 0;
    const Vec6 load = tip_.load(state_, factor, at_tip_), k = stiffness(chain_);
    for (int c = 0; c < 6; ++c) keep_largest(at_tip_.imbalance[c], std::abs(at_tip_.residual[c] + load[c]));
    const double f = largest(at_tip_.largest, 0), m = largest(at_tip_.largest, 3);
    const double f0 = largest(at_tip_.imbalance, 0), m0 = largest(at_tip_.imbalance, 3);
    // Forces are known to eps of their size and of what the moments make of it, angles to eps.
    const double shortened = of_shortening(m, k);
    const double of_force = kEps * (f + m / chain_.length + shortened);
    const double of_moment = kEps * (k.tail<3>().maxCoeff() + m + chain_.length * (f + shortened));
    out_.imbalance = larger(f0 / of_force, m0 / of_moment);
    return out_.imbalance < kMostImbalance;
  }

  /// The axial stiffness of a joint that knows its length sees d less h theta^2/12: what its force is a
  /// difference of, and what it makes of an angle's last digits, over eps. The largest turn of a joint is
  /// its moment over the softest stiffness.
  double of_shortening(double moment, const Vec6& k) const {
    if (!batch::Batch::needs_length(chain_.formulation)) return 0;
    constexpr double kOfAngle = 4;  // eps: of the quaternions of two links and their product
    const double turn = moment / k.tail<3>().minCoeff();
    return k[0] * chain_.length / double(chain_.links) * turn * (turn / 12 + kOfAngle / 6);
  }

  std::string words(End end, double factor) const {
    const std::string at =
        fmt::format(" at {:.4g} of the load, iteration {}", factor, out_.iterations.size());
    switch (end) {
      case End::not_finite:
        return "no increment (singular tangent or loads that are no numbers)" + at;
      case End::stopped:
        return "stopped by the caller" + at;
      default:
        if (out_.iterations.back().increment < kSmall)
          return fmt::format("loads of {:.1e} times rounding are not in balance", out_.imbalance) + at;
        return fmt::format("increments of {:.1e} do not vanish", out_.iterations.back().increment) + at;
    }
  }

  const Chain& chain_;
  const Settings& settings_;
  State& state_;
  Tip& tip_;
  AtTip& at_tip_;
  const Joints joints_;
  const Sweeps& sweeps_;
  Solution out_;
  double cap_ = 0, scale_ = 0;
  bool has_tangent_ = false;
};

}  // namespace

Solution newton(const Chain& chain, const Settings& settings, State& state, Tip& tip, AtTip& at_tip) {
  return Newton(chain, settings, state, tip, at_tip).run();
}

}  // namespace halfway::reference::chain::detail
