#include "reports/eval/line_tree.hpp"
#include "reports/import/readers/documents.hpp"
#include "reports/import/record/text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iterator>

namespace halfway::imports {
namespace {

using nlohmann::json;
using reference::Document;
using reference::Refusal;

constexpr int kNumberOverflow = 406;  // of nlohmann::json

/// Where the parser is: it reads one character beyond a number, which may end the line.
struct Place {
  int line = 1;
  int before_last = 1;  ///< without the last character read
};

/// Over a text, counting lines for all copies.
class Counted {
 public:
  using difference_type = std::ptrdiff_t;
  using value_type = char;
  using pointer = const char*;
  using reference = const char&;
  using iterator_category = std::input_iterator_tag;

  Counted(const char* at, Place* place) : at_(at), place_(place) {}
  reference operator*() const { return *at_; }
  Counted& operator++() {
    place_->before_last = place_->line;
    if (*at_ == '\n') ++place_->line;
    ++at_;
    return *this;
  }
  Counted operator++(int) {
    Counted old = *this;
    ++*this;
    return old;
  }
  bool operator==(const Counted& other) const { return at_ == other.at_; }
  bool operator!=(const Counted& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  Place* place_;
};

class JsonEvents : public json::json_sax_t {
 public:
  JsonEvents(Document& document, const Place& place)
      : document_(&document), place_(&place), tree_(document) {}

  bool null() override {
    return here([&] { tree_.add_nothing(); });
  }
  bool boolean(bool value) override {
    return here([&] { tree_.add_boolean(value); });
  }
  bool number_integer(number_integer_t value) override {
    return number_float(double(value), fmt::format("{}", value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return number_float(double(value), fmt::format("{}", value));
  }
  bool number_float(number_float_t value, const string_t& written) override {
    return here([&] { tree_.add_number(value, document_->keep(written)); });
  }
  bool string(string_t& value) override {
    return here([&] { tree_.add_text(document_->keep(std::move(value))); });
  }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override {
    return here([&] { tree_.open_table(); });
  }
  bool key(string_t& name) override { return tree_.key(document_->keep(std::move(name))), true; }
  bool end_object() override {
    return told([&] { tree_.close_table(); });
  }
  bool start_array(std::size_t) override {
    return here([&] { tree_.open_array(); });
  }
  bool end_array() override {
    return told([&] { tree_.close_array(); });
  }
  bool parse_error(std::size_t, const std::string& last, const nlohmann::detail::exception& e) override {
    if (e.id == kNumberOverflow)
      refuse({place_->before_last, "a number", last}, "is too large for double precision", "a finite number");
    const std::string what = e.what();
    throw Refusal(
        "malformed_json",
        fmt::format("the file: is not JSON near '{}' ({}); allowed: JSON, with // and /* */ comments",
                    reference::shortened(last),
                    what.substr(what.find("error") == std::string::npos ? 0 : what.find("error"), 120)),
        "", place_->before_last);
  }

 private:
  /// With the line of what is refused.
  template <class Fn>
  bool told(Fn&& fn) {
    try {
      fn();
    } catch (Refusal& refusal) {
      refusal.line = place_->before_last;
      throw;
    }
    return true;
  }
  template <class Fn>
  bool here(Fn&& fn) {
    told(fn);
    document_->nodes.back().line = place_->before_last;
    return true;
  }

  Document* document_;
  const Place* place_;
  reports::LineTree tree_;
};

}  // namespace

Document read_json(std::string_view text) {
  Document document;
  Place place;
  JsonEvents events(document, place);
  json::sax_parse(Counted(text.data(), &place), Counted(text.data() + text.size(), &place), &events,
                  json::input_format_t::json, true, true);
  return document;
}

}  // namespace halfway::imports
