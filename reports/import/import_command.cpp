// halfway import: bushings of another program's file become scenes.
#include "reference/scene/joint/names.hpp"
#include "reference/scene/scene_head.hpp"
#include "reference/scene/text/toml_tree.hpp"
#include "reports/cli/errors.hpp"
#include "reports/cli/streams.hpp"
#include "reports/import/commands.hpp"
#include "reports/import/files.hpp"
#include "reports/import/readers/readers.hpp"
#include "reports/import/record/text.hpp"
#include "reports/import/scene/scene_text.hpp"
#include "reports/import/scene/spread.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace halfway::imports {
namespace {

using reports::BadInput;
using reports::printable;

struct ImportRequest {
  std::string file{}, as{}, name{}, out{};
  ImportOptions options{};
  bool force = false;
};

/// A scene that is to be written.
struct Written {
  ImportedJoint joint{};
  std::filesystem::path file{};
  std::string formulation{}, text{}, load{};
};

std::string names_of(const std::vector<ImportedJoint>& joints) {
  std::string out;
  for (std::size_t i = 0; i < joints.size() && i < 20; ++i) out += (i ? ", " : "") + joints[i].name;
  return joints.size() > 20 ? out + fmt::format(", ... ({} in all)", joints.size()) : out;
}

std::vector<ImportedJoint> joints_asked(const ImportRequest& request) {
  std::vector<ImportedJoint> all;
  try {
    all = read_joints(read_up_to(request.file, kLargestFile), request.options);
  } catch (const reference::Refusal& refusal) {
    throw BadInput(fmt::format("{}:{}: {}", request.file, refusal.line, refusal.what()));
  }
  if (request.name.empty()) return all;
  std::vector<ImportedJoint> out;
  std::ranges::copy_if(all, std::back_inserter(out),
                       [&](const ImportedJoint& joint) { return joint.name == request.name; });
  if (out.empty())
    throw BadInput(
        fmt::format("--name {}: no bushing of {}; allowed: {}", request.name, request.file, names_of(all)));
  return out;
}

/// What the scene is to compute: the program's own law, or what --as says where the file holds none.
std::string formulation_of(const ImportRequest& request, const ImportedJoint& joint) {
  if (!joint.formulation.empty()) {
    if (!request.as.empty() && request.as != joint.formulation)
      throw BadInput(
          fmt::format("--as {}: {} computes {} and the scene says so; allowed: --as where a file holds no "
                      "law of rotation; ./halfway run SCENE --formulation {} asks another one",
                      request.as, joint.program, joint.formulation, request.as));
    return joint.formulation;
  }
  if (request.as.empty()) {
    reports::tell(spread_table(joint));
    throw BadInput(fmt::format(
        "{}:{}: bushing {} holds no law of rotation, on which the answer depends; allowed: --as NAME, "
        "one of the table",
        request.file, joint.line, joint.name));
  }
  const auto allowed = candidates();
  if (std::ranges::find(allowed, request.as) == allowed.end())
    throw BadInput("--as: " + reference::unknown_name("formulation", request.as, allowed));
  return request.as;
}

/// Our own reader has to take it: so it judges the stiffness too.
void check_readable(const ImportRequest& request, const Written& written) {
  reference::Document document;
  try {
    reference::read_toml_text(written.text, written.file.string(), document);
    reference::joint_scene(reference::Field(document), written.file);
  } catch (const reference::Refusal& refusal) {
    throw BadInput(fmt::format("{}:{}: {}: no scene can be made of it: {}", request.file, written.joint.line,
                               written.joint.name, refusal.what()));
  }
}

/// STEM.toml of one bushing, STEM-NAME.toml of several.
std::vector<std::filesystem::path> files_of(const ImportRequest& request,
                                            const std::vector<ImportedJoint>& joints) {
  if (!request.out.empty()) {
    if (joints.size() > 1)
      throw BadInput(fmt::format("--out {}: {} holds {} bushings; allowed: --name with it: {}", request.out,
                                 request.file, joints.size(), names_of(joints)));
    if (!request.out.ends_with(".toml"))
      throw BadInput(
          fmt::format("--out {}: is no scene's name; allowed: a name that ends with .toml", request.out));
    return {request.out};
  }
  const std::string stem = std::filesystem::path(request.file).stem().string();
  std::vector<std::filesystem::path> out;
  for (const ImportedJoint& joint : joints) {
    std::string name = joints.size() == 1 ? stem : stem + "-" + file_name_of(joint.name);
    for (int i = 2; std::find(out.begin(), out.end(), std::filesystem::path(name + ".toml")) != out.end();
         ++i)
      name = fmt::format("{}-{}-{}", stem, file_name_of(joint.name), i);
    out.emplace_back(name + ".toml");
  }
  return out;
}

Written made(const ImportRequest& request, const ImportedJoint& joint, const std::filesystem::path& file) {
  Written out{joint, file, formulation_of(request, joint)};
  try {
    const ExampleLoad load = example_load(joint);
    out.load = load.said;
    out.text =
        scene_text(joint, std::filesystem::path(request.file).filename().string(), out.formulation, load);
  } catch (const reference::Refusal& refusal) {
    throw BadInput(fmt::format("{}:{}: {}", request.file, refusal.line, refusal.what()));
  }
  check_readable(request, out);
  return out;
}

std::string summary(const Written& written) {
  const ImportedJoint& joint = written.joint;
  std::string out =
      fmt::format("{} (line {}, {}): {}\n", joint.name, joint.line, joint.program, written.formulation);
  for (const auto* from : {&joint.law_from, &joint.preload_from, &joint.a_from, &joint.b_from}) {
    for (const Source& at : *from)
      out += fmt::format("  line {}: {}{}\n", at.line, at.key, at.text.empty() ? "" : " = " + at.text);
  }
  for (const std::string& what : joint.lost) out += "  lost: " + what + "\n";
  for (const std::string& what : joint.notes) out += "  note: " + what + "\n";
  return out + fmt::format("  example load, to be replaced: {}\n", written.load);
}

/// Line by line, so that nothing of the file reaches the terminal as a command.
void tell_printable(std::string_view text) {
  for (const std::string_view line : lines_of(text)) reports::tell(printable(line) + "\n");
}

void import_file(const ImportRequest& request) {
  const auto joints = joints_asked(request);
  const auto files = files_of(request, joints);
  std::vector<Written> all;
  for (std::size_t i = 0; i < joints.size(); ++i) all.push_back(made(request, joints[i], files[i]));
  for (const Written& written : all) refuse_existing(written.file, request.force);
  for (const Written& written : all) {
    write_new(written.file, written.text);
    tell_printable(summary(written));
    reports::print("wrote " + printable(written.file.string()) + "\n");
  }
}

}  // namespace

void add_import(CLI::App& app) {
  const auto request = std::make_shared<ImportRequest>();
  CLI::App* command = app.add_subcommand(
      "import",
      fmt::format(
          "Turn bushings of another program's file into scenes\n\nRead, by what stands in the file, and what "
          "the scene computes:\n{}\n"
          "Each scene says from which line its numbers came and what was lost, and has a load as an example.",
          kinds_read()));
  command->add_option("file", request->file, "A file of another program")->required();
  command->add_option("--as", request->as,
                      "Formulation, for files that hold no law of rotation; without it the choices and what "
                      "they differ by are shown");
  command->add_option("--name", request->name, "Of several bushings this one; default: a scene each");
  command
      ->add_option(
          "--units", request->options.units,
          "m or mm, with N and rad: of files without units (MBDyn, Nastran, .adm without UNITS); default: m")
      ->check(CLI::IsMember({"m", "mm"}));
  command->add_option("--joint", request->options.joint_type,
                      "lock, revolute, universal or spherical: of Chrono JSON without a Type");
  command->add_option("--out", request->out,
                      "The scene's file; default: STEM.toml here, or STEM-NAME.toml of several bushings");
  command->add_flag("--force", request->force, "Replace files that are there");
  command->callback([request] { import_file(*request); });
}

}  // namespace halfway::imports
