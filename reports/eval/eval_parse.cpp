#include "reports/eval/eval_parse.hpp"

#include <fmt/format.h>

namespace halfway::reports {
namespace {

using nlohmann::json;

constexpr int kNumberOverflow = 406;  // of nlohmann::json

/// Builds the value from the parser's events. A handler of our own, because the library's gives
/// neither a depth limit nor the place where a number overflowed nor what was read before an error.
class Builder : public nlohmann::json_sax<json> {
 public:
  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // not in text
  bool key(string_t& name) override {
    open_.back().key = std::move(name);
    return true;
  }
  bool start_object(std::size_t) override { return open(json::object()); }
  bool start_array(std::size_t) override { return open(json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& e) override {
    if (e.id == kNumberOverflow) {
      error_.emplace("not_finite", "a number is too large for double precision", path());
    } else {
      error_.emplace("malformed_json", fmt::format("not JSON at byte {}: {}", position, shortened(e.what())),
                     "");
    }
    return false;
  }

  ParsedLine take() {
    json id;
    if (root_.is_object() && !is_inside_id()) id = root_.value("id", json());
    return {std::move(root_), std::move(id), std::move(error_)};
  }

 private:
  struct Level {
    json* container;
    std::string key;  // of an object: the member being read
  };

  json* place(json value) {
    if (open_.empty()) return &(root_ = std::move(value));
    Level& level = open_.back();
    if (level.container->is_object()) return &((*level.container)[level.key] = std::move(value));
    level.container->push_back(std::move(value));
    return &level.container->back();
  }

  bool add(json value) {
    place(std::move(value));
    return true;
  }

  bool open(json container) {
    if (open_.size() == kDeepestNesting) {
      error_.emplace("too_deep", fmt::format("nested deeper than {} levels", kDeepestNesting), "");
      return false;
    }
    open_.push_back({place(std::move(container)), ""});
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  bool is_inside_id() const { return open_.size() > 1 && open_.front().key == "id"; }

  std::string path() const {
    std::string text;
    for (const Level& level : open_) {
      if (level.container->is_array()) {
        const bool holds_next_level = &level != &open_.back();
        text += fmt::format("[{}]", level.container->size() - holds_next_level);
      } else {
        text += (text.empty() ? "" : ".") + shortened(level.key);
      }
    }
    return text;
  }

  static std::string shortened(std::string_view text) {
    constexpr std::size_t kLongest = 160;
    return std::string(text.substr(0, kLongest)) + (text.size() > kLongest ? "..." : "");
  }

  json root_;
  std::vector<Level> open_;
  std::optional<EvalError> error_;
};

}  // namespace

ParsedLine parse_line(std::string_view line) {
  if (line.find_first_not_of(" \t\r") == std::string_view::npos) {
    return {{}, {}, EvalError("empty_line", "the line is empty; a request is one JSON object per line", "")};
  }
  Builder builder;
  json::sax_parse(line.begin(), line.end(), &builder);
  ParsedLine parsed = builder.take();
  if (!parsed.error && !parsed.value.is_object()) {
    parsed.error.emplace("not_an_object",
                         fmt::format("a request is a JSON object, found: {}", parsed.value.type_name()), "");
  }
  return parsed;
}

}  // namespace halfway::reports
