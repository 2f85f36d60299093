#include "reference/programs/convention.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace halfway::reference {
namespace {

Eigen::Vector4d heard_quaternion(const Eigen::Vector4d& q, Hearing hearing) {
  if (hearing == Hearing::transposed) return conjugate(q);
  if (hearing == Hearing::scalar_last) return {q[3], q[0], q[1], q[2]};
  return q;
}

/// Every quaternion of the question, and of the road to it.
template <class Change>
void change_quaternions(Ask& ask, const Change& change) {
  for (AskedBody* body : {&ask.a, &ask.b}) body->q = change(body->q), body->h = change(body->h);
  for (RoadPose& pose : ask.road) pose.q_a = change(pose.q_a), pose.q_b = change(pose.q_b);
}

/// From the point that moments are about to the node.
Vec3<double> lever_of(Point point, const AskedBody& body, const Ask& ask) {
  if (point == Point::joint_points) return -(matrix_of(body.q) * body.o);
  if (point == Point::origin) return body.x;
  if (point == Point::node_a) return body.x - ask.a.x;
  return Vec3<double>::Zero();
}

Mat3<double> axes_of(Axes axes, const AskedBody& body, const Ask& ask) {
  return axes == Axes::own_node ? matrix_of(body.q) : matrix_of(times(ask.a.q, ask.a.h));
}

/// The question that is heard as it is meant.
Ask as_heard(const Ask& meant, Hearing hearing) {
  if (hearing != Hearing::scalar_last) return heard(meant, hearing);  // the others are their own inverses
  Ask out = meant;
  change_quaternions(out, [](const Eigen::Vector4d& q) { return Eigen::Vector4d(q[1], q[2], q[3], q[0]); });
  return out;
}

/// Loads on the bodies that were meant, in their words, made ours.
TwelveLoads in_our_words(const TwelveLoads& loads, const Ask& meant, const Convention& c) {
  TwelveLoads out;
  for (int node = 0; node < 2; ++node) {
    const AskedBody& body = node == 0 ? meant.a : meant.b;
    Vec3<double> f = part(loads, 2 * node + c.moments_first), m = part(loads, 2 * node + !c.moments_first);
    if (c.axes != Axes::global) {
      const Mat3<double> axes = axes_of(c.axes, body, meant);
      f = axes * f;
      m = axes * m;
    }
    f /= c.force_scale;
    m /= c.moment_scale;
    const Vec3<double> lever = lever_of(c.point, body, meant);
    out.segment<3>(6 * node) = f;
    out.segment<3>(6 * node + 3) = m - lever.cross(f);
  }
  return out;
}

std::string scale_words(const char* what, double scale) {
  const double size = std::abs(scale);
  if (std::abs(size * std::numbers::pi / 180 - 1) < 1e-3)
    return fmt::format("{} are 180/pi times as large: degrees", what);
  if (std::abs(size * 180 / std::numbers::pi - 1) < 1e-3)
    return fmt::format("{} are pi/180 times as large: degrees", what);
  return fmt::format("{} are {:.4g} times as large", what, size);
}

}  // namespace

std::vector<std::string> Convention::words() const {
  std::vector<std::string> out;
  constexpr const char* kHearings[] = {
      "", "rotations are taken the other way round (transposed matrix, conjugate quaternion)",
      "quaternions are read as (x, y, z, w)", "K is read with the rotations first",
      "bodies a and b are exchanged"};
  constexpr const char* kPoints[] = {"", "moments are about the joint points",
                                     "moments are about the global origin", "both moments are about node a"};
  constexpr const char* kAxes[] = {"", "loads are along the axes of their own node",
                                   "loads are along the axes of joint frame a"};
  const auto say = [&](const char* text) {
    if (*text != '\0') out.emplace_back(text);
  };
  say(kHearings[int(hearing)]);
  say(kPoints[int(point)]);
  say(kAxes[int(axes)]);
  if (answers_exchanged) say("the loads of a are given as those of b");
  if (moments_first) say("moments stand before forces");
  if (force_scale < 0 && moment_scale < 0)
    say("loads are those on the bodies");
  else if (force_scale < 0)
    say("forces have the opposite sign of the moments");
  else if (moment_scale < 0)
    say("moments have the opposite sign of the forces");
  if (std::abs(force_scale) != 1) out.push_back(scale_words("forces", force_scale));
  if (std::abs(moment_scale) != 1) out.push_back(scale_words("moments", moment_scale));
  return out;
}

int Convention::oddities() const {
  return 2 * (hearing != Hearing::as_asked) + (point != Point::nodes) + (axes != Axes::global) +
         moments_first + answers_exchanged + (force_scale * moment_scale < 0) + (std::abs(force_scale) != 1) +
         (std::abs(moment_scale) != 1);
}

std::vector<Convention> conventions() {
  std::vector<Convention> out;
  for (const auto hearing : {Hearing::as_asked, Hearing::transposed, Hearing::scalar_last,
                             Hearing::rotation_first, Hearing::bodies_exchanged})
    for (const auto point : {Point::nodes, Point::joint_points, Point::origin, Point::node_a})
      for (const auto axes : {Axes::global, Axes::own_node, Axes::joint_frame_a})
        for (const bool moments_first : {false, true})
          for (const bool answers_exchanged : {false, true})
            out.push_back({hearing, point, axes, moments_first, answers_exchanged});
  return out;
}

Ask heard(const Ask& ask, Hearing hearing) {
  Ask out = ask;
  change_quaternions(out, [&](const Eigen::Vector4d& q) { return heard_quaternion(q, hearing); });
  if (hearing == Hearing::rotation_first) std::swap(out.K_f, out.K_m), out.K_fm.transposeInPlace();
  if (hearing == Hearing::bodies_exchanged) {
    std::swap(out.a, out.b);
    for (RoadPose& pose : out.road) std::swap(pose.x_a, pose.x_b), std::swap(pose.q_a, pose.q_b);
  }
  return out;
}

TwelveLoads exchanged(const TwelveLoads& q) {
  TwelveLoads out;
  out << q.tail<6>(), q.head<6>();
  return out;
}

/// Our loads as a program of this convention gives them, scales apart.
TwelveLoads in_their_words(const TwelveLoads& q, const Ask& ask, const Convention& c) {
  TwelveLoads out = q;
  for (int node = 0; node < 2; ++node) {
    const AskedBody& body = node == 0 ? ask.a : ask.b;
    Vec3<double> f = part(q, 2 * node), m = part(q, 2 * node + 1);
    m += lever_of(c.point, body, ask).cross(f);
    if (c.axes != Axes::global) {
      const Mat3<double> axes = axes_of(c.axes, body, ask);
      f = axes.transpose() * f;
      m = axes.transpose() * m;
    }
    out.segment<3>(6 * node) = c.moments_first ? m : f;
    out.segment<3>(6 * node + 3) = c.moments_first ? f : m;
  }
  return out;
}

Answerer spoken(const Answerer& joint, const Convention& convention) {
  return [joint, c = convention](const Ask& ask) -> TwelveLoads {
    const Ask seen = heard(ask, c.hearing);
    TwelveLoads q = in_their_words(joint(seen), seen, c);
    for (int i = 0; i < 4; ++i) {
      const bool is_force = (i % 2 == 0) != c.moments_first;
      q.segment<3>(3 * i) *= is_force ? c.force_scale : c.moment_scale;
    }
    const bool is_exchanged = (c.hearing == Hearing::bodies_exchanged) != c.answers_exchanged;
    return is_exchanged ? exchanged(q) : q;
  };
}

Answerer translated(const Answerer& program, const Convention& convention) {
  return [program, c = convention](const Ask& meant) -> TwelveLoads {
    const TwelveLoads answer = program(as_heard(meant, c.hearing));
    const bool is_exchanged = (c.hearing == Hearing::bodies_exchanged) != c.answers_exchanged;
    return in_our_words(is_exchanged ? exchanged(answer) : answer, meant, c);
  };
}

}  // namespace halfway::reference
