#include "reports/import/readers/expression.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <numbers>

namespace halfway::imports {
namespace {

constexpr int kDeepest = 32;  // parentheses inside each other

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

class Parser {
 public:
  Parser(const Source& at, const Variables& variables) : at_(at), text_(at.text), variables_(variables) {}

  double whole() {
    const double value = sum(0);
    if (!peek() && std::isfinite(value)) return value;
    if (!peek()) refuse(at_, "is not finite", "a finite number");
    wrong();
  }

 private:
  [[noreturn]] void wrong() const {
    refuse(at_, "is no number or expression that can be read",
           "numbers, names that were set, + - * / ^ ( ), sqrt, sin, cos, tan, pi");
  }

  /// The next character that is no blank; 0 at the end.
  char peek() {
    while (place_ < text_.size() && (text_[place_] == ' ' || text_[place_] == '\t')) ++place_;
    return place_ < text_.size() ? text_[place_] : '\0';
  }

  double sum(int depth) {
    if (depth > kDeepest) refuse(at_, "is nested too deep", fmt::format("up to {} parentheses", kDeepest));
    double value = product(depth);
    while (peek() == '+' || peek() == '-') {
      const bool is_minus = text_[place_++] == '-';
      const double other = product(depth);
      value = is_minus ? value - other : value + other;
    }
    return value;
  }

  double product(int depth) {
    double value = signed_power(depth);
    while (peek() == '*' || peek() == '/') {
      const bool is_quotient = text_[place_++] == '/';
      const double other = signed_power(depth);
      value = is_quotient ? value / other : value * other;
    }
    return value;
  }

  double signed_power(int depth) {
    bool is_minus = false;
    while (peek() == '-' || peek() == '+') is_minus ^= text_[place_++] == '-';
    double value = atom(depth);
    if (peek() == '^') {
      ++place_;
      value = std::pow(value, exponent(depth + 1));
    }
    return is_minus ? -value : value;
  }

  double exponent(int depth) {
    if (depth > kDeepest) refuse(at_, "is nested too deep", fmt::format("up to {} powers", kDeepest));
    return signed_power(depth);
  }

  double atom(int depth) {
    const char c = peek();
    if (c == '(') return enclosed(depth);
    if (is_letter(c)) return named_value(depth);
    if (!is_digit(c) && c != '.') wrong();
    double value = 0;
    const auto [rest, error] = std::from_chars(text_.data() + place_, text_.data() + text_.size(), value);
    if (error != std::errc{}) wrong();
    place_ = std::size_t(rest - text_.data());
    return value;
  }

  double enclosed(int depth) {
    ++place_;
    const double value = sum(depth + 1);
    if (peek() != ')') wrong();
    ++place_;
    return value;
  }

  double named_value(int depth) {
    const std::size_t begin = place_;
    while (place_ < text_.size() && (is_letter(text_[place_]) || is_digit(text_[place_]))) ++place_;
    const std::string_view name = text_.substr(begin, place_ - begin);
    if (const auto found = variables_.find(name); found != variables_.end()) return found->second;
    if (name == "pi") return std::numbers::pi;
    if (peek() == '(') return applied(name, enclosed(depth));
    refuse(at_, fmt::format("has the name '{}', which was not set before", name),
           "set: const real NAME = NUMBER; in the same file");
  }

  double applied(std::string_view name, double x) const {
    if (name == "sqrt") return std::sqrt(x);
    if (name == "sin") return std::sin(x);
    if (name == "cos") return std::cos(x);
    if (name == "tan") return std::tan(x);
    wrong();
  }

  const Source& at_;
  std::string_view text_;
  const Variables& variables_;
  std::size_t place_ = 0;
};

}  // namespace

double value_of(const Source& at, const Variables& variables) { return Parser(at, variables).whole(); }

}  // namespace halfway::imports
