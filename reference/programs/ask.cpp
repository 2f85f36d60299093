#include "reference/programs/ask.hpp"

#include "reference/numbers/precision.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace halfway::reference {
namespace {

template <class T>
Mat3<T> turned(const Eigen::Vector4d& q) {
  using std::sqrt;
  Vec3<T> v;
  T square = T(q[0]) * T(q[0]);
  for (int i = 0; i < 3; ++i) {
    v[i] = T(q[i + 1]);
    square += v[i] * v[i];
  }
  const T length = sqrt(square);
  return so3::matrix<T>({T(q[0]) / length, Vec3<T>(v / length)});
}

nlohmann::json list(const auto& values) {
  return std::vector<double>(values.data(), values.data() + values.size());
}

nlohmann::json node(const AskedBody& body) {
  return {{"x", list(body.x)}, {"q", list(body.q)}, {"o", list(body.o)}, {"h", list(body.h)}};
}

}  // namespace

template <class T>
programs::Situation<T> situation(const Ask& ask) {
  programs::Situation<T> s;
  s.a = {ask.a.x.cast<T>(), turned<T>(ask.a.q)};
  s.b = {ask.b.x.cast<T>(), turned<T>(ask.b.q)};
  s.end_a = {ask.a.o.cast<T>(), turned<T>(ask.a.h)};
  s.end_b = {ask.b.o.cast<T>(), turned<T>(ask.b.h)};
  s.K_f = ask.K_f.cast<T>();
  s.K_m = ask.K_m.cast<T>();
  s.mass_a = T(ask.a.mass), s.mass_b = T(ask.b.mass);
  s.inertia_a = T(ask.a.inertia), s.inertia_b = T(ask.b.inertia);
  return s;
}
template programs::Situation<double> situation(const Ask&);
template programs::Situation<Real50> situation(const Ask&);

nlohmann::ordered_json request(const Ask& ask) {
  Eigen::Matrix<double, 6, 6, Eigen::RowMajor> K = Eigen::Matrix<double, 6, 6>::Zero();
  K.topLeftCorner<3, 3>() = ask.K_f;
  K.bottomRightCorner<3, 3>() = ask.K_m;
  K.topRightCorner<3, 3>() = ask.K_fm;
  K.bottomLeftCorner<3, 3>() = ask.K_fm.transpose();
  auto rows = nlohmann::json::array();
  for (int i = 0; i < 6; ++i) rows.push_back(list(Eigen::Matrix<double, 6, 1>(K.row(i).transpose())));
  nlohmann::ordered_json out{{"kind", "linear_angular"},
                             {"law", {{"type", "linear"}, {"K", rows}}},
                             {"a", node(ask.a)},
                             {"b", node(ask.b)}};
  const bool is_usual = ask.a.mass == 1 && ask.b.mass == 1 && ask.a.inertia == 1 && ask.b.inertia == 1;
  if (!is_usual) {
    out["mass"] = {ask.a.mass, ask.b.mass};
    out["inertia"] = {ask.a.inertia, ask.b.inertia};
  }
  for (const RoadPose& pose : ask.road) {
    out["path"].push_back({{"a", {{"x", list(pose.x_a)}, {"q", list(pose.q_a)}}},
                           {"b", {{"x", list(pose.x_b)}, {"q", list(pose.q_b)}}}});
  }
  return out;
}

namespace {

template <int n>
Eigen::Matrix<double, n, 1> numbers(const nlohmann::json& list) {
  Eigen::Matrix<double, n, 1> out;
  for (int i = 0; i < n; ++i) out[i] = list.at(std::size_t(i)).get<double>();
  return out;
}

/// A 3x3 block of K, from a row and a column on.
Mat3<double> block(const nlohmann::json& K, std::size_t row, std::size_t column) {
  Mat3<double> out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) out(long(i), long(j)) = K.at(row + i).at(column + j).get<double>();
  return out;
}

std::vector<RoadPose> read_road(const nlohmann::json& path) {
  std::vector<RoadPose> out;
  for (const auto& pose : path) {
    const auto &a = pose.at("a"), &b = pose.at("b");
    out.push_back(
        {numbers<3>(a.at("x")), numbers<3>(b.at("x")), numbers<4>(a.at("q")), numbers<4>(b.at("q"))});
  }
  return out;
}

}  // namespace

AskedBody read_body(const nlohmann::json& node) {
  AskedBody out;
  out.x = numbers<3>(node.at("x"));
  out.q = numbers<4>(node.at("q"));
  if (node.contains("o")) out.o = numbers<3>(node["o"]);
  if (node.contains("h")) out.h = numbers<4>(node["h"]);
  return out;
}

Ask read_request(const nlohmann::json& request) {
  Ask ask;
  ask.a = read_body(request.at("a"));
  ask.b = read_body(request.at("b"));
  const auto& K = request.at("law").at("K");
  const bool has_forces = K.size() == 6;
  if (has_forces) ask.K_f = block(K, 0, 0), ask.K_fm = block(K, 0, 3);
  ask.K_m = has_forces ? block(K, 3, 3) : block(K, 0, 0);
  if (request.contains("path")) ask.road = read_road(request["path"]);
  if (request.contains("mass")) ask.a.mass = request["mass"].at(0), ask.b.mass = request["mass"].at(1);
  if (request.contains("inertia"))
    ask.a.inertia = request["inertia"].at(0), ask.b.inertia = request["inertia"].at(1);
  return ask;
}

Eigen::Vector4d times(const Eigen::Vector4d& p, const Eigen::Vector4d& q) {
  const Vec3<double> u = p.tail<3>(), v = q.tail<3>();
  Eigen::Vector4d out;
  out << p[0] * q[0] - u.dot(v), p[0] * v + q[0] * u + u.cross(v);
  return out;
}

Eigen::Vector4d conjugate(const Eigen::Vector4d& q) { return {q[0], -q[1], -q[2], -q[3]}; }

Eigen::Vector4d quaternion_of(const Vec3<double>& theta) {
  const double phi = theta.norm(), half = phi / 2;
  const double factor = phi > 0 ? std::sin(half) / phi : 0.5;
  Eigen::Vector4d q;
  q << std::cos(half), factor * theta;
  return q;
}

Mat3<double> matrix_of(const Eigen::Vector4d& q) { return turned<double>(q); }

void place_b(Ask& ask, const Vec3<double>& theta, const Vec3<double>& p) {
  const Eigen::Vector4d frame_a = times(ask.a.q, ask.a.h);
  ask.b.q = times(times(frame_a, quaternion_of(theta)), conjugate(ask.b.h)).normalized();
  const Vec3<double> point_a = ask.a.x + matrix_of(ask.a.q) * ask.a.o;
  ask.b.x = point_a + matrix_of(frame_a) * p - matrix_of(ask.b.q) * ask.b.o;
}

}  // namespace halfway::reference
