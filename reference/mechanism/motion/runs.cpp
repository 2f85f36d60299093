#include "reference/mechanism/motion/runs.hpp"

#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>

namespace halfway::reference::mechanism {
namespace {

/// Inside the motion, each once.
std::vector<double> jumps_of(const MechanismScene& scene) {
  std::vector<double> out;
  for (const BodyLoad& load : scene.loads) {
    for (const double time : load.times)
      if (time > 0 && time < scene.factor_end) out.push_back(time);
  }
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

bool jumps_at(const MechanismScene& scene, double time) {
  return std::ranges::any_of(scene.loads,
                             [&](const BodyLoad& load) { return std::ranges::count(load.times, time) > 1; });
}

bool is_finite(const dynamics::State& state) {
  return std::ranges::all_of(state, [](const dynamics::BodyState& s) {
    return std::isfinite(s.x.sum() + s.q.sum() + s.p.sum() + s.L.sum());
  });
}

/// GSL's words are of its own functions.
std::string in_words(const std::string& failure) {
  if (failure.empty()) return "";
  if (failure == gsl_strerror(GSL_EBADFUNC))
    return "the loads are no numbers: beyond the formulation's range";
  if (failure == gsl_strerror(GSL_EMAXITER))
    return "more steps than are taken: the fastest motion is far faster than the time that is asked for; a "
           "softer joint, "
           "a shorter time or a larger tolerance helps";
  return "the integrator stops: " + failure;
}

}  // namespace

Run::Run(const MovingScene& moving, bool is_finer)
    : moving_(moving),
      is_finer_(is_finer),
      jumps_(jumps_of(moving.scene())),
      system_(moving.system()),
      state_(moving.start()) {
  if (!moving.scene().loads.empty())
    system_.drive = [this](double t, const dynamics::State& s, dynamics::Loads& sum) {
      moving_.set_drive(t, on_part_, s, sum);
    };
  const SceneTime& time = *moving.scene().time;
  if (time.integrator == Integrator::runge_kutta)
    runge_kutta_.emplace(system_, moving.start(),
                         dynamics::RungeKutta::Options{is_finer ? time.tolerance / 100 : time.tolerance, true,
                                                       is_finer ? 3 * time.most_steps : time.most_steps});
}

std::string Run::split(double to) {
  const SceneTime& by = *moving_.scene().time;
  const bool is_two = by.integrator == Integrator::splitting_2;
  const double whole = to - driven_.time;
  // As many steps as go into it, to a rounding of their number.
  long steps = std::max(1L, long(std::ceil(whole / by.step * (1 - 1e-12))));
  if (is_finer_) steps *= 2;
  dynamics::advance(system_, is_two ? dynamics::Order::two : dynamics::Order::four, whole / double(steps),
                    steps, state_, driven_);
  driven_.time = to;  // takes away rounding only
  evaluations_ += steps * (is_two ? 1 : 3) + 1;
  return is_finite(state_) ? "" : "the loads are no numbers, or the step is too long for the fastest motion";
}

std::string Run::advance_to(double to) {
  if (to <= time()) return "";
  on_part_ = (time() + to) / 2;
  if (runge_kutta_ && jumps_at(moving_.scene(), time())) runge_kutta_->restart();
  return runge_kutta_ ? in_words(runge_kutta_->advance(to)) : split(to);
}

std::string Run::advance(int point) {
  const MechanismScene& scene = moving_.scene();
  const double to = scene.factor_end * point / scene.points;
  std::vector<double> stops = jumps_;
  // Steps that rows cut short are no finer by a smaller tolerance.
  if (is_finer_ && runge_kutta_) stops.push_back(to - scene.factor_end / (2 * scene.points));
  stops.push_back(to);
  std::ranges::sort(stops);
  for (const double stop : stops) {
    if (stop > to) break;
    if (const std::string why = advance_to(stop); !why.empty()) return why;
  }
  return "";
}

Moment Run::moment() const {
  Moment out;
  out.state = runge_kutta_ ? runge_kutta_->state() : state_;
  out.now = moving_.moving(out.state);
  const dynamics::System& system = moving_.system();
  out.energies = {dynamics::kinetic_energy(system, out.state), system.strain_energy(out.state),
                  runge_kutta_ ? runge_kutta_->dissipated() : 0,
                  (runge_kutta_ ? runge_kutta_->driven() : driven_).work};
  return out;
}

long Run::evaluations() const { return runge_kutta_ ? runge_kutta_->evaluations() : evaluations_; }

}  // namespace halfway::reference::mechanism
