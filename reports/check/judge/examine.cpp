#include "reports/check/judge/examine.hpp"

#include "reference/programs/path_joints.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace halfway::check {
namespace {

constexpr const char *kFar = "level4/far", *kEnds = "level2/ends";
/// What 1e3 m beside joints of 0.3 m leave of the digits.
constexpr double kFarLoss = 1e4;

using reference::Springs;
using reference::times;

Springs springs_of(const Hello& hello) {
  return hello.springs == Hello::Springs::isotropic ? Springs::isotropic : Springs::diagonal;
}

/// As the program can be asked.
std::vector<Ask> adapted(std::vector<Ask> asks, const Hello& hello) {
  for (Ask& ask : asks) {
    if (hello.springs == Hello::Springs::isotropic)
      ask.K_f = ask.K_m = ask.K_m(0, 0) * Mat3<double>::Identity();
    if (hello.frames && hello.linear_angular) continue;
    // Body b is moved so that the joint frames lie as they lay.
    const Vec3<double> theta =
        so3::log<double>(Mat3<double>(reference::matrix_of(times(ask.a.q, ask.a.h)).transpose() *
                                      reference::matrix_of(times(ask.b.q, ask.b.h))));
    if (!hello.frames) ask.b.o.setZero(), ask.b.h = Eigen::Vector4d(1, 0, 0, 0);
    if (!hello.ends) ask.a.o.setZero(), ask.a.h = Eigen::Vector4d(1, 0, 0, 0);
    if (!hello.linear_angular) ask.K_f.setZero();
    reference::place_b(ask, theta,
                       hello.linear_angular ? Vec3<double>(0.2, -0.1, 0.15) : Vec3<double>(0, 0, 0));
  }
  return asks;
}

std::vector<Ask> poses(const Hello& hello, int count, double least, double largest, bool bond) {
  return generic_poses(hello, count, least, largest, springs_of(hello), bond);
}

/// Of the questions that were answered; how many were not is said.
Result of_single(const Single& s, const Answerer& joint, const std::vector<Ask>& asks, double limit) {
  std::vector<Ask> answered;
  for (const Ask& ask : asks)
    if (!std::isnan(s.defect(joint, {ask}).worst.value())) answered.push_back(ask);
  const reference::Defect defect = s.defect(joint, answered);
  Result r = held({s.id, s.title, s.law}, defect.worst.value(), limit, defect.worst.where());
  if (r.status == Status::fail) r.at = defect.at;
  if (r.status != Status::left_out && answered.size() < asks.size())
    r.where += fmt::format(", of {} poses {} answered", asks.size(), answered.size());
  return r;
}

/// The secant stiffness about each axis, from 1e-6 to 0.1 rad: one.
Result stiffness(const Answerer& joint, const Hello& hello) {
  reference::Measurement worst;
  const double least = std::pow(10, -hello.digits / 2.6);  // below, its digits do not tell
  for (int axis = 0; axis < 3; ++axis) {
    for (const double phi : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1}) {
      const double seen = reference::secant_stiffness(joint, axis, phi, hello.linear_angular ? 1 : 0);
      if (phi >= least)
        worst.include(std::abs(seen - 1),
                      fmt::format("{:.3g} of it about {} at {} rad", seen, "xyz"[axis], phi));
    }
  }
  // cos(0.1) = 0.995, and sin and tan of it are a third of that away.
  return held({"level1/stiffness", "small turns meet the stiffness asked for", "m = K theta"}, worst.value(),
              0.006, worst.where());
}

Result loop(const Answerer& joint, const char* id, const char* title, const Vec3<double>& k_f,
            const Vec3<double>& k_m, bool moves, double limit) {
  const double work = reference::loop_work(joint, k_f, k_m, moves);
  return held({id, title, "closed path: sum of m . w + f . v dt = 0"}, std::abs(work), limit,
              fmt::format("{:+.3g} of the path", work));
}

void add_loops(std::vector<Result>& out, const Answerer& joint, const Hello& hello, double limit) {
  const Vec3<double> none(0, 0, 0), one(10, 10, 10), three(1, 10, 100), hundred(100, 100, 100);
  const bool is_one = hello.springs == Hello::Springs::isotropic;
  const Vec3<double> still = is_one && hello.linear_angular ? one : none;
  out.push_back(loop(joint, "level3/loop_one", "one stiffness does no work round a loop of turns", still, one,
                     false, limit));
  if (!is_one)
    out.push_back(loop(joint, "level3/loop_three", "three stiffnesses do no work round a loop of turns", none,
                       three, false, limit));
  if (hello.linear_angular)
    out.push_back(loop(joint, "level3/loop_six",
                       "one stiffness each does no work round a loop of turns and moves",
                       is_one ? one : hundred, one, true, limit));
}

/// Of a joint with a memory, in place of the loops, whose work has no sense where loads are not of a pose.
Result closed_path(const Answerer& joint, const Hello& hello, double limit) {
  constexpr double kTilt = 0.4;
  Ask ask = reference::cone(kTilt);
  ask.K_m = Mat3<double>::Identity();
  if (hello.linear_angular) ask.K_f = ask.K_m;
  const double left = reference::part(joint(ask), 3).norm();
  return held({"level3/closed_path", "a closed road leaves nothing behind", "m(home again) = 0"}, left, limit,
              fmt::format("{:.3g} rad of the stiffness, after a cone of {} rad that encloses {:.3g}", left,
                          kTilt, 2 * std::numbers::pi * (1 - std::cos(kTilt))));
}

/// A turn about one axis up to 179 degrees: before which angle the moment falls.
Result range(const Answerer& joint, double k_f) {
  constexpr double kDegrees[] = {15, 30, 45, 60, 75, 89, 91, 105, 120, 150, 179};
  double least = 180;
  bool finite = true;
  std::string where = "on none of the axes before 179 degrees";
  for (int axis = 0; axis < 3; ++axis) {
    double last = 0, falls = 180;
    for (const double degrees : kDegrees) {  // all of them are asked, whatever the answers
      const double phi = degrees * std::numbers::pi / 180,
                   moment = phi * reference::secant_stiffness(joint, axis, phi, k_f);
      finite = finite && moment == moment;
      if (!(moment >= last) && falls == 180) falls = degrees;
      last = moment;
    }
    if (falls < least)
      least = falls, where = fmt::format("about {} the moment falls before {} degrees", "xyz"[axis], falls);
  }
  return held({"level4/range", "the moment grows with the angle up to 179 degrees", "dm/dphi >= 0"},
              finite ? 180 - least : NAN, 0, finite ? where : "not answered");
}

/// At the angles where measures end: an answer, whatever it is.
Result poles(const Answerer& joint, double k_f) {
  int missing = 0;
  std::string where;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double degrees : {90., 180.}) {
      const double moment = reference::secant_stiffness(joint, axis, degrees * std::numbers::pi / 180, k_f);
      if (moment == moment) continue;
      ++missing;
      where = fmt::format("none at {} degrees about {}", degrees, "xyz"[axis]);
    }
  }
  // Six of six: it does not answer such questions at all.
  return held({"level4/poles", "there is an answer at 90 and at 180 degrees about each axis", "loads finite"},
              missing == 6 ? NAN : missing, 0, where);
}

}  // namespace

Answerer along_road(const Hello& hello, const Answerer& joint) {
  if (!hello.path) return joint;
  return [joint](const Ask& ask) { return joint(reference::with_road(ask)); };
}

std::vector<Ask> generic_poses(const Hello& hello, int count, double least, double largest, Springs springs,
                               bool bond) {
  return adapted(reference::generic_asks(count, least, largest, springs, bond), hello);
}

Result held(Result r, double value, double limit, const std::string& where) {
  r.value = value;
  r.limit = limit;
  r.where = where;
  if (value != value) {
    r.status = Status::left_out;
    r.where = "not answered";
  } else {
    r.status = value <= limit ? Status::pass : Status::fail;
  }
  return r;
}

double tolerance(const Hello& hello) { return 100 * std::pow(10, -hello.digits); }

const std::vector<Single>& singles() {
  static const std::vector<Single> all{
      {"level3/force_balance", "what one body gets the other gives", "f_a + f_b = 0",
       &reference::force_balance},
      {"level3/moment_balance", "moments about one point add to zero", "m_a + m_b + (x_b - x_a) x f_b = 0",
       &reference::moment_balance},
      {"level3/body_order", "the order of the bodies does not matter", "loads(b, a) = loads(a, b), exchanged",
       &reference::body_order},
      {"level3/objectivity", "a rigid turn of both bodies turns the loads and does nothing else",
       "loads(Q a, Q b) = Q loads(a, b)", &reference::objectivity},
      {kEnds, "joint points and frames are another way to write where the bodies are",
       "loads(x, q, o, h) = loads(x + R o, q h, 0, 1), carried", &reference::ends},
      {"level3/masses", "masses and inertias do not matter", "loads(M) = loads(1)",
       &reference::mass_dependence},
      {"level3/proportionality", "four times the stiffness gives four times the loads",
       "loads(4 K) = 4 loads(K)", &reference::proportionality},
      {"level4/double_cover", "q and -q are one rotation", "loads(-q) = loads(q)", &reference::double_cover},
      {kFar, "a kilometre from the origin the loads are the same to the digits that are left",
       "loads(x + c) = loads(x)", &reference::far_away},
  };
  return all;
}

std::vector<Ask> identity_asks(const Hello& hello) {
  std::vector<Ask> out;
  const auto add = [&](const std::vector<Ask>& more) { out.insert(out.end(), more.begin(), more.end()); };
  add(poses(hello, 12, 0.05, 0.3, false));
  add(poses(hello, 12, 0.3, 1.3, false));
  if (hello.springs == Hello::Springs::isotropic) return out;
  auto partial = poses(hello, 6, 0.1, 1.2, false);  // springs that are off
  for (std::size_t i = 0; i < partial.size(); ++i) {
    partial[i].K_m(int(i % 3), int(i % 3)) = 0;
    if (i >= 3) partial[i].K_m(int((i + 1) % 3), int((i + 1) % 3)) = 0;
  }
  add(partial);
  return out;
}

std::vector<Ask> family_asks(const Hello& hello) {
  std::vector<Ask> out;
  for (Ask ask : poses(hello, 12, 0.2, 1.3, false)) {
    Ask turned = ask;
    ask.K_m.setZero();
    turned.K_f.setZero();
    if (hello.linear_angular) out.push_back(ask);
    out.push_back(turned);
  }
  return out;
}

std::vector<Result> examine(const Answerer& joint, const Hello& hello, bool as_bond) {
  std::vector<Result> out;
  const double limit = tolerance(hello);
  const auto asks = poses(hello, 16, 0.05, 1.3, as_bond);
  if (!as_bond) out.push_back(stiffness(joint, hello));
  for (const Single& s : singles()) {
    const bool needs_forces = std::string_view(s.id) == "level3/force_balance";
    const double allowed = std::string_view(s.id) == kFar ? kFarLoss * limit : limit;
    if (needs_forces && !hello.linear_angular) continue;
    if (std::string_view(s.id) == kEnds && !hello.ends)
      out.push_back({s.id, s.title, s.law, Status::left_out, NAN, NAN, "it says that it takes none"});
    else
      out.push_back(of_single(s, joint, asks, allowed));
  }
  if (as_bond) return out;
  if (hello.path)
    out.push_back(closed_path(joint, hello, limit));
  else
    add_loops(out, joint, hello, limit);
  const double k_f = hello.linear_angular ? 1 : 0;
  const auto tensor = reference::tensoriality(joint, k_f);
  out.push_back(held({"level2/tensoriality", "the measure knows no axes of its own", "e(Q R Q^T) = Q e(R)"},
                     tensor.worst.value(), limit, tensor.worst.where()));
  out.push_back(range(joint, k_f));
  out.push_back(poles(joint, k_f));
  return out;
}

}  // namespace halfway::check
