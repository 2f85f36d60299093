// Everything that a report shows, in one record; results.json is its text form (reports/SCHEMA.md).
#pragma once

#include "bench/harness/timing.hpp"
#include "reference/face/registry.hpp"
#include "reference/record/finding.hpp"
#include "reference/solve/solve.hpp"
#include "verify/oracle/saboteurs/matrix.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace halfway::reports {

inline constexpr const char* kSchemaName = "halfway-results";
inline constexpr int kSchemaVersion = 1;

/// What a formulation declares about itself; verify measures whether it holds.
struct FormulationInfo {
  std::string name;
  std::string stands_for;
  bool needs_xi = false;
  double probe_xi = 0.5;  ///< the xi at which it is probed and timed
  Facts facts;
  std::vector<std::string> potential_kinds;  ///< kinds for which it declares a potential
};

/// What was not run or not solved, and why.
struct LeftOut {
  std::string what;
  std::string reason;
};

/// Title and origin of a scene, for headings beside its curves.
struct SceneInfo {
  std::string name;
  std::string title;
  std::string description;
  std::string source;
  std::string load_title, load_unit;  ///< what the load factor counts; empty where it is a mere number
};

struct Results {
  bench::Context context;
  std::string command = "./halfway report";  ///< what reproduces the report
  std::vector<FormulationInfo> formulations;
  std::vector<SceneInfo> scenes;
  std::vector<reference::Finding> findings;
  std::vector<reference::Curve> curves;
  std::vector<bench::Timing> timings;
  std::vector<LeftOut> left_out;
  std::vector<verify::Row> saboteurs;                   ///< what each check was seen to fail for
  nlohmann::json paper = nlohmann::json::object();      ///< printed tables and others' curves, see SCHEMA.md
  nlohmann::json programs = nlohmann::json::array();    ///< joints of other programs, see SCHEMA.md
  nlohmann::json solids = nlohmann::json::object();     ///< the 3D truth, see SCHEMA.md
  nlohmann::json speed = nlohmann::json::object();      ///< limits, targets and choices, see SCHEMA.md
  nlohmann::json rods = nlohmann::json::object();       ///< large rotation, see SCHEMA.md
  nlohmann::json stability = nlohmann::json::object();  ///< where methods fail, see SCHEMA.md
  std::map<std::string, double> durations;              ///< stage of the run -> wall time, s
};

/// The catalog as the report shows it, in its order.
std::vector<FormulationInfo> formulation_infos();

/// Headings of the scenes.
std::vector<SceneInfo> scene_infos(const std::vector<reference::Scene>& scenes);

void to_json(nlohmann::json& json, const FormulationInfo& info);
void to_json(nlohmann::json& json, const LeftOut& left_out);
void to_json(nlohmann::json& json, const SceneInfo& scene);
void to_json(nlohmann::json& json, const Results& results);

}  // namespace halfway::reports
