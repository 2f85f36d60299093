#include "reports/views/results.hpp"

#include <cmath>
#include <utility>

namespace halfway {

static void to_json(nlohmann::json& json, const Band& band) {
  json = {{"low", band.low}, {"high", band.high}};
}

static void to_json(nlohmann::json& json, const PerKind& bands) {
  json = {{"angular", bands.angular}, {"linear", bands.linear}, {"linear_angular", bands.linear_angular}};
}

static void to_json(nlohmann::json& json, const Facts& facts) {
  json = {{"moment_balance", facts.moment_balance},
          {"node_order", facts.node_order},
          {"symmetry", facts.symmetry},
          {"loop_work", facts.loop_work},
          {"loop_slope", facts.loop_slope},
          {"clamped_energy", facts.clamped_energy},
          {"has_fingerprint", facts.has_fingerprint},
          {"alpha", facts.alpha},
          {"beta", facts.beta}};
}

}  // namespace halfway

namespace halfway::bench {

static void to_json(nlohmann::json& json, const Context& context) {
  json = {{"machine", context.machine}, {"compiler", context.compiler}, {"flags", context.flags},
          {"commit", context.commit},   {"date", context.date},         {"build_type", context.build_type}};
}

static void to_json(nlohmann::json& json, const ErrorAt& at) {
  json = {{"from", at.from}, {"to", at.to}, {"error", at.error}};
}

static void to_json(nlohmann::json& json, const Timing& timing) {
  json = {{"name", timing.name},
          {"formulation", timing.formulation},
          {"kind", timing.kind},
          {"what", timing.what},
          {"implementation", timing.implementation},
          {"precision", timing.precision},
          {"isa", timing.isa},
          {"variant", timing.variant},
          {"method", timing.method},
          {"joints", timing.joints},
          {"threads", timing.threads},
          {"ns", timing.ns},
          {"spread", timing.spread},
          {"error", timing.error},
          {"errors", timing.errors},
          {"flops", timing.flops},
          {"products", timing.products},
          {"bytes", timing.bytes},
          {"wrong", timing.wrong},
          {"message", timing.message}};
  if (timing.wrong) json["ns"] = nullptr;  // a wrong result has no speed
}

}  // namespace halfway::bench

namespace halfway::reference {

static void to_json(nlohmann::json& json, const Curve& curve) {
  json = {{"scene", curve.scene},
          {"formulation", curve.formulation},
          {"xi", curve.xi},
          {"columns", curve.columns},
          {"rows", curve.rows},
          {"converged", curve.converged},
          {"outcome", curve.outcome},
          {"iterations", curve.iterations},
          {"residual", curve.residual}};
}

}  // namespace halfway::reference

namespace halfway::verify {

static void to_json(nlohmann::json& json, const Row& row) {
  std::vector<std::string> sees;
  const auto add = [&](bool does, const char* what) {
    if (does) sees.emplace_back(what);
  };
  add(row.seen.moments, "moments"), add(row.seen.forces, "forces"), add(row.seen.tangent, "tangent");
  add(row.seen.strain, "strain"), add(row.seen.energy, "energy");
  json = {{"check", row.check}, {"room", row.room},        {"siblings", row.siblings},
          {"sees", sees},       {"caught_by", row.caught}, {"wrong", row.wrong}};
}

}  // namespace halfway::verify

namespace halfway::reports {

std::vector<FormulationInfo> formulation_infos() {
  constexpr std::pair<Kind, const char*> kinds[] = {
      {Kind::angular, "angular"}, {Kind::linear, "linear"}, {Kind::linear_angular, "linear_angular"}};
  std::vector<FormulationInfo> infos;
  for (const auto& entry : reference::formulations()) {
    FormulationInfo info{std::string(entry.name),
                         std::string(entry.stands_for),
                         entry.needs_xi,
                         entry.probe_xi,
                         entry.facts,
                         {}};
    for (const auto& [kind, name] : kinds)
      if (entry.has_potential(kind)) info.potential_kinds.emplace_back(name);
    infos.push_back(std::move(info));
  }
  return infos;
}

namespace {

/// Title and unit of what the load factor counts: of one load of size 1, or of size 1 in each of its
/// directions.
std::pair<std::string, std::string> load_of(const reference::Scene& scene) {
  if (scene.loads.size() != 1) return {};
  const reference::SceneLoad& load = scene.loads.front();
  const std::string title = is_force(load.type) ? "force" : "moment";
  const std::string unit = is_force(load.type) ? "N" : "N m";
  if (std::abs(load.value.norm() - 1) <= 1e-12) return {title, unit};  // unit vectors as a person writes them
  const bool ones = (load.value.array() == 0 || load.value.array().abs() == 1).all();
  return ones ? std::pair(title + " in each direction", unit) : std::pair<std::string, std::string>{};
}

}  // namespace

std::vector<SceneInfo> scene_infos(const std::vector<reference::Scene>& scenes) {
  std::vector<SceneInfo> infos;
  for (const auto& scene : scenes) {
    const auto [title, unit] = load_of(scene);
    infos.push_back({scene.name, scene.title, scene.description, scene.source, title, unit});
  }
  return infos;
}

void to_json(nlohmann::json& json, const FormulationInfo& info) {
  json = {{"name", info.name},         {"stands_for", info.stands_for},
          {"needs_xi", info.needs_xi}, {"probe_xi", info.probe_xi},
          {"facts", info.facts},       {"potential_kinds", info.potential_kinds}};
}

void to_json(nlohmann::json& json, const LeftOut& left_out) {
  json = {{"what", left_out.what}, {"reason", left_out.reason}};
}

void to_json(nlohmann::json& json, const SceneInfo& scene) {
  json = {{"name", scene.name},
          {"title", scene.title},
          {"description", scene.description},
          {"source", scene.source}};
  if (!scene.load_title.empty()) json["load"] = {{"title", scene.load_title}, {"unit", scene.load_unit}};
}

void to_json(nlohmann::json& json, const Results& results) {
  json = {{"schema", kSchemaName},
          {"version", kSchemaVersion},
          {"context", results.context},
          {"command", results.command},
          {"formulations", results.formulations},
          {"scenes", results.scenes},
          {"findings", results.findings},
          {"curves", results.curves},
          {"timings", results.timings},
          {"left_out", results.left_out},
          {"saboteurs", results.saboteurs},
          {"paper", results.paper},
          {"solids", results.solids},
          {"speed", results.speed},
          {"rods", results.rods},
          {"stability", results.stability},
          {"durations", results.durations}};
  if (!results.programs.empty()) json["programs"] = results.programs;
}

}  // namespace halfway::reports
