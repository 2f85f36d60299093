#include "reports/eval/line_tree.hpp"
#include "reports/import/readers/documents.hpp"
#include "reports/import/record/text.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <charconv>
#include <optional>
#include <sstream>
#include <vector>

namespace halfway::imports {
namespace {

using reference::Document;
using reference::Refusal;

std::optional<double> plain_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || rest != text.data() + text.size() || error != std::errc{}) return std::nullopt;
  return value;
}

/// From yaml-cpp's events to the tree; of a table each second scalar is a key.
class YamlEvents : public YAML::EventHandler {
 public:
  explicit YamlEvents(Document& document) : document_(&document), tree_(document) {}

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override {
    if (awaits_key()) refuse_key(mark);
    value(mark, [&] { tree_.add_nothing(); });
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    refuse({mark.line + 1, "an alias", "*"}, "is not followed", "YAML without anchors and aliases");
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                const std::string& text) override {
    if (awaits_key()) {
      tree_.key(document_->keep(text));
      open_.back().has_key = true;
      return;
    }
    value(mark, [&] { scalar(tag, text); });
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    if (awaits_key()) refuse_key(mark);
    value(mark, [&] { tree_.open_array(); });
    open_.push_back({false, false, mark.line + 1});
  }
  void OnSequenceEnd() override {
    closed([&] { tree_.close_array(); });
  }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    if (awaits_key()) refuse_key(mark);
    value(mark, [&] { tree_.open_table(); });
    open_.push_back({true, false, mark.line + 1});
  }
  void OnMapEnd() override {
    closed([&] { tree_.close_table(); });
  }

 private:
  struct Open {
    bool is_table, has_key;
    int line;
  };

  bool awaits_key() const { return !open_.empty() && open_.back().is_table && !open_.back().has_key; }

  [[noreturn]] static void refuse_key(const YAML::Mark& mark) {
    refuse({mark.line + 1, "a key", "no text"}, "is not known", "keys that are texts");
  }

  void scalar(const std::string& tag, const std::string& text) {
    const bool is_plain = tag == "?";
    const auto number = is_plain ? plain_number(text) : std::nullopt;
    if (number)
      tree_.add_number(*number, document_->keep(text));
    else if (is_plain && (text == "true" || text == "false"))
      tree_.add_boolean(text == "true");
    else
      tree_.add_text(document_->keep(text));
  }

  template <class Fn>
  void value(const YAML::Mark& mark, Fn&& fn) {
    try {
      fn();
    } catch (Refusal& refusal) {
      refusal.line = mark.line + 1;
      throw;
    }
    document_->nodes.back().line = mark.line + 1;
    if (!open_.empty()) open_.back().has_key = false;
  }

  template <class Fn>
  void closed(Fn&& fn) {
    try {
      fn();
    } catch (Refusal& refusal) {
      refusal.line = open_.back().line;
      throw;
    }
    open_.pop_back();
  }

  Document* document_;
  reports::LineTree tree_;
  std::vector<Open> open_{};
};

}  // namespace

Document read_yaml(std::string_view text) {
  Document document;
  YamlEvents events(document);
  std::istringstream in{std::string(text)};
  try {
    YAML::Parser parser(in);
    parser.HandleNextDocument(events);
  } catch (const YAML::Exception& e) {
    throw Refusal("malformed_yaml",
                  fmt::format("the file: is not YAML ({}); allowed: YAML 1.2", reference::shortened(e.msg)),
                  "", e.mark.line + 1);
  }
  if (document.nodes.empty()) refuse({1, "the file", ""}, "has no document", "YAML with a table");
  return document;
}

}  // namespace halfway::imports
