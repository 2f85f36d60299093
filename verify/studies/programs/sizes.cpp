// Sizes of defects of random poses, as others measured them: of the same kind of poses, so of the same size.
#include "reference/numbers/random.hpp"
#include "reference/programs/measured.hpp"
#include "verify/studies/programs/subject.hpp"

#include <algorithm>
#include <cmath>

namespace halfway::verify {
namespace {

using reference::Ask;

constexpr double kTwice = 2;
constexpr const char* kRandom =
    "over the printed size: other random poses of the same range, within a factor of two";

Finding compared(const char* what, const char* joint, double measured, double printed) {
  // The logarithm, so that half is as far as twice.
  return program_finding(what, joint)
      .measured(std::abs(std::log(measured / printed)), fmt::format("{:.3g}, printed {}", measured, printed))
      .in("log of the ratio")
      .at_most(std::log(kTwice), kRandom)
      .by(Oracle::other_program, std::log(kTwice));
}

/// Of turns by 0.8 rad: the largest change by the order of the bodies, K_m = (1, 10, 100), over the moment,
/// and the largest tensoriality error, K_m = 1; the same error of turns up to 1.3 rad. 0: not printed, and of
/// febio_generic's order, whose moment nearly vanishes at some turns, so that its largest ratio is chance.
struct Size {
  const char* joint;
  double order, tensoriality, wider;
};
constexpr Size kSizes[] = {
    {"attached_a", .76, 0, 0},    {"bullet_6dof", 3.6, .50, .59},   {"bullet_default", 0, 0, .45},
    {"newton_d6", 3.0, .57, 0},   {"newton_rod", .42, .24, 0},      {"physx_swing_twist", 5.6, .39, .49},
    {"jolt_6dof", .75, 0, 0},     {"rapier_asin", .76, .018, .032}, {"mbsim_offdiag", 3.2, .57, 0},
    {"febio_generic", 0, 3.2, 0}, {"ode_amotor", 0, 0, .61},        {"havok", 0, 0, .14},
    {"simbody_xyz", 0, 0, .85},   {"abaqus_bushing", 0, .029, 0}};

std::vector<Ask> random_turns() {
  reference::Generator g(20115);
  std::vector<Ask> out(200);
  for (Ask& ask : out) {
    ask.K_m = Vec3<double>(1, 10, 100).asDiagonal();
    ask.b.q = reference::quaternion_of(0.8 * g.direction());
  }
  return out;
}

/// |m(Q R Q^T) - Q m(R)| / |m(R)|, the largest of those turns, each with a Q of its own.
double tensor_error(const reference::Answerer& answer) {
  reference::Generator g(20116);
  Measurement worst;
  for (Ask ask : random_turns()) {
    ask.K_m.setIdentity();
    const Vec3<double> m = reference::part(answer(ask), 3);
    const Mat3<double> Q = g.rotation(0.1, 3);
    ask.b.q.tail<3>() = Q * Vec3<double>(ask.b.q.tail<3>());
    worst.include((Vec3<double>(reference::part(answer(ask), 3)) - Q * m).norm() / m.norm(), "");
  }
  return worst.value();
}

std::vector<Finding> of_turns(const Size& s) {
  const auto answer = program_subject(s.joint);
  std::vector<Finding> out;
  if (s.order > 0)
    out.push_back(compared("size/order", s.joint, body_order(answer, random_turns()).worst.value(), s.order));
  if (s.tensoriality > 0)
    out.push_back(compared("size/tensoriality", s.joint, tensor_error(answer), s.tensoriality));
  if (s.wider > 0)
    out.push_back(compared("size/tensoriality_wider", s.joint, tensoriality(answer).worst.value(), s.wider));
  return out;
}

/// Medians over the poses at which programs were measured, two thirds of which are kept. 0: none.
struct Median {
  const char* answers;
  const char* joint;
  double balance, order;
};
constexpr Median kMedians[] = {{"simbody", "simbody_xyz", 0, .83},
                               {"bullet_old", "bullet_6dof", .28, .70},
                               {"bullet_old_nooffset", "bullet_6dof_at_b", 0, .84},
                               {"bullet_default", "bullet_default", .32, .80},
                               {"dart_free", "dart_free", 0, 1.1},
                               {"dart_ball", "attached_b", 0, .27},
                               {"physx_swing_twist", "physx_swing_twist", 0, .83},
                               {"physx_slerp", "physx_slerp", 0, .80},
                               {"jolt", "jolt_6dof", 0, .87},
                               {"rapier", "rapier_asin", 0, .86},
                               {"ode_amotor", "ode_amotor", 0, .16},
                               {"havok", "havok", 0, .86}};

using Property = reference::Defect (*)(const reference::Answerer&, const std::vector<Ask>&);

double median_of(const Median& m, Property property) {
  const auto answer = program_subject(m.joint);
  std::vector<double> all;
  for (const auto& pose : reference::read_measured(m.answers).poses)
    all.push_back(property(answer, {pose.ask}).worst.value());
  if (std::ranges::any_of(all, [](double x) { return std::isnan(x); })) return std::nan("");
  std::ranges::sort(all);
  const std::size_t half = all.size() / 2;
  return (all[half] + all[all.size() - 1 - half]) / 2;
}

std::vector<Finding> of_poses(const Median& m) {
  std::vector<Finding> out;
  if (m.balance > 0)
    out.push_back(
        compared("size/median_balance", m.answers, median_of(m, reference::moment_balance), m.balance));
  out.push_back(compared("size/median_order", m.answers, median_of(m, reference::body_order), m.order));
  return out;
}

template <class Rows, class Of>
std::vector<Finding> all_of(const Rows& rows, const Of& of) {
  std::vector<Finding> out;
  for (const auto& row : rows)
    for (const Finding& f : of(row)) out.push_back(f);
  return out;
}

}  // namespace

void program_sizes(Checks& checks) {
  checks.push_back({"programs/sizes", "", [] { return all_of(kSizes, of_turns); }});
  checks.push_back({"programs/medians", "", [] { return all_of(kMedians, of_poses); }});
}

}  // namespace halfway::verify
