#include "reports/advise/tests/support.hpp"

#include <algorithm>
#include <stdexcept>

namespace halfway::advise {

reference::Scene canonical(const std::string& name) {
  return reference::read_scene(reference::scenes_folder() / (name + ".toml"));
}

reference::Scene rod_scene(const Vec3<double>& stiffness, const Vec3<double>& moment) {
  reference::Scene out;
  out.name = out.title = "rod";
  out.outputs = {"theta_x", "theta_y", "theta_z"};
  out.joint.law = reference::LinearSpec{Eigen::MatrixXd(stiffness.asDiagonal()), false};
  out.loads = {{reference::LoadType::fixed_moment, moment}};
  return out;
}

Advice advised(const Question& question) {
  auto candidates = candidates_of(question.scene);
  candidates.push_back({reference::find_formulation("intrinsic"), 0.4, true, question.scene.joint.kind});
  const auto costs = counted_costs(candidates);
  Advice out = advise(question, costs);
  out.margin = margin_of(out, costs);
  return out;
}

Truth own_truth(const reference::Scene& scene, const std::string& formulation) {
  Truth out;
  out.kind = TruthKind::table;
  out.scene = scene;
  const Candidate own{reference::find_formulation(formulation), 0.5, false, scene.joint.kind};
  out.at = [scene, own](const std::vector<double>& factors) { return follow(scene, own, factors); };
  return out;
}

const Judged& judged(const std::vector<Judged>& all, const std::string& formulation) {
  const auto plain = [&](const Judged& j) {
    const Candidate& c = j.candidate;
    return c.formulation() == formulation && c.precision == "double" && c.variant.empty() && c.ends &&
           !c.fitted;
  };
  const auto found = std::ranges::find_if(all, plain);
  if (found == all.end()) throw std::runtime_error(formulation + " was not judged");
  return *found;
}

}  // namespace halfway::advise
