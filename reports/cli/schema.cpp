#include "reports/cli/schema.hpp"

#include "reference/scene/any_scene.hpp"
#include "reference/scene/scene_head.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string_view>

namespace halfway::reports {
namespace {

using reference::Document, reference::DocumentNode, reference::Question;
using Json = nlohmann::ordered_json;
using Words = std::set<std::string>;

/// What may stand at one place of scene files, gathered from all of them. Tables of an array are at the
/// array's own: one joint and the joints of a mechanism have the same words.
struct Place {
  std::map<std::string, Place> keys{};  ///< of a table; other items of an array are at ""
  Words allowed{};                      ///< keys, where the reader takes no others
  std::optional<Words> needed{};        ///< those asked for of every table here
  bool is_table = false, is_closed = false, is_list = false, holds_tables = false;
  std::vector<Question> asked{};
};

Place& place_of(Place& root, const Document& document, std::size_t place) {
  Place* at = &root;
  for (const std::size_t node : reference::way_to(document, place)) {
    const DocumentNode& item = document.nodes[node];
    if (item.type == DocumentNode::Type::table && item.key.empty()) continue;
    at = &at->keys[std::string(item.key)];
  }
  return *at;
}

void add_tables(Place& root, const Document& document) {
  for (std::size_t i = 0; i < document.nodes.size(); ++i) {
    const auto type = document.nodes[i].type;
    const bool is_item = i > 0 && document.nodes[i].key.empty();
    Place& place = place_of(root, document, i);
    if (type == DocumentNode::Type::table) (is_item ? place.holds_tables : place.is_table) = true;
    if (type == DocumentNode::Type::array) place.is_list = true;
  }
}

void add(Place& root, const Document& document, const std::vector<Question>& questions) {
  add_tables(root, document);
  std::map<std::size_t, Words> needed;
  for (const Question& question : questions) {
    Place& place = place_of(root, document, question.place);
    if (question.type == Question::Type::required_key) {
      needed[question.place].insert(question.words.begin(), question.words.end());
    } else if (question.type == Question::Type::keys) {
      place.is_closed = true;
      place.allowed.insert(question.words.begin(), question.words.end());
      needed[question.place];
    } else {
      place.asked.push_back(question);
    }
  }
  for (auto& [at, words] : needed) {
    Place& place = place_of(root, document, at);
    if (!place.needed) place.needed = words;
    std::erase_if(*place.needed, [&](const std::string& word) { return !words.contains(word); });
  }
}

/// A number, or a text of one with its unit.
Json number(const std::string& unit) {
  if (unit.empty()) return {{"type", "number"}};
  return {{"type", Json::array({"number", "string"})}, {"description", unit + ", or a text with a unit"}};
}

Json list(const Json& items, const Question& of) {
  Json out = {{"type", "array"}, {"items", items}};
  if (of.size > 0) out["minItems"] = out["maxItems"] = of.size;
  return out;
}

Json with_unit(const Json& values) {
  return {{"type", "object"},
          {"properties", {{"values", values}, {"unit", {{"type", "string"}}}}},
          {"required", {"values", "unit"}},
          {"additionalProperties", false}};
}

/// One of the words, or any name.
Json name(const std::vector<std::string>& words) {
  if (words.empty()) return {{"type", "string"}, {"minLength", 1}};
  return Json::object({{"enum", words}});
}

/// What one question takes.
std::vector<Json> answers(const Question& question) {
  using Type = Question::Type;
  switch (question.type) {
    case Type::text:
      return {name({})};
    case Type::boolean:
      return {{{"type", "boolean"}}};
    case Type::number:
      return {number(question.unit)};
    case Type::integer:
      return {{{"type", "integer"}, {"minimum", question.low}, {"maximum", question.high}}};
    case Type::name:
      return {name(question.words)};
    case Type::names:
      return {list(name(question.words), question)};
    default:
      break;
  }
  Json values = list(number(question.unit), question);
  if (question.type == Type::matrix) values = list(values, question);
  if (question.unit.empty()) return {values};
  return {values, with_unit(values)};
}

void add_new(std::vector<Json>& to, const Json& schema) {
  if (std::ranges::find(to, schema) == to.end()) to.push_back(schema);
}

/// One list of names for a place: the one that has all that any file may use there, or none where that
/// differs from file to file: names of the scene's own, any text.
std::vector<Question> with_common_names(std::vector<Question> asked) {
  std::vector<Question*> lists;
  Words all;
  for (Question& question : asked) {
    if (question.type != Question::Type::name && question.type != Question::Type::names) continue;
    lists.push_back(&question);
    all.insert(question.words.begin(), question.words.end());
  }
  const auto whole =
      std::ranges::find_if(lists, [&](auto* list) { return list->words.size() == all.size(); });
  const auto words = whole == lists.end() ? std::vector<std::string>{} : (*whole)->words;
  for (Question* list : lists) list->words = words;
  return asked;
}

class Writer {
 public:
  explicit Writer(std::vector<std::string>& unseen) : unseen_(unseen) {}

  Json schema(const Place& place, const std::string& path) {
    std::vector<Json> out;
    for (const Question& question : with_common_names(place.asked))
      for (const Json& answer : answers(question)) add_new(out, answer);
    const bool has_values = !place.asked.empty();
    if (place.is_table && !(has_values && place.keys.contains("values"))) add_new(out, table(place, path));
    if (place.holds_tables) add_new(out, {{"type", "array"}, {"minItems", 1}, {"items", table(place, path)}});
    if (place.is_list && !has_values && !place.holds_tables) add_new(out, items(place, path));
    if (out.empty() && std::ranges::find(unseen_, path) == unseen_.end()) unseen_.push_back(path);
    if (out.size() == 1) return out.front();
    return out.empty() ? Json::object() : Json{{"anyOf", out}};
  }

 private:
  Json items(const Place& place, const std::string& path) {
    const auto found = place.keys.find("");
    Json out = {{"type", "array"}, {"minItems", 1}};
    if (found != place.keys.end()) out["items"] = schema(found->second, path + "[]");
    return out;
  }

  Json table(const Place& place, const std::string& path) {
    Json out = {{"type", "object"}};
    const std::string stem = path.empty() ? "" : path + ".";
    if (!place.is_closed) {  // keys are names of the scene's own
      std::vector<Json> each;
      for (const auto& [key, child] : place.keys)
        if (!key.empty()) add_new(each, schema(child, stem + "*"));
      out["additionalProperties"] = each.size() == 1 ? each.front() : Json{{"anyOf", each}};
      return out;
    }
    Json properties = Json::object();
    for (const std::string& key : place.allowed) {
      const auto found = place.keys.find(key);
      properties[key] = schema(found == place.keys.end() ? Place{} : found->second, stem + key);
    }
    out["properties"] = properties;
    if (place.needed && !place.needed->empty()) out["required"] = *place.needed;
    out["additionalProperties"] = false;
    return out;
  }

  std::vector<std::string>& unseen_;
};

}  // namespace

Json scene_schema(std::vector<std::string>& unseen) {
  std::vector<std::filesystem::path> folders = {reference::scenes_folder()};
  for (const char* name : {"chains", "mechanisms", "motion", "seen", "words"})
    folders.push_back(folders.front() / name);
  Place root;
  for (const auto& folder : folders) {
    for (const auto& file : reference::scene_files(folder))
      reference::with_questions(file, [&](const Document& document, const std::vector<Question>& questions) {
        add(root, document, questions);
      });
  }
  Json out = {{"$schema", "http://json-schema.org/draft-07/schema#"},
              {"title", "A scene of halfway"},
              {"description",
               "Generated by `halfway list --schema`; reference/scenes/README.md says what it means."}};
  out.update(Writer(unseen).schema(root, ""));
  return out;
}

}  // namespace halfway::reports
