#include "reference/identify/response.hpp"

#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace halfway::reference::identify {
namespace {

constexpr int kMostNewton = 60;
constexpr double kLargestTurn = 0.3;  // rad, of one step of Newton
constexpr double kStep = 1e-5;        // of a derivative by an unknown: central, so that 1e-10 is left out

std::vector<int> loaded(Kind kind, const LoadCase& one) {
  std::vector<int> out;
  for (int i = first_component(kind); i < end_component(kind); ++i) {
    if (!one.held[std::size_t(i)]) out.push_back(i);
  }
  return out;
}

/// Runs fn(case, row, component) over all measured numbers.
template <class Fn>
void for_measured(const Data& data, Fn&& fn) {
  for (const LoadCase& one : data.cases) {
    for (std::size_t row = 0; row < one.loads.size(); ++row) {
      for (int i = first_component(data.kind); i < end_component(data.kind); ++i) {
        if (one.is_measured(i)) fn(one, row, i);
      }
    }
  }
}

/// Where Newton begins: the measured motion; what was not measured from the row before.
Vec6 start_of(const Data& data, const LoadCase& one, std::size_t row, const Vec6& before) {
  Vec6 out = before;
  for (int i = 0; i < 6; ++i) {
    const bool is_of_kind = i >= first_component(data.kind) && i < end_component(data.kind);
    if (!is_of_kind || one.held[std::size_t(i)] || one.has_motion[std::size_t(i)])
      out[i] = one.motions[row][i];
  }
  return out;
}

/// Of the row's equilibrium by an unknown: the loaded components of the motion give way, held ones do not.
struct Sensitivity {
  std::vector<int> free;
  Eigen::PartialPivLU<Eigen::MatrixXd> tangent{};
  const Loads& loads;

  Sensitivity(std::vector<int> free_, const Loads& loads_) : free(std::move(free_)), loads(loads_) {
    Eigen::MatrixXd T(free.size(), free.size());
    for (std::size_t i = 0; i < free.size(); ++i) {
      for (std::size_t j = 0; j < free.size(); ++j)
        T(Eigen::Index(i), Eigen::Index(j)) = loads.by_motion(free[i], free[j]);
    }
    if (!free.empty()) tangent.compute(T);
  }
  /// (motion, loads) by the unknown, from the loads by it where nothing moves.
  std::pair<Vec6, Vec6> operator()(const Vec6& by_unknown) const {
    Vec6 motion = Vec6::Zero();
    if (!free.empty()) {
      Eigen::VectorXd right(free.size());
      for (std::size_t i = 0; i < free.size(); ++i) right[Eigen::Index(i)] = -by_unknown[free[i]];
      const Eigen::VectorXd moved = tangent.solve(right);
      for (std::size_t i = 0; i < free.size(); ++i) motion[free[i]] = moved[Eigen::Index(i)];
    }
    return {motion, by_unknown + loads.by_motion * motion};
  }
};

struct Pair {
  Model up, down;
};

}  // namespace

Equilibrium equilibrium(const Model& model, Kind kind, const LoadCase& one, std::size_t row,
                        const Vec6& start) {
  const std::vector<int> free = loaded(kind, one);
  Equilibrium out{start, loads_at(model, start, true), free.empty()};
  double before = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < kMostNewton && !free.empty(); ++iteration) {
    if (!out.loads.q.allFinite()) return out;
    const Sensitivity sensitivity(free, out.loads);
    const Vec6 step = sensitivity(Vec6(out.loads.q - one.loads[row])).first;
    const double turn = step.tail<3>().norm();
    if (!std::isfinite(step.norm())) return out;
    out.motion += turn > kLargestTurn ? Vec6(step * (kLargestTurn / turn)) : step;
    out.loads = loads_at(model, out.motion, true);
    // Relative to the motion, each half of it; the last steps only stir the rounding.
    const double size = step.head<3>().norm() / (out.motion.head<3>().norm() + 1e-300) +
                        turn / (out.motion.tail<3>().norm() + 1e-300);
    out.found = size < 1e-12 || (size < 1e-8 && size >= before);
    if (out.found) break;
    before = size;
  }
  return out;
}

Response respond(const Data& data, const MakeModel& make, const Unknowns& p, const std::vector<int>& active,
                 bool with_derivative, const std::vector<Vec6>& warm) {
  const Model model = make(p);
  std::vector<Pair> nearby;
  for (int place : with_derivative ? active : std::vector<int>{}) {
    Unknowns up = p, down = p;
    up[place] += kStep, down[place] -= kStep;
    nearby.push_back({make(up), make(down)});
  }
  const int count = measured_count(data);
  Response out{
      Eigen::VectorXd(count), Eigen::MatrixXd(with_derivative ? count : 0, Eigen::Index(nearby.size())), {}};
  int at = 0;
  for (const LoadCase& one : data.cases) {
    Vec6 before = Vec6::Zero();
    for (std::size_t row = 0; row < one.loads.size(); ++row) {
      const bool is_warm = out.motions.size() < warm.size() && warm[out.motions.size()].allFinite();
      Vec6 start = is_warm ? warm[out.motions.size()] : start_of(data, one, row, before);
      Equilibrium found = equilibrium(model, data.kind, one, row, start);
      if (!found.found && is_warm)
        found = equilibrium(model, data.kind, one, row, start_of(data, one, row, before));
      const double lost = found.found ? 0 : std::nan("");
      before = found.found ? found.motion : Vec6::Zero();
      out.motions.push_back(found.motion + Vec6::Constant(lost));
      const int begin = at;
      for (int i = first_component(data.kind); i < end_component(data.kind); ++i) {
        if (one.is_measured(i))
          out.values[at++] = (one.held[std::size_t(i)] ? found.loads.q[i] : found.motion[i]) + lost;
      }
      if (!with_derivative) continue;
      const Sensitivity sensitivity(loaded(data.kind, one), found.loads);
      for (std::size_t c = 0; c < nearby.size(); ++c) {
        const Vec6 by = (loads_at(nearby[c].up, found.motion, false).q -
                         loads_at(nearby[c].down, found.motion, false).q) /
                        (2 * kStep);
        const auto [motion, load] = sensitivity(by);
        int to = begin;
        for (int i = first_component(data.kind); i < end_component(data.kind); ++i) {
          if (one.is_measured(i))
            out.by_unknown(to++, Eigen::Index(c)) = one.held[std::size_t(i)] ? load[i] : motion[i];
        }
      }
    }
  }
  return out;
}

Eigen::VectorXd measured(const Data& data) {
  Eigen::VectorXd out(measured_count(data));
  Eigen::Index at = 0;
  for_measured(data, [&](const LoadCase& one, std::size_t row, int i) { out[at++] = one.measured(row, i); });
  return out;
}

std::vector<int> channels(const Data& data) {
  std::vector<int> out;
  for_measured(data, [&](const LoadCase& one, std::size_t, int i) { out.push_back(one.channel(i)); });
  return out;
}

}  // namespace halfway::reference::identify
