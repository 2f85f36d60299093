// One question to a joint, whoever answers: a law of ours, a file of answers, another program.
#pragma once

#include "halfway/programs/situation.hpp"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>
#include <vector>

namespace halfway::reference {

/// A body and the joint's end on it, in double as a program is told: positions m, unit quaternions (w, x, y,
/// z).
struct AskedBody {
  Vec3<double> x = Vec3<double>::Zero();
  Eigen::Vector4d q{1, 0, 0, 0};  ///< body axes -> global axes
  Vec3<double> o = Vec3<double>::Zero();
  Eigen::Vector4d h{1, 0, 0, 0};  ///< joint axes -> body axes
  double mass = 1, inertia = 1;   ///< kg, kg m2 of a ball
};

/// Where both bodies were before.
struct RoadPose {
  Vec3<double> x_a, x_b;
  Eigen::Vector4d q_a, q_b;
};

/// Two poses and the springs along the joint axes, N/m and N m/rad.
struct Ask {
  AskedBody a, b;
  Mat3<double> K_f = Mat3<double>::Zero(), K_m = Mat3<double>::Zero();
  Mat3<double> K_fm = Mat3<double>::Zero();  ///< forces by turns, and transposed moments by moves: N/rad
  bool is_bond = false;  ///< the joint points rest apart along z (halfway/programs/lines.hpp), else together
  std::vector<RoadPose> road{};  ///< of a joint with a memory: the poses before, unloaded at the first
};

/// Loads f_a, m_a, f_b, m_b about the bodies' origins, global axes.
using TwelveLoads = programs::TwelveLoads<double>;
/// The i-th of f_a, m_a, f_b, m_b.
inline Vec3<double> part(const TwelveLoads& q, int i) { return q.segment<3>(3L * i); }

using Answerer = std::function<TwelveLoads(const Ask&)>;

/// A question and what a program said to it.
struct Answered {
  Ask ask;
  TwelveLoads loads;
};

/// The same in scalar T; quaternions are made of length one there.
template <class T>
programs::Situation<T> situation(const Ask& ask);
extern template programs::Situation<double> situation(const Ask&);

/// The request of `halfway eval`, without id and formulation.
nlohmann::ordered_json request(const Ask& ask);

/// A body {x, q, o, h} and a whole question as they stand in a request; o, h, mass and inertia may be
/// missing. Throws nlohmann::json::exception.
AskedBody read_body(const nlohmann::json& node);
Ask read_request(const nlohmann::json& request);

/// Product and conjugate of quaternions (w, x, y, z), and the one of a rotation vector.
Eigen::Vector4d times(const Eigen::Vector4d& p, const Eigen::Vector4d& q);
Eigen::Vector4d conjugate(const Eigen::Vector4d& q);
Eigen::Vector4d quaternion_of(const Vec3<double>& theta);
Mat3<double> matrix_of(const Eigen::Vector4d& q);

/// Body b put so that frame b is turned by theta and moved by p (axes of frame a) from frame a.
void place_b(Ask& ask, const Vec3<double>& theta, const Vec3<double>& p);

}  // namespace halfway::reference
