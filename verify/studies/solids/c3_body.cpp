#include "verify/studies/solids/c3_body.hpp"

#include "reference/solve/solve.hpp"
#include "verify/once.hpp"
#include "verify/oracle/fe_access.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/scene_access.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace halfway::verify {
namespace {

namespace fe = reference::fe;

/// Of an even mesh: twice the exponent 0.711 at the edges of a held face.
constexpr double kEvenOrder = 1.42;

/// Error bars over |theta|: wider ones tell no joint from another.
constexpr double kWorthDrawing = 0.05;

fe::BlockPath spoilt(fe::BlockPath path) {
  path.compliance = tapped(path.compliance);
  for (auto* points : {&path.rising, &path.turned}) {
    for (auto& p : *points) {
      p.moment = tapped(p.moment);
      p.theta = tapped(p.theta);
      p.determinant = tapped(p.determinant);
      p.stiffness = tapped(p.stiffness);
    }
  }
  return path;
}

std::vector<fe::BlockPath> read_paths() {
  const auto kept = fe::kept("c3_block");
  if (!kept)
    throw std::runtime_error(
        "the 3D paths of the block of C3 are missing or not of today's inputs; run ./halfway reference");
  std::vector<fe::BlockPath> out;
  for (const auto& path : kept->at("paths")) out.push_back(spoilt(path.get<fe::BlockPath>()));
  return out;
}

/// The joint of C3 as stiff as the mesh, up to the end of the mesh's path.
reference::Scene as_stiff_as(const fe::BlockPath& path, std::size_t points) {
  reference::Scene s = scene("c3_buckling");
  s.joint.law = reference::LinearSpec{Eigen::MatrixXd(path.compliance.asDiagonal()), true};
  s.points = int(points);
  s.factor_end = fe::block_moments()[points];
  return s;
}

std::vector<Departure> measure(const reference::Entry& entry, const fe::BlockPath& path) {
  const std::vector<double> moments = fe::block_moments();
  std::size_t points = 0;  // at even steps: neither the first moment nor the one at which the path ended
  while (points + 1 < moments.size() && points + 1 < path.rising.size() &&
         std::abs(path.rising[points + 1].moment - moments[points + 1]) < 1e-3)
    ++points;
  const reference::Curve joint =
      solve_scene(as_stiff_as(path, points), {&entry, entry.needs_xi ? 0.5 : entry.probe_xi});
  std::vector<Departure> out;
  for (std::size_t i = 1; i <= points && i < joint.rows.size(); ++i) {
    const auto& row = joint.rows[i];
    const Vec3<double> theta(row[1], row[2], row[3]), body = path.rising[i].theta;
    out.push_back({row[0], theta, (theta - body).norm() / body.norm(), std::abs(theta[1] / body[1] - 1)});
  }
  return out;
}

}  // namespace

const std::vector<fe::BlockPath>& block_paths() {
  static std::map<Tap, std::vector<fe::BlockPath>> known;
  auto& all = known[passing()];
  if (all.empty()) all = read_paths();
  return all;
}

std::vector<const fe::BlockPath*> block_family(fe::SolidLaw law, fe::ElementKind element, double grading) {
  std::vector<const fe::BlockPath*> out;
  for (const auto& path : block_paths()) {
    if (path.mesh.law == law && path.mesh.element == element && path.mesh.grading == grading)
      out.push_back(&path);
  }
  if (out.empty()) throw std::runtime_error(std::string("no 3D path of C3's block by ") + to_string(law));
  return out;
}

const fe::BlockPath& finest_block(fe::SolidLaw law) {
  return *block_family(law, fe::ElementKind::hex20_full, 1).back();
}

double BodyPoint::phi() const { return Vec3<double>(theta[0].value, theta[1].value, theta[2].value).norm(); }

double BodyPoint::error() const {
  return Vec3<double>(theta[0].uncertainty, theta[1].uncertainty, theta[2].uncertainty).norm() / phi();
}

std::vector<BodyPoint> body_curve(fe::SolidLaw law, fe::ElementKind element) {
  const auto family = block_family(law, element, 1);
  const auto meshes = std::vector(family.end() - 3, family.end());
  const auto shortest = std::ranges::min(meshes, {}, [](const auto* m) { return m->rising.size(); });
  std::vector<BodyPoint> out;
  for (std::size_t i = 0; i + 1 < shortest->rising.size(); ++i) {  // the last is where its path ended
    BodyPoint at{};
    at.moment = fe::block_moments()[i];
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<fe::Sample> samples;
      for (const auto* m : meshes)
        samples.push_back({double(m->mesh.level), m->rising[i].theta[Eigen::Index(k)]});
      at.theta[k] = fe::richardson(samples, kEvenOrder);
    }
    const auto& finest = meshes.back()->rising;
    at.determinant = finest[i].determinant / finest.front().determinant;
    at.lowest = finest[i].stiffness[0];
    if (!(at.error() <= kWorthDrawing) && !std::isnan(at.error())) break;
    out.push_back(at);
  }
  if (out.empty()) throw std::runtime_error("the meshes of C3's block do not agree at any moment");
  return out;
}

const std::vector<Departure>& departures(const reference::Entry& entry, fe::SolidLaw law) {
  static Once<std::vector<Departure>, fe::SolidLaw, Tap> known;
  return known(entry, law, passing(), [&] { return measure(entry, finest_block(law)); });
}

double moment_within(const std::vector<Departure>& list, double Departure::*what, double limit) {
  double last_moment = 0, last = 0;
  for (const Departure& d : list) {
    if (!(d.*what <= limit))
      return last_moment == 0 && d.*what > limit
                 ? 0
                 : last_moment + (d.moment - last_moment) * (limit - last) / (d.*what - last);
    last_moment = d.moment;
    last = d.*what;
  }
  return list.empty() ? std::nan("") : last_moment;
}

}  // namespace halfway::verify
