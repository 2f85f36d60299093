#include "reports/eval/eval_fields.hpp"

#include "reports/eval/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace halfway::reports {
namespace {

std::string joined(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

[[noreturn]] void wrong_type(const Field& field, std::string_view expected) {
  throw EvalError("wrong_type", fmt::format("expected {}, found: {}", expected, field.value.type_name()),
                  field.path);
}

void require_length(const Field& field, int count, std::string_view of_what) {
  if (!field.value.is_array()) wrong_type(field, fmt::format("an array of {} {}", count, of_what));
  if (field.value.size() != std::size_t(count)) {
    throw EvalError("wrong_shape",
                    fmt::format("expected {} {}, found {}", count, of_what, field.value.size()), field.path);
  }
}

Field element(const Field& array, int i) {
  return {array.value[std::size_t(i)], fmt::format("{}[{}]", array.path, i)};
}

}  // namespace

void require_object(const Field& field, const std::vector<std::string_view>& allowed) {
  if (!field.value.is_object()) wrong_type(field, "an object");
  for (const auto& [key, value] : field.value.items()) {
    if (std::ranges::find(allowed, key) != allowed.end()) continue;
    throw EvalError("unknown_key", unknown_name("key", key, allowed),
                    joined(field.path, std::string_view(key).substr(0, 60)));
  }
}

std::optional<Field> member(const Field& object, std::string_view key) {
  const auto found = object.value.find(key);
  if (found == object.value.end()) return std::nullopt;
  return Field{*found, joined(object.path, key)};
}

Field required(const Field& object, std::string_view key) {
  if (auto field = member(object, key)) return *field;
  throw EvalError("missing_key", fmt::format("'{}' is missing", key), joined(object.path, key));
}

double number(const Field& field) {
  if (!field.value.is_number()) wrong_type(field, "a number");
  return field.value.get<double>();
}

const std::string& text(const Field& field) {
  if (!field.value.is_string()) wrong_type(field, "a string");
  return field.value.get_ref<const std::string&>();
}

Eigen::VectorXd numbers(const Field& field, int count) {
  require_length(field, count, "numbers");
  Eigen::VectorXd out(count);
  for (int i = 0; i < count; ++i) {
    const auto& value = field.value[std::size_t(i)];
    if (!value.is_number()) wrong_type(element(field, i), "a number");
    out[i] = value.get<double>();
  }
  return out;
}

Eigen::MatrixXd square_matrix(const Field& field, int size) {
  require_length(field, size, "rows");
  Eigen::MatrixXd out(size, size);
  for (int i = 0; i < size; ++i) out.row(i) = numbers(element(field, i), size).transpose();
  return out;
}

}  // namespace halfway::reports
