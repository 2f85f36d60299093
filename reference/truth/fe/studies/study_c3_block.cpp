// What the body of C3 itself does under C3's moment: laws, meshes and elements, each as far as it goes.
#include "reference/truth/fe/studies/block_path.hpp"
#include "reference/truth/fe/studies/study_makers.hpp"

namespace halfway::reference::fe {
namespace {

// Even meshes go farthest: a few nodes at an edge, which compression makes unstable, end a path, and small
// elements at the singular edges of the held faces do so earlier. Graded ones stand beside them.
std::vector<BlockMesh> block_meshes() {
  std::vector<BlockMesh> out;
  const auto add = [&](SolidLaw law, ElementKind element, double grading, std::vector<int> levels) {
    for (const int level : levels) out.push_back({law, element, level, grading});
  };
  add(SolidLaw::neo_hooke, ElementKind::hex20_full, 1, {2, 3, 4, 6});
  add(SolidLaw::neo_hooke, ElementKind::hex27, 1, {2, 3, 4});
  add(SolidLaw::hencky, ElementKind::hex20_full, 1, {2, 3, 4, 6});
  add(SolidLaw::cauchy_log, ElementKind::hex20_full, 1, {2, 3, 4});
  add(SolidLaw::st_venant, ElementKind::hex20_full, 1, {2, 3, 4});
  add(SolidLaw::neo_hooke, ElementKind::hex20_full, 3, {2, 3, 4});
  return out;
}

}  // namespace

Study c3_block_study() {
  Study study;
  study.name = "c3_block";
  study.what = "Parallelepiped of Table 2 under the moment of C3, as far as the solid goes";
  study.inputs = inputs_of(body_named("block"));
  const Vec3<double> direction = scene_load("c3_buckling").m;
  study.inputs["direction"] = {direction[0], direction[1], direction[2]};
  study.inputs["moments"] = block_moments();
  for (const BlockMesh& m : block_meshes())
    study.inputs["paths"].push_back({to_string(m.law), to_string(m.element), m.level, m.grading});
  study.compute = [direction](const Report& report) {
    const std::vector<BlockMesh> all = block_meshes();
    nlohmann::json out;
    for (const BlockMesh& mesh : all) {
      out["paths"].push_back(follow_block(mesh, direction));
      report(int(out["paths"].size()), int(all.size()),
             std::string(to_string(mesh.law)) + " level " + std::to_string(mesh.level));
    }
    return out;
  };
  return study;
}

}  // namespace halfway::reference::fe
