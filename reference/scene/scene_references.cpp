#include "reference/scene/scene_references.hpp"
#include "reference/numbers/digits.hpp"

#include "reference/scene/joint/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace halfway::reference {
namespace {

constexpr Oracle kOracles[] = {Oracle::closed_form, Oracle::fifty_digits, Oracle::independent,
                               Oracle::printed, Oracle::other_program};

Oracle read_oracle(const Field& field) {
  Names names;
  for (const Oracle oracle : kOracles) names.emplace_back(to_string(oracle));
  const std::string name = field.one_of(names);
  return kOracles[std::find(names.begin(), names.end(), name) - names.begin()];
}

/// The number of a decimal text.
double decimal(const Field& field) {
  const std::string allowed = "a text of decimal digits, such as \"-1.25e-3\"";
  const std::string text = field.text();
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    field.refuse("is not a decimal number", allowed);
  }
  return value;
}

/// What all values of one table share.
struct Shared {
  SceneReference reference;
  bool by_digits = false;  ///< tolerance = "digits"
  bool has_factor = false;
};

/// Where on the curve a value is.
const char* key_of_place(const SceneHead& scene) { return scene.is_in_time ? "time" : "factor"; }

Shared read_shared(const Field& set, const SceneHead& scene) {
  Shared shared;
  SceneReference& r = shared.reference;
  r.factor = 0;
  r.oracle = read_oracle(set.at("oracle", "closed_form, fifty_digits, independent, printed, other_program"));
  r.source = set.at("source", "where the values come from").text();
  r.reason = set.at("reason", "why the tolerance is what it is").text();
  const Field tolerance = set.at("tolerance", "a number > 0 or \"digits\"");
  shared.by_digits = tolerance.is_text() && !tolerance.one_of({"digits"}).empty();
  if (!shared.by_digits) r.tolerance = tolerance.positive();
  if (const auto absolute = set.find("absolute")) r.absolute = absolute->boolean();
  if (shared.by_digits && set.find("absolute")) {
    set.find("absolute")->refuse("stands beside tolerance = \"digits\"", "one of the two");
  }
  if (const auto factor = set.find(key_of_place(scene))) {
    shared.has_factor = true;
    r.factor = factor->positive(scene.is_in_time ? dimension::time : dimension::none);
    if (r.factor > scene.factor_end) {
      factor->refuse(scene.is_in_time ? "is beyond the motion" : "is beyond the path",
                     fmt::format("0 < {} <= {} = {}", key_of_place(scene),
                                 scene.is_in_time ? "time.duration" : "path.factor_end", scene.factor_end));
    }
  }
  return shared;
}

/// The xi of one table, which the scene must solve; 0.5 stands for none.
double read_xi(const Field& set, const SceneHead& scene) {
  const auto field = set.find("xi");
  if (!field) return 0.5;
  const double xi = field->number();
  if (std::find(scene.xis.begin(), scene.xis.end(), xi) == scene.xis.end()) {
    field->refuse("is not solved by this scene", fmt::format("xis = [{}]", fmt::join(scene.xis, ", ")));
  }
  return xi;
}

void check_formulation(const Field& entry, const std::string& name, const Field& set,
                       const SceneHead& scene) {
  const Entry* formulation = find_formulation(name);
  if (!formulation) {
    const auto names = formulation_names();
    entry.refuse("is of no formulation of the catalog" + did_you_mean(name, names),
                 fmt::format("{}", fmt::join(names, ", ")), "unknown_formulation");
  }
  const auto& solved = scene.formulations;
  if (!solved.empty() && std::find(solved.begin(), solved.end(), name) == solved.end()) {
    entry.refuse("is of a formulation that this scene does not solve",
                 fmt::format("{}", fmt::join(solved, ", ")));
  }
  if (const auto xi = set.find("xi"); xi && !formulation->needs_xi) {
    xi->refuse(fmt::format("stands beside {}, which has no xi", name), "formulations with a xi");
  }
  if (formulation->needs_xi) set.at("xi", fmt::format("the xi of {}, one of xis", name));
}

void check_truth(const std::string& name, const Field& set) {
  if (const auto xi = set.find("xi"))
    xi->refuse(fmt::format("stands beside {}, which has no xi", name), "formulations with a xi");
}

void check_output(const Field& value, const std::string& output, bool has_factor, const SceneHead& scene) {
  std::vector<std::string> outputs = scene.outputs;
  if (scene.critical_axis != 0) outputs.insert(outputs.end(), {"critical_moment", "critical_angle"});
  if (scene.asks_critical) outputs.emplace_back("critical_factor");
  if (std::find(outputs.begin(), outputs.end(), output) == outputs.end()) {
    value.refuse("is of an output that this scene does not have",
                 fmt::format("{}", fmt::join(outputs, ", ")));
  }
  if (is_critical(output) && has_factor)
    value.refuse("stands beside a factor", "critical values without factor");
  if (!is_critical(output) && !has_factor)
    value.refuse(fmt::format("has no {}", key_of_place(scene)),
                 fmt::format("the {} as `{}` beside values", runs_over(scene), key_of_place(scene)));
}

SceneReference read_value(const Field& field, const std::string& output, const Shared& shared) {
  SceneReference r = shared.reference;
  r.output = output;
  if (field.text() == "none") {
    if (!is_critical(output)) field.refuse("there is always one", "a text of decimal digits");
    r.none = true;
    return r;
  }
  const double number = decimal(field);
  r.value = field.text();
  if (shared.by_digits) {
    r.absolute = true;
    r.tolerance = 0.5 * last_digit(r.value);
  } else if (number == 0 && !r.absolute) {
    field.refuse("has no relative tolerance", "absolute = true beside it, or another value");
  }
  return r;
}

}  // namespace

std::vector<SceneReference> read_reference_set(const Field& set, const SceneHead& scene,
                                               std::string_view truth) {
  set.has_only({"source", "oracle", "tolerance", "absolute", "reason", key_of_place(scene), "xi", "values"});
  Shared shared = read_shared(set, scene);
  shared.reference.xi = read_xi(set, scene);
  const Field values = set.at("values", "a table formulation = { output = \"digits\" }");
  std::vector<SceneReference> out;
  for (const std::string& name : values.keys()) {
    const Field entry = *values.find(name);
    if (!truth.empty() && name == truth)
      check_truth(name, set);
    else
      check_formulation(entry, name, set, scene);
    for (const std::string& output : entry.keys()) {
      const Field value = *entry.find(output);
      check_output(value, output, shared.has_factor, scene);
      out.push_back(read_value(value, output, shared));
      out.back().formulation = name;
    }
  }
  if (out.empty()) values.refuse("is empty", "at least one formulation = { output = \"digits\" }");
  return out;
}

}  // namespace halfway::reference
