// Outer surfaces of the bodies, undeformed and deformed, for the report's pictures.
#include "reference/truth/fe/studies/study_makers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

namespace halfway::reference::fe {
namespace {

constexpr int kLevel = 4;
constexpr SolidLaw kLaw = SolidLaw::cauchy_log;
constexpr const char* kBearing = "bearing";
constexpr double kVisible = 0.12;  ///< of the body's size: the largest displacement as drawn

/// Corner nodes of a hexahedron's six faces, seen from outside.
constexpr std::array<std::array<int, 4>, 6> kFaces = {
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// Faces of one element only: the outer surface.
std::vector<std::array<int, 4>> surface(const Mesh& mesh) {
  std::map<std::array<int, 4>, std::pair<int, std::array<int, 4>>> seen;
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e) {
    for (const auto& face : kFaces) {
      std::array<int, 4> nodes;
      for (std::size_t i = 0; i < 4; ++i) nodes[i] = mesh.elements(face[i], e);
      auto key = nodes;
      std::sort(key.begin(), key.end());
      auto& [count, kept_nodes] = seen[key];
      ++count;
      kept_nodes = nodes;
    }
  }
  std::vector<std::array<int, 4>> out;
  for (const auto& [key, face] : seen) {
    if (face.first == 1) out.push_back(face.second);
  }
  return out;
}

nlohmann::json rounded(const Eigen::Vector3d& v, double unit) {
  nlohmann::json out;
  for (double x : v) out.push_back(std::round(x / unit) * unit);
  return out;
}

/// Only the surface's nodes, numbered anew, to four digits of the drawing.
nlohmann::json drawing(const Mesh& mesh, const Eigen::Matrix3Xd& u) {
  nlohmann::json out;
  std::map<int, int> number;
  const double size = (mesh.X.rowwise().maxCoeff() - mesh.X.rowwise().minCoeff()).norm();
  const double largest = u.colwise().norm().maxCoeff();
  for (const auto& face : surface(mesh)) {
    nlohmann::json nodes;
    for (int node : face) {
      const auto [it, added] = number.try_emplace(node, int(number.size()));
      nodes.push_back(it->second);
      if (!added) continue;
      out["X"].push_back(rounded(mesh.X.col(node), 1e-4 * size));
      out["u"].push_back(rounded(u.col(node), 1e-4 * largest));
    }
    out["faces"].push_back(nodes);
  }
  out["scale"] = kVisible * size / largest;
  return out;
}

struct Picture {
  const char* name;
  const char* title;
  const char* note;
  const char* body;
  const char* scene;
  double factor;  ///< of the scene's load
};

constexpr Picture kPictures[] = {
    {"block_moment", "Parallelepiped under the skewed moment of Fig. 3",
     "moment of 1 N m, nearly about axis 1", "block", "c2_parallelepiped_small", 1},
    {"frustum_moment", "Frustum, top clamped, under the moment of Fig. 6",
     "moment of 1 N m, nearly about axis 1", "frustum_top", "c4_frustum", 1},
    {"block_force", "Parallelepiped under compression and shear of Fig. 7",
     "forces of -1 N along axis 1 and 1 N along axis 3 at the centroid", "block", "c6_compression_shear", 1},
    {"bearing_force", "Bearing (plane cut, conical hole) under the force of Fig. 9",
     "shear of 1 MN along axis 1 and compression of 1 MN along axis 2 on the inner bowl", kBearing,
     "c7_bearing", 1e6}};

nlohmann::json picture(const Picture& p) {
  const Body body = std::string(p.body) == kBearing ? fitted_bearing() : body_named(p.body);
  Load load = scene_load(p.scene);
  load.f *= p.factor;
  load.m *= p.factor;
  const Solid solid(body.mesh(ElementKind::hex20, kLevel), body.material, body.face + joint_point(body));
  const Equilibrium e = Statics(solid).solve(kLaw, load, solid.unloaded());
  if (!e.converged) throw std::runtime_error(std::string(p.name) + ": " + e.reason);
  nlohmann::json out = drawing(solid.mesh(), e.state.u);
  out["name"] = p.name;
  out["title"] = p.title;
  out["note"] = p.note;
  return out;
}

}  // namespace

Study shapes_study() {
  Study study;
  study.name = "shapes";
  study.what = "Outer surfaces of the deformed bodies";
  study.inputs = {{"version", kGeneratorVersion},
                  {"level", kLevel},
                  {"law", to_string(kLaw)},
                  {"bearing", key_of(bearing_study())}};
  for (const Picture& p : kPictures) study.inputs["pictures"].push_back({p.name, p.body, p.scene, p.factor});
  study.compute = [](const Report& report) {
    nlohmann::json out = nlohmann::json::array();
    for (const Picture& p : kPictures) {
      out.push_back(picture(p));
      report(int(out.size()), int(std::size(kPictures)), p.name);
    }
    return out;
  };
  return study;
}

}  // namespace halfway::reference::fe
