#include "reference/identify/identification.hpp"

#include "reference/identify/catalog.hpp"
#include "reference/identify/linear_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace halfway::reference::identify {
namespace {

constexpr std::array<Stage, 5> kStages = {  // without axis_laws, which begin at one of them
    Stage::half_way, Stage::one_xi, Stage::two_xi, Stage::cubic, Stage::per_pair};

bool is_among(const std::vector<Dropped>& open, int place) {
  return std::any_of(open.begin(), open.end(), [&](const Dropped& one) { return one.place == place; });
}

void add(std::vector<int>& places, int first, int count) {
  for (int i = 0; i < count; ++i) places.push_back(first + i);
}

std::vector<int> linear_places(Kind kind) {
  std::vector<int> out;
  if (kind != Kind::linear) add(out, kAngularStiffness, 3), add(out, kAngularAxes, 3);
  if (kind != Kind::angular) add(out, kLinearStiffness, 3), add(out, kLinearAxes, 3);
  if (kind == Kind::linear_angular) add(out, kCoupling, 6), add(out, kJointPoint, 3);
  return out;
}

MakeModel maker(const Frame& frame) {
  return [frame](const Unknowns& p) { return second_order_model(frame, values_of(frame, p)); };
}

/// Second order is told where the stiffnesses that it works with are.
void drop_second_order(std::vector<Dropped>& open) {
  const auto is_open = [&](int place) {
    return std::any_of(open.begin(), open.end(), [&](const Dropped& one) { return one.place == place; });
  };
  bool rotations = false, translations[3] = {false, false, false};
  for (int i = 0; i < 3; ++i) {
    rotations = rotations || is_open(kAngularStiffness + i);
    translations[i] = is_open(kLinearStiffness + i);
  }
  for (int i = 0; i < 3; ++i) {
    if (rotations) open.push_back({kXiAngular + i, std::nan("")});
    if (rotations || translations[(i + 1) % 3] || translations[(i + 2) % 3])
      open.push_back({kXiLinear + i, std::nan("")});
  }
  if (rotations) open.push_back({kCubic, std::nan("")});
}

/// Is there anything that can be asked of a joint?
void check(const Data& data) {
  const auto size = sizes(data);
  const bool loads = size[2] > 0 || size[3] > 0, motions = size[0] > 0 || size[1] > 0;
  if (!loads) throw NotIdentifiable("all loads are zero: nothing tells a stiffness");
  if (!motions) throw NotIdentifiable("all displacements and rotations are zero: nothing tells a stiffness");
  if (measured_count(data) == 0) throw NotIdentifiable("no number was measured");
}

void check_enough(const Data& data, const Fit& fit) {
  if (fit.freedom.active.empty())
    throw NotIdentifiable(
        "no stiffness can be told: what is loaded does not move, or what moves is not loaded");
  if (fit.degrees > 0) return;
  throw NotIdentifiable(
      fmt::format("{} measured numbers for {} unknowns: no interval can be given; more rows are needed",
                  measured_count(data), fit.freedom.active.size()));
}

/// Unknowns begin anew from where a fit ended: axes and stiffnesses become the frame, what is left of them
/// zero.
void rebase(Frame& frame, Unknowns& p) {
  const JointValues v = values_of(frame, p);
  frame.H = v.H, frame.E = v.E, frame.angular = v.angular, frame.linear = v.linear;
  p.segment<12>(0).setZero();
}

StageFit fit_stage(Stage stage, const Data& data, const Frame& frame, const Unknowns& start,
                   const std::vector<Dropped>& open, const std::array<double, kChannels>& sigma) {
  Freedom freedom = freedom_of(stage, data.kind);
  std::erase_if(freedom.active, [&](int place) { return is_among(open, place); });
  StageFit out{stage, {}, open};
  out.fit = fit_identifiable(data, maker(frame), start, freedom, sigma, out.left_open);
  return out;
}

/// Largest rotation and displacement: what k3 is measured by.
void set_range(const Data& data, Frame& frame) {
  double turn = 0, reach = 0;
  for (const LoadCase& one : data.cases) {
    for (const Vec6& z : one.motions)
      turn = std::max(turn, z.tail<3>().norm()), reach = std::max(reach, z.head<3>().norm());
  }
  frame.turn = turn > 0 ? turn : 1;
  frame.reach = reach > 0 ? reach : 1;
}

/// The turn that makes an unknown's axes, counted from E, those of H.
Vec3<double> back(const Mat3<double>& E) {
  return so3::log(so3::quaternion<double>(Mat3<double>(E.transpose())));
}

/// Where the law along an axis is curved: from the stage that is chosen, without coupling. Third order is in
/// any body; it is told where it is half of what second order leaves.
void try_axis_laws(const Data& data, const std::vector<Dropped>& never, Identification& out) {
  const StageFit from = out.chosen_stage();
  Freedom freedom = from.fit.freedom;
  // What was lost in the scatter of straight laws has another try.
  for (const int place : linear_places(data.kind)) {
    const bool is_never =
        std::any_of(never.begin(), never.end(), [&](const Dropped& one) { return one.place == place; });
    if (!is_never && !from.fit.is_active(place)) freedom.active.push_back(place);
  }
  Unknowns start = from.fit.p;
  std::erase_if(freedom.active, [](int place) { return place >= kCoupling && place < kJointPoint; });
  start.segment<6>(kCoupling).setZero();
  if (data.kind == Kind::linear_angular) {
    std::erase_if(freedom.active, [](int place) { return place >= kLinearAxes && place < kCoupling; });
    start.segment<3>(kLinearAxes) = back(out.frame.E);
  }
  const auto is_free = [&](int place) {
    return std::find(freedom.active.begin(), freedom.active.end(), place) != freedom.active.end();
  };
  for (int i = 0; i < 3; ++i) {
    if (is_free(kAngularStiffness + i)) freedom.active.push_back(kAngularCube + i);
    if (is_free(kLinearStiffness + i)) freedom.active.push_back(kLinearCube + i);
  }
  // Not zero: a law is curved or it is not, and has no derivative there.
  start.segment<6>(kAngularCube).setConstant(1e-3);
  StageFit curved{Stage::axis_laws, {}, never};
  curved.fit = fit_identifiable(data, maker(out.frame), start, freedom, out.sigma, curved.left_open);
  if (!curved.fit.converged || curved.fit.degrees <= 0) return;
  const double gained = from.fit.sum_of_squares() - curved.fit.sum_of_squares();
  const double more =
      std::max(1., double(curved.fit.freedom.active.size()) - double(from.fit.freedom.active.size()));
  if (!(curved.fit.variance < 0.5 * from.fit.variance) ||
      fisher_tail(gained / more / curved.fit.variance, more, curved.fit.degrees) >= kRejected)
    return;
  out.stages.push_back(std::move(curved));
  out.closest = out.chosen = out.stages.size() - 1;
}

void compare_stages(Identification& out) {
  for (std::size_t i = 0; i < out.stages.size(); ++i) {
    if (out.stages[i].fit.converged && out.stages[i].fit.variance < out.stages[out.closest].fit.variance)
      out.closest = i;
  }
  const Fit& closest = out.stages[out.closest].fit;
  for (StageFit& one : out.stages) one.probability = probability_of(one.fit, closest);
  out.chosen = out.closest;
  for (std::size_t i = 0; i < out.stages.size(); ++i) {
    const StageFit &one = out.stages[i], &so_far = out.stages[out.chosen];
    if (one.probability < kRejected) continue;
    const auto unknowns = one.fit.freedom.active.size(), fewest = so_far.fit.freedom.active.size();
    if (unknowns < fewest || (unknowns == fewest && one.fit.sum_of_squares() < so_far.fit.sum_of_squares()))
      out.chosen = i;
  }
}

}  // namespace

double probability_of(const Fit& one, const Fit& closest) {
  if (!one.converged) return 0;
  const double worse = one.sum_of_squares() - closest.sum_of_squares();
  const double more = std::max(1., double(closest.freedom.active.size()) - double(one.freedom.active.size()));
  return worse > 0 ? fisher_tail(worse / more / closest.variance, more, closest.degrees) : 1;
}

const char* to_string(Stage stage) {
  switch (stage) {
    case Stage::half_way:
      return "half_way";
    case Stage::one_xi:
      return "one_xi";
    case Stage::two_xi:
      return "two_xi";
    case Stage::cubic:
      return "cubic";
    case Stage::per_pair:
      return "per_pair";
    default:
      return "axis_laws";
  }
}

Freedom freedom_of(Stage stage, Kind kind) {
  Freedom out;
  std::iota(out.source.begin(), out.source.end(), 0);
  out.active = linear_places(kind);
  if (kind == Kind::linear) return out;  // nothing turns: there is no second order
  const bool has_forces = kind == Kind::linear_angular;
  const auto follow = [&](int first, int place) {
    for (int i = 0; i < 3; ++i) out.source[std::size_t(first + i)] = place;
  };
  switch (stage) {
    case Stage::half_way:
      break;
    case Stage::one_xi:
      add(out.active, kXiAngular, 1);
      follow(kXiAngular, kXiAngular), follow(kXiLinear, kXiAngular);
      break;
    case Stage::two_xi:
      add(out.active, kXiAngular, 1), follow(kXiAngular, kXiAngular);
      if (has_forces) add(out.active, kXiLinear, 1);
      follow(kXiLinear, kXiLinear);
      break;
    case Stage::cubic:
      add(out.active, kCubic, 1);
      if (has_forces) add(out.active, kXiLinear, 3);
      break;
    default:
      add(out.active, kXiAngular, 3);
      if (has_forces) add(out.active, kXiLinear, 3);
  }
  return out;
}

const StageFit& Identification::stage(Stage which) const {
  const auto found =
      std::find_if(stages.begin(), stages.end(), [&](const StageFit& one) { return one.stage == which; });
  return found == stages.end() ? stages.back() : *found;
}

namespace {

/// Of stiffness what the stage that is shown leaves open, of second order what per_pair does.
void name_open(const Data& data, Identification& out) {
  const StageFit &shown = out.chosen_stage(), &rich = out.stage(Stage::per_pair);
  const auto name = [&](const StageFit& from, bool second_order) {
    for (const Dropped& one : from.left_open) {
      const bool is_second = one.place >= kXiAngular && one.place < kCubic;
      if (is_second != second_order || one.place >= kCubic) continue;
      out.left_open.push_back(
          {one.place, name_of(one.place), reason_of(one, data, out.frame, from.fit, maker(out.frame))});
    }
  };
  name(shown, false);
  if (data.kind != Kind::linear) name(rich, true);
}

/// The stiffness alone, and what the data do not tell of it by small motion.
struct Stiffness {
  Frame frame;
  std::vector<Dropped> never;
  StageFit fit;
};

void drop(std::vector<Dropped>& open, int first, int count) {
  for (int place = first; place < first + count; ++place) {
    if (!is_among(open, place)) open.push_back({place, std::nan("")});
  }
}

/// Of a half that is not loaded or not seen nothing is told, and no lever to it.
void drop_untold(const Data& data, LinearStart& start, std::vector<Dropped>& open) {
  if (data.kind != Kind::linear_angular) return;
  const bool no_forces = !why_none(data, 0).empty(), no_moments = !why_none(data, 3).empty();
  if (no_moments) drop(open, kAngularStiffness, 3), drop(open, kAngularAxes, 3);
  if (no_forces) drop(open, kLinearStiffness, 3), drop(open, kLinearAxes, 3);
  if (!no_forces && !no_moments) return;
  drop(open, kCoupling, kXiAngular - kCoupling);
  start.unknowns.segment<kXiAngular - kCoupling>(kCoupling).setZero();
}

Stiffness fit_stiffness(const Data& data, LinearStart start, std::vector<Dropped> never,
                        const std::array<double, kChannels>& sigma) {
  drop_untold(data, start, never);
  Stiffness out{start.frame, std::move(never), {}};
  Freedom freedom = freedom_of(Stage::half_way, data.kind);
  std::erase_if(freedom.active, [&](int place) { return is_among(out.never, place); });
  for (const Dropped& one : open_at_small_motion(data, maker(start.frame), start.unknowns, freedom))
    out.never.push_back(one);
  out.fit = fit_stage(Stage::half_way, data, start.frame, start.unknowns, out.never, sigma);
  return out;
}

/// Is what a fit leaves of each channel a small part of the motion? @param length  m: makes radians of metres
bool explains(const Data& data, const Fit& fit, double length) {
  constexpr double kSmall = 0.03;
  const auto size = sizes(data);
  // Displacements beside rotations, forces beside moments, and the reverse.
  const std::array<double, kChannels> scale = {length * size[1], size[0] / length, size[3] / length,
                                               length * size[2]};
  const std::vector<int> channel = channels(data);
  std::array<double, kChannels> sum{}, count{};
  for (std::size_t i = 0; i < channel.size(); ++i) {
    sum[std::size_t(channel[i])] += fit.residual[Eigen::Index(i)] * fit.residual[Eigen::Index(i)];
    count[std::size_t(channel[i])] += 1;
  }
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (count[c] > 0 && !(std::sqrt(sum[c] / count[c]) <= kSmall * std::max(size[c], scale[c]))) return false;
  }
  return true;
}

/// Where loads do not tell the principal axes: those of the data, if these explain as much. Else what is open
/// is what was assumed of the rest, in axes that nobody chose.
Stiffness fit_stiffness(const Data& data, const std::array<double, kChannels>& sigma) {
  const Stiffness general = fit_stiffness(data, linear_start(data), {}, sigma);
  const bool tells_all = std::none_of(general.never.begin(), general.never.end(),
                                      [](const Dropped& one) { return one.place < kCoupling; });
  if (tells_all) return general;
  std::vector<Dropped> axes;
  for (int i = 0; i < 3; ++i) {
    if (data.kind != Kind::linear) axes.push_back({kAngularAxes + i, std::nan("")});
    if (data.kind != Kind::angular) axes.push_back({kLinearAxes + i, std::nan("")});
  }
  Stiffness plain = fit_stiffness(data, linear_start_along_axes(data), axes, general.fit.fit.sigma);
  const bool is_as_good = plain.fit.fit.variance < 4 * general.fit.fit.variance ||
                          explains(data, plain.fit.fit, plain.frame.length);
  if (!plain.fit.fit.converged || !is_as_good) return general;
  plain.fit = fit_stage(Stage::half_way, data, plain.frame, plain.fit.fit.p, plain.never, sigma);
  return plain;
}

}  // namespace

Identification identify(const Data& data, bool with_catalog) {
  check(data);
  Identification out;
  const std::array<double, kChannels>& given = data.sigma;
  // First the stiffness; what it leaves open stays so. Its axes are the frame of what follows.
  auto [frame, never, linear] = fit_stiffness(data, given);
  out.frame = frame;
  set_range(data, out.frame);
  check_enough(data, linear.fit);
  drop_second_order(linear.left_open);
  Unknowns p = linear.fit.p;
  rebase(out.frame, p);
  // Most is asked first: its residual is the noise that the others are judged by.
  StageFit rich = fit_stage(Stage::per_pair, data, out.frame, p, linear.left_open, given);
  check_enough(data, rich.fit);
  p = rich.fit.p;
  rebase(out.frame, p);
  out.sigma = rich.fit.sigma;
  for (const Stage stage : kStages) {
    if (stage == Stage::two_xi && data.kind != Kind::linear_angular) continue;
    if (stage != Stage::per_pair && stage != Stage::half_way && data.kind == Kind::linear) continue;
    Unknowns from = p;
    if (stage != Stage::per_pair) from.segment<6>(kXiAngular).setConstant(0.5);
    out.stages.push_back(fit_stage(stage, data, out.frame, from, linear.left_open, out.sigma));
  }
  compare_stages(out);
  try_axis_laws(data, never, out);
  name_open(data, out);
  for (double& sigma : out.sigma) sigma *= std::sqrt(out.stages[out.closest].fit.variance);
  if (with_catalog) fit_catalog(data, out);
  return out;
}

}  // namespace halfway::reference::identify
