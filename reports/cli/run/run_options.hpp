// What the command line of `run` says, and what becomes of it, for joints and for chains.
#pragma once

#include "reports/cli/run/run_choices.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace halfway::reports {

struct RunOptions {
  std::string scene;
  std::vector<std::string> formulations;
  std::vector<double> xis;
  std::vector<std::string> formats;
  std::string folder = "out/run";
  bool by_arc = false, with_rod = false;

  /// csv, json, svg, html; all of them where none was named.
  bool wants(std::string_view format) const;

  /// What was asked for, as a person types it.
  std::string command() const;
};

/// Says what runs: title and notes of the scene; refuses a folder that cannot be written. Throws BadInput.
void begin_run(const RunOptions& options, const reference::SceneHead& scene);

/// FOLDER/SCENE/name, which is told. Throws FileError.
void write_result(const RunOptions& options, const reference::SceneHead& scene, const char* name,
                  const std::string& content);

/// Of a scene of a mechanism: solved, written, drawn. Throws BadInput, FailedRun.
void run_mechanism(const RunOptions& options, const reference::MechanismScene& scene);

/// Of a scene of a chain: solved, written, drawn. Throws BadInput, FailedRun.
void run_chain(const RunOptions& options, const reference::ChainScene& scene);

}  // namespace halfway::reports
