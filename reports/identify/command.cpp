// halfway identify: a joint from measured curves.
#include "reports/identify/command.hpp"

#include "reference/scene/scene_head.hpp"
#include "reference/scene/text/toml_tree.hpp"
#include "reports/cli/errors.hpp"
#include "reports/cli/streams.hpp"
#include "reports/identify/read_other.hpp"
#include "reports/identify/results.hpp"
#include "reports/import/files.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

namespace halfway::reports {
namespace {

namespace id = reference::identify;

constexpr std::size_t kLargestFile = 16u << 20;  // bytes

struct IdentifyRequest {
  std::string file{}, out{}, law{};
  bool json = false, force = false;
};

Identified read(const IdentifyRequest& request) {
  const std::string text = imports::read_up_to(request.file, kLargestFile);
  if (text.size() > kLargestFile)
    throw BadInput(request.file + ": longer than 16 MB; allowed: shorter files");
  try {
    ReadCurves curves = read_data_file(text, request.law);
    return {request.file, std::move(curves.data), std::move(curves.notes), {}};
  } catch (const reference::Refusal& refusal) {
    throw BadInput(fmt::format("{}:{}: {}", request.file, refusal.line, refusal.what()));
  }
}

/// Our own reader has to take it.
std::string checked_scene(const Identified& what, const std::filesystem::path& file) {
  const std::string text = identify_scene(what);
  try {
    reference::with_scene_text(text, file.string(), [&](reference::Document& document) {
      reference::joint_scene(reference::Field(document), file);
    });
  } catch (const std::exception& error) {
    throw FailedRun(fmt::format("no scene can be made of what was identified: {}", error.what()));
  }
  return text;
}

void identify_file(const IdentifyRequest& request) {
  Identified what = read(request);
  const std::filesystem::path scene =
      request.out.empty() ? std::filesystem::path(request.file).stem().string() + ".toml" : request.out;
  if (scene.extension() != ".toml")
    throw BadInput(
        fmt::format("--out {}: is no scene's name; allowed: a name that ends with .toml", request.out));
  imports::refuse_existing(scene, request.force);
  try {
    what.found = id::identify(what.data);
  } catch (const id::NotIdentifiable& error) {
    throw BadInput(fmt::format("{}: {}; allowed: rows with loads and motions, more of them than unknowns",
                               request.file, error.what()));
  }
  const std::string text = checked_scene(what, scene);
  imports::write_new(scene, text);
  const std::filesystem::path page =
      std::filesystem::path("out/identify") / std::filesystem::path(request.file).stem() / "index.html";
  imports::write_new(page, identify_page(what));
  if (request.json) {
    nlohmann::ordered_json json = identify_json(what);
    json["scene"]["file"] = scene.string();
    json["page"] = page.string();
    print(json.dump(1) + "\n");
    return;
  }
  for (const std::string& note : what.notes) tell("note: " + printable(note) + "\n");
  print(identify_summary(what));
  print(fmt::format("wrote {} ({}) and {}\n", printable(scene.string()), best_joint(what).formulation,
                    printable(page.string())));
}

}  // namespace

void add_identify(CLI::App& app) {
  const auto request = std::make_shared<IdentifyRequest>();
  CLI::App* command = app.add_subcommand(
      "identify",
      "Find a joint from measured curves: stiffness, axes, joint point, xi, with intervals; a scene and a "
      "page of "
      "it\n\n"
      "DATA is a text file: a line of column names with units, then rows of numbers; an empty line begins "
      "the next load\n"
      "case. Columns are loads on body b and its motion, any of them: f_x [N] ... m_z [N m], u_x [mm] ... "
      "theta_z [deg]\n"
      "(rotation vector), along fixed axes; body a stands. Loads without a column are zero, motions without "
      "one are free\n"
      "and not measured. '# held: u_x, theta_y' before a case: these were held (their loads are what was "
      "measured);\n"
      "'# sigma: u = 0.01 mm, theta = 0.002 deg': the noise, where it is known; '# case: NAME'.");
  command->add_option("data", request->file, "The curves")->required();
  command->add_option("--out", request->out, "The scene's file; default: STEM.toml here");
  command->add_option("--law", request->law,
                      "Of a result of several material laws this one (reference/data/fe)");
  command->add_flag("--json", request->json, "Print JSON for programs instead of the summary");
  command->add_flag("--force", request->force, "Replace a file that is there");
  command->callback([request] { identify_file(*request); });
}

}  // namespace halfway::reports
