#include "reports/advise/model/candidate.hpp"

#include "reference/face/kernel_variants.hpp"
#include "reference/scene/joint/free_strains.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfway::advise {
namespace {

using reference::Scene;

/// Is neither end away from its node?
bool is_bare(const reference::JointSpec& joint) {
  const auto bare = [](const JointEnd<double>& end) { return end.o.isZero(0) && end.H.isIdentity(0); };
  return bare(joint.a) && bare(joint.b);
}

/// Formulations whose kernel without ends is timed, by kind.
bool is_timed_bare(const Candidate& c) {
  const std::string name = c.formulation();
  if (c.kind == Kind::angular)
    return name == "attached_a" || name == "invariant" || name == "intrinsic" || name == "jointc" ||
           name == "fasse";
  if (c.kind == Kind::linear) return name == "attached_a" || name == "invariant" || name == "intrinsic";
  return name == "invariant";
}

/// The same formulation as its kernel's cheaper angles, in float and without ends, where those are timed.
void add_variants(const Candidate& c, const Scene& scene, std::vector<Candidate>& out) {
  if (is_bare(scene.joint) && is_timed_bare(c)) {
    out.push_back(c);
    out.back().ends = false;
  }
  if (c.formulation() != "invariant" || c.kind == Kind::linear) return;
  out.push_back(c);
  out.back().precision = "float";
  if (c.kind != Kind::angular) return;
  for (const auto& variant : reference::invariant_variants()) {
    if (variant.name.empty() || variant.precision != "double") continue;
    out.push_back(c);
    out.back().variant = variant.name;
  }
}

void add_kind(const Scene& scene, std::vector<Candidate>& out) {
  const bool linear = std::holds_alternative<reference::LinearSpec>(scene.joint.law);
  Scene any = scene;
  any.formulations.clear();
  for (const auto& choice : reference::choices(any)) {
    Candidate c{choice.entry, choice.xi};
    c.kind = scene.joint.kind;
    if (choice.entry && choice.entry->needs_xi && choice.xi == 0.5)
      continue;  // invariant is that, and cheaper
    out.push_back(c);
    if (choice.entry && linear) add_variants(c, scene, out);
  }
}

}  // namespace

std::string Candidate::formulation() const {
  return entry ? std::string(entry->name) : reference::kLinearized;
}

std::string Candidate::name(Kind of_scene) const {
  std::string out = formulation();
  if (entry && entry->needs_xi) out += fmt::format(" xi = {:.4g}", xi);
  if (!variant.empty()) out += ' ' + variant;
  if (precision == "float") out += " in float";
  if (!ends) out += " without ends";
  return kind == of_scene ? out : fmt::format("{} as {}", out, to_string(kind));
}

std::string Candidate::timing() const {
  if (!entry) return fmt::format("{}/{}", reference::kLinearized, to_string(kind));
  std::string out = fmt::format("{}/{}/residual_tangent/kernel", entry->name, to_string(kind));
  if (precision == "float") out += "/float";
  if (!variant.empty()) out += '/' + variant;
  return ends ? out : out + "/no_ends";
}

std::vector<Candidate> candidates_of(const Scene& scene) {
  std::vector<Candidate> out;
  add_kind(scene, out);
  for (const Kind kind : {Kind::angular, Kind::linear}) {
    if (const auto reduced = as_kind(scene, kind)) add_kind(*reduced, out);
  }
  return out;
}

std::optional<Scene> as_kind(const Scene& scene, Kind kind) {
  const auto* law = std::get_if<reference::LinearSpec>(&scene.joint.law);
  if (scene.joint.kind != Kind::linear_angular || kind == Kind::linear_angular || !law) return std::nullopt;
  if (!law->matrix.topRightCorner(3, 3).isZero(0) || !law->matrix.bottomLeftCorner(3, 3).isZero(0))
    return std::nullopt;
  const bool forces = kind == Kind::linear;
  if (!std::ranges::all_of(scene.loads, [&](const auto& load) { return is_force(load.type) == forces; }))
    return std::nullopt;
  // The other half of the answer is nothing only where no joint point moves with a turn.
  if (!forces && !scene.joint.b.o.isZero(0)) return std::nullopt;
  Scene out = scene;
  out.joint.kind = kind;
  const int first = forces ? 0 : 3;
  out.joint.law =
      reference::LinearSpec{Eigen::MatrixXd(law->matrix.block(first, first, 3, 3)), law->is_compliance};
  const Eigen::MatrixXd K = reference::rest_stiffness(out.joint.law, kind);
  if (K.size() > 0 && reference::free_strains(K).cols() > 0) return std::nullopt;
  std::erase_if(out.outputs, [&](const std::string& name) { return name.starts_with("u_") != forces; });
  if (out.outputs.empty()) return std::nullopt;
  return out;
}

}  // namespace halfway::advise
