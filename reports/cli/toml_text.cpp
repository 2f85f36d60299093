#include "reports/cli/toml_text.hpp"

#include "reports/cli/streams.hpp"

#include <fmt/format.h>

namespace halfway::reports::toml {
namespace {

/// Bytes of the UTF-8 character that begins at `at`, 0 where none does. Surrogates and what is longer than it
/// need be are none.
std::size_t character_at(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0u;
  };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  const unsigned second = byte(1);
  const bool is_short = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool is_beyond = (first == 0xED && second >= 0xA0) || (first == 0xF4 && second >= 0x90);
  return first < 0xC2 || first > 0xF4 || is_short || is_beyond ? 0 : size;
}

}  // namespace

std::string readable(std::string_view text) {
  const std::string shown = printable(text);
  std::string out;
  for (std::size_t i = 0; i < shown.size();) {
    const std::size_t size = character_at(shown, i);
    out += size ? shown.substr(i, size) : "?";
    i += size ? size : 1;
  }
  return out;
}

std::string digits(double value) { return fmt::format("{}", value + 0.0); }

std::string list(std::span<const double> values) {
  std::string out;
  for (double value : values) out += (out.empty() ? "" : ", ") + digits(value);
  return "[" + out + "]";
}

std::string rows(const Eigen::MatrixXd& m) {
  std::string out;
  for (Eigen::Index i = 0; i < m.rows(); ++i) out += (i ? ",\n  " : "\n  ") + list_of(m.row(i).transpose());
  return "[" + out + "]";
}

std::string quoted(const std::string& text) {
  std::string out;
  for (const char c : readable(text)) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return '"' + out + '"';
}

}  // namespace halfway::reports::toml
