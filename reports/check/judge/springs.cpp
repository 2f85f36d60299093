#include "reports/check/judge/springs.hpp"

#include "reference/numbers/random.hpp"

#include <fmt/format.h>
#include <Eigen/LU>

#include <cmath>

namespace halfway::check {
namespace {

using reference::Candidate;
using reference::part;
using reference::Springs;

/// Stiffest over softest; the stiffest is as usual, N/m and N m/rad, so that nothing moves faster than
/// programs bear.
constexpr double kRatio = 1e12, kStiffest = 100, kSoftest = kStiffest / kRatio;

Result left_out(Result r, std::string why) {
  r.where = std::move(why);
  return r;
}

/// How large loads are of this pose, if every spring is as stiff as the stiffest: what a rounding of it
/// makes.
Ask as_stiff_all_round(Ask ask) {
  ask.K_f = ask.K_f.maxCoeff() * Mat3<double>::Identity();
  ask.K_m = ask.K_m.maxCoeff() * Mat3<double>::Identity();
  ask.K_fm.setZero();
  return ask;
}

/// Largest difference of two answers, of forces or of moments, over the size of such.
double difference(const TwelveLoads& ours, const TwelveLoads& theirs, const TwelveLoads& size) {
  const TwelveLoads off = theirs - ours;
  const auto both = [](const TwelveLoads& q, int i) {
    return std::hypot(part(q, i).norm(), part(q, i + 2).norm());
  };
  const double forces = both(size, 0) > 0 ? both(off, 0) / both(size, 0) : both(off, 0);
  return reference::larger(forces, both(off, 1) / both(size, 1));
}

/// The largest difference from the law.
Result compared(Result r, const Answerer& joint, const Candidate& law, const std::vector<Ask>& asks,
                double limit) {
  reference::Measurement worst;
  for (std::size_t i = 0; i < asks.size(); ++i) {
    const TwelveLoads theirs = joint(asks[i]), ours = law.answer(asks[i]),
                      size = law.answer(as_stiff_all_round(asks[i]));
    if (!ours.allFinite()) return left_out(r, "the law itself has no answer in double precision");
    if (worst.include(difference(ours, theirs, size), fmt::format("question {} from {}", i + 1, law.name)))
      r.at = asks[i];
  }
  return held(r, worst.value(), limit, worst.where());
}

/// No more than the softest direction's.
double soft_bound(const Mat3<double>& K) { return 1 / K.inverse().norm(); }

/// Springs whose stiffness has full 3 x 3 blocks; with `moves` the two are coupled, too, weakly enough for
/// any definite matrix.
std::vector<Ask> coupled(const Hello& hello, bool moves) {
  auto asks = generic_poses(hello, 8, 0.1, 1.3, Springs::full);
  reference::Generator g(20114);
  for (Ask& ask : asks) {
    if (!moves) continue;
    const double most = 0.1 * std::sqrt(soft_bound(ask.K_f) * soft_bound(ask.K_m));
    for (double& k : ask.K_fm.reshaped()) k = most * g.uniform(-1, 1);
  }
  return asks;
}

/// Each axis in turn softest and stiffest, of moves and of turns.
std::vector<Ask> far_apart(const Hello& hello) {
  auto asks = generic_poses(hello, 6, 0.2, 1.2, Springs::diagonal);
  for (std::size_t i = 0; i < asks.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      asks[i].K_m(long(axis), long(axis)) = kSoftest * std::pow(kRatio, double((axis + i) % 3) / 2);
      if (hello.linear_angular)
        asks[i].K_f(long(axis), long(axis)) = kSoftest * std::pow(kRatio, double((2 * axis + i) % 3) / 2);
    }
  }
  return asks;
}

/// A turn about the soft axis alone.
Ask soft_turn(const Hello& hello, int axis) {
  Ask ask;
  ask.K_m = kStiffest * Mat3<double>::Identity();
  ask.K_m(axis, axis) = kSoftest;
  if (hello.linear_angular) ask.K_f = Mat3<double>::Identity();
  ask.b.q = reference::quaternion_of(0.3 * Vec3<double>::Unit(axis));
  return ask;
}

Result soft_axis(Result r, const Answerer& joint, const Hello& hello, const Candidate& law) {
  reference::Measurement worst;
  for (int axis = 0; axis < 3; ++axis) {
    const Ask ask = soft_turn(hello, axis);
    const double theirs = part(joint(ask), 3)[axis], ours = part(law.answer(ask), 3)[axis];
    if (worst.include(std::abs(theirs - ours) / std::abs(ours), fmt::format("about {}", "xyz"[axis])))
      r.at = ask;
  }
  // A rounding of the turn about a stiff axis, 1e-16 rad, makes 1e-4 of the soft one's moment.
  return held(r, worst.value(), 1e-3, worst.where());
}

}  // namespace

std::vector<Result> examine_springs(const Answerer& joint, const Hello& hello,
                                    const std::optional<Candidate>& law) {
  const double limit = tolerance(hello);
  Result axes{"level2/coupled_axes", "springs along other axes than the joint's are those of its law",
              "loads(K), K_f and K_m full"};
  Result moves{"level2/coupled_moves", "springs that couple moves and turns are those of its law",
               "loads(K), K of 6 x 6"};
  Result ratio{"level4/stiffness_ratio", "stiffnesses 1e12 apart are those of its law",
               "loads(K), K = diag(1, 1e6, 1e12)"};
  Result soft{"level4/soft_axis", "beside stiffnesses 1e12 times its own a soft axis is as soft as asked",
              "m = k theta"};
  const bool is_full = hello.springs == Hello::Springs::full;
  const bool is_one = hello.springs == Hello::Springs::isotropic;
  if (!law) {
    for (Result* r : {&axes, &moves, &ratio, &soft}) *r = left_out(*r, "who it is is not known");
    return {axes, moves, ratio, soft};
  }
  constexpr const char* kSays = "it says that it takes no such springs";
  constexpr const char* kFew = "its digits do not tell";
  constexpr double kDouble = 12, kEnough = 15;  // of loads 1e12 apart, of the small one beside
  axes = is_full ? compared(axes, joint, *law, coupled(hello, false), limit) : left_out(axes, kSays);
  if (!is_full || !hello.linear_angular)
    moves = left_out(moves, kSays);
  else if (!law->couples)
    moves = left_out(moves, fmt::format("{} is known without them", law->name));
  else
    moves = compared(moves, joint, *law, coupled(hello, true), limit);
  if (is_one) {
    ratio = left_out(ratio, kSays), soft = left_out(soft, kSays);
  } else {
    ratio = hello.digits < kDouble ? left_out(ratio, kFew)
                                   : compared(ratio, joint, *law, far_apart(hello), limit);
    soft = hello.digits < kEnough ? left_out(soft, kFew) : soft_axis(soft, joint, hello, *law);
  }
  return {axes, moves, ratio, soft};
}

}  // namespace halfway::check
