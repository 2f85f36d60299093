#include "reference/scene/scene_head.hpp"

#include "reference/scene/joint/names.hpp"
#include "reference/scene/scene_references.hpp"
#include "reference/scene/text/toml_tree.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace halfway::reference {
namespace {

constexpr int kMostPoints = 100000;

/// The file's name without extension; all of it where that is a folder's name: "...toml" is no "..".
std::string name_of(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  return stem.find_first_not_of('.') == std::string::npos ? file.filename().string() : stem;
}

template <class Read>
void with_document(const std::string& name, Read&& read, const std::function<void(Document&)>& use) {
  Document document;
  try {
    read(document);
    use(document);
  } catch (const Refusal& refusal) {
    throw SceneError(fmt::format("{}:{}: {}", name, refusal.line, refusal.what()));
  }
}

}  // namespace

void read_title(const Field& file, const std::filesystem::path& path, SceneHead& out) {
  out.name = name_of(path);
  out.title = file.at("title", "one line of text").text();
  out.description = file.text_or("description");
  out.source = file.text_or("source");
}

void read_path(const Field& path, SceneHead& out) {
  out.factor_end = path.at("factor_end", "a number > 0").positive();
  if (const auto points = path.find("points")) out.points = points->integer(1, kMostPoints);
}

void read_outputs(const Field& file, const std::vector<std::string>& allowed, SceneHead& out) {
  out.outputs = allowed;
  const auto outputs = file.find("outputs");
  if (!outputs) return;
  out.outputs = outputs->distinct(Names(allowed.begin(), allowed.end()));
  if (out.outputs.empty()) outputs->refuse("is empty", "at least one output");
}

void read_formulations(const Field& file, const Names& beside,
                       const std::function<std::optional<Unfit>(const Entry&)>& unfit, SceneHead& out) {
  if (const auto xis = file.find("xis")) out.xis = xis->distinct_numbers();
  const auto names = file.find("formulations");
  if (!names) return;
  Names allowed = formulation_names();
  allowed.insert(allowed.end(), beside.begin(), beside.end());
  out.formulations = names->distinct(allowed);
  if (out.formulations.empty())
    names->refuse("is empty", "at least one name, or no such key for all formulations");
  for (const std::string& name : out.formulations) {
    const Entry* entry = find_formulation(name);
    if (entry == nullptr) continue;
    if (entry->needs_xi && out.xis.empty())
      names->refuse(fmt::format("names {}, which needs a xi", name), "xis = [...] beside it");
    if (const auto why = unfit(*entry))
      names->refuse(fmt::format("names {}, which {}", name, why->what), why->allowed);
  }
}

void read_references(const Field& file, std::string_view truth, SceneHead& out) {
  const auto sets = file.find("reference");
  if (!sets) return;
  for (const Field set : sets->items("tables [[reference]]")) {
    const auto references = read_reference_set(set, out, truth);
    out.references.insert(out.references.end(), references.begin(), references.end());
  }
}

Field::Items loads_of(const Field& file) {
  const Field loads = file.at("load", "at least one table [[load]]");
  const Field::Items out = loads.items("tables [[load]]");
  if (out.begin() == out.end()) loads.refuse("is empty", "at least one table [[load]]");
  return out;
}

NamedLoad read_load(const Field& load, const Names& types) {
  const Field type = load.at("type", fmt::format("{}", fmt::join(types, ", ")));
  if (type.is_text() && type.text().starts_with("prescribed"))
    type.refuse("is no load", "a table [[motion]] with type = rotation or displacement and its value");
  const std::string name = type.one_of(types);
  const std::string shape = "3 numbers, N or N m";
  const Dimension& unit = name.ends_with("force") ? dimension::force : dimension::moment;
  return {int(std::find(types.begin(), types.end(), name) - types.begin()),
          load.at("value", shape).vector<3>(shape, unit)};
}

void with_scene_file(const std::filesystem::path& path, const std::function<void(Document&)>& use) {
  with_document(
      path.string(), [&](Document& document) { read_toml(path, document); }, use);
}

void with_scene_text(const std::string& text, const std::string& name,
                     const std::function<void(Document&)>& use) {
  with_document(
      name, [&](Document& document) { read_toml_text(text, name, document); }, use);
}

void read_scene_file(const std::filesystem::path& path, const std::function<SceneHead&(const Field&)>& read) {
  with_scene_file(path, [&](Document& document) {
    SceneHead& scene = read(Field(document));
    scene.notes = std::move(document.notes);
  });
}

std::vector<std::filesystem::path> scene_files(const std::filesystem::path& folder) {
  std::error_code error;
  std::vector<std::filesystem::path> files;
  for (auto it = std::filesystem::directory_iterator(folder, error); !error && it != end(it);
       it.increment(error)) {
    if (it->path().extension() == ".toml") files.push_back(it->path());
  }
  if (error || files.empty()) {
    throw SceneError(
        fmt::format("{}: holds no scene ({}); allowed: a folder with *.toml, named by HALFWAY_SCENES",
                    folder.string(), error ? error.message() : "no file *.toml"));
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace halfway::reference
