// One motion by the integrator that its scene names, on from time to time.
#pragma once

#include "reference/mechanism/motion/motion_outputs.hpp"
#include "reference/solve/dynamics/runge_kutta.hpp"
#include "reference/solve/dynamics/splitting.hpp"

#include <optional>
#include <string>

namespace halfway::reference::mechanism {

class Run {
 public:
  /// The scene must outlive it. @param is_finer  at a hundredth of the tolerance and from twice as many
  /// stops, or half the step
  Run(const MovingScene& moving, bool is_finer);
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// On to a point of the scene, through the times at which a load's slope jumps. @return  "", or why not
  std::string advance(int point);
  Moment moment() const;
  long evaluations() const;

 private:
  double time() const { return (runge_kutta_ ? runge_kutta_->driven() : driven_).time; }
  std::string advance_to(double to);
  std::string split(double to);

  const MovingScene& moving_;
  bool is_finer_;
  std::vector<double> jumps_;
  double on_part_ = 0;  ///< a time on the part of the way that is integrated
  dynamics::System system_;
  std::optional<dynamics::RungeKutta> runge_kutta_{};
  dynamics::State state_;  ///< of a splitting
  dynamics::Driven driven_;
  long evaluations_ = 0;
};

}  // namespace halfway::reference::mechanism
