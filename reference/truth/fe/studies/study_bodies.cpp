// Studies of the tapered blocks: compliance and couplings over meshes, and the paper's load paths.
#include "reference/truth/fe/studies/study_makers.hpp"

namespace halfway::reference::fe {

nlohmann::json inputs_of(const Body& body) {
  return {{"version", kGeneratorVersion},
          {"geometry", body.geometry},
          {"material", {{"E", body.material.E}, {"nu", body.material.nu}}}};
}

Load scene_load(const std::string& scene) {
  Load load;
  for (const SceneLoad& l : read_scene(scenes_folder() / (scene + ".toml")).loads) {
    if (l.type == LoadType::fixed_force)
      load.f += l.value;
    else
      load.m += l.value;
    load.follower = l.type == LoadType::follower_moment;
  }
  return load;
}

Study characterisation_study(const Body& body, const std::vector<MeshPlan>& plans) {
  Study study;
  study.name = "linear_" + body.name;
  study.what = body.title + ": compliance and second-order couplings";
  study.inputs = inputs_of(body);
  for (const MeshPlan& plan : plans)
    study.inputs["meshes"].push_back({{"element", to_string(plan.element)}, {"levels", plan.levels}});
  study.compute = [&body, plans](const Report& report) {
    Characterisation c{body.name, joint_point(body), {}};
    int total = 0, done = 0;
    for (const MeshPlan& plan : plans) total += int(plan.levels.size());
    for (const MeshPlan& plan : plans) {
      for (int level : plan.levels) {
        c.runs.push_back(characterise(body, c.joint_point, plan.element, level));
        report(++done, total, std::string(to_string(plan.element)) + " level " + std::to_string(level));
      }
    }
    return nlohmann::json(c);
  };
  return study;
}

Study curve_study(const CurvePlan& plan) {
  constexpr int kPoints = 20;
  const Body& body = body_named(plan.body);
  Load load = scene_load(plan.scene);
  load.f *= plan.reach;
  load.m *= plan.reach;
  Study study;
  study.name = plan.name;
  study.what = plan.what;
  study.inputs = inputs_of(body);
  study.inputs["level"] = plan.level;
  study.inputs["force"] = {load.f[0], load.f[1], load.f[2]};
  study.inputs["moment"] = {load.m[0], load.m[1], load.m[2]};
  study.inputs["points"] = kPoints;
  study.compute = [&body, load, plan](const Report& report) {
    const Vec3<double> point = joint_point(body);
    nlohmann::json out;
    for (SolidLaw law : kLaws) {
      SolidCurve curve = follow(body, point, law, ElementKind::hex20, plan.level, load, 1, kPoints);
      curve.scene = plan.reach == 1 ? plan.scene : plan.name;
      out["curves"].push_back(curve);
      report(int(out["curves"].size()), int(kLaws.size()), to_string(law));
    }
    return out;
  };
  return study;
}

}  // namespace halfway::reference::fe
