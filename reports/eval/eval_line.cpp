#include "reports/eval/eval_line.hpp"

#include "reports/eval/eval_parse.hpp"
#include "reports/eval/eval_request.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace halfway::reports {
namespace {

using nlohmann::json;

/// What was asked for, before it is judged.
struct EvalAnswer {
  Eigen::VectorXd strain;
  NodeLoads<double> loads;
  std::optional<double> energy;
};

/// @param id  JSON already
std::string refusal(std::string_view id, std::string_view code, std::string_view message,
                    std::string_view field) {
  const nlohmann::ordered_json error = {
      {"code", code}, {"message", message}, {"field", field.empty() ? json() : json(field)}};
  return fmt::format(R"({{"id":{},"error":{}}})", id,
                     error.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

template <int N>
LawResponse<double, N> law_response(const EvalRequest& request, const Eigen::VectorXd& strain) {
  const Eigen::Matrix<double, N, 1> e = strain;
  return reference::AnyLaw<double, N>(request.spec.law)(e);
}

/// Bounds that a regular pose keeps. Near a singular pose rounding of 1e-16 is magnified; where a
/// result is 1e12 times what stress, lever arms and the measure's own rate (at most 1 + e^2 for
/// Cayley's tangent, the steepest) can make of it, no four digits of it are left.
struct Bounds {
  double strain, loads, tangent;
};

Bounds bounds(const EvalRequest& request, const Eigen::VectorXd& strain) {
  constexpr double kLost = 1e12;
  double stress = 0, stiffness = 0, angle = 0;
  const auto measure = [&](const auto& response) {
    stress = response.stress.cwiseAbs().maxCoeff();
    stiffness = response.stiffness.cwiseAbs().maxCoeff();
  };
  if (strain.size() == 3)
    measure(law_response<3>(request, strain));
  else
    measure(law_response<6>(request, strain));
  if (request.spec.kind != Kind::linear) angle = strain.tail<3>().cwiseAbs().maxCoeff();
  const double lever =
      1 + (request.b.x - request.a.x).norm() + request.spec.a.o.norm() + request.spec.b.o.norm();
  const double rate = 1 + angle * angle;
  return {kLost, kLost * stress * lever * rate, kLost * (stiffness + stress) * lever * lever * rate * rate};
}

/// NaN is out of any bound.
template <class M>
bool is_within(const M& values, double bound) {
  return values.allFinite() && values.cwiseAbs().maxCoeff() <= bound;
}

bool is_regular(const EvalRequest& request, const EvalAnswer& answer) {
  if (!answer.strain.allFinite()) return false;
  const Bounds bound = bounds(request, answer.strain);
  const bool has_angles = request.spec.kind != Kind::linear;
  if (has_angles && !is_within(answer.strain.tail<3>(), bound.strain)) return false;
  if ((request.loads || request.tangent) && !is_within(answer.loads.q, bound.loads)) return false;
  if (request.tangent && !is_within(answer.loads.tangent, bound.tangent)) return false;
  return !answer.energy || std::isfinite(*answer.energy);
}

EvalAnswer evaluate(const EvalRequest& request) {
  const auto& evaluators = request.entry->in_double;
  EvalAnswer answer;
  answer.strain = evaluators.strain(request.spec, request.a, request.b);
  if (request.loads || request.tangent) {
    answer.loads =
        reference::node_loads<double>(*request.entry, request.spec, request.a, request.b, request.tangent);
  }
  if (request.energy) answer.energy = evaluators.energy(request.spec, request.a, request.b);
  if (!is_regular(request, answer)) {
    throw reference::Refusal(
        "singular_pose",
        fmt::format("{} has no finite result here: its rotation measure is singular at this relative "
                    "rotation, or the numbers overflow",
                    request.entry->name),
        "");
  }
  return answer;
}

template <class Values>
void append_numbers(std::string& out, const Values& values) {
  out += '[';
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (i > 0) out += ',';
    fmt::format_to(std::back_inserter(out), "{:.17g}", values[i]);
  }
  out += ']';
}

std::string written(const ParsedLine& line, const EvalRequest& request, const EvalAnswer& answer) {
  std::string out = "{\"id\":" + line.id;
  if (request.strain) append_numbers(out += ",\"strain\":", answer.strain);
  if (request.loads) append_numbers(out += ",\"loads\":", answer.loads.q);
  if (request.tangent) {
    out += ",\"tangent\":";
    for (int i = 0; i < 12; ++i) append_numbers(out += i == 0 ? '[' : ',', answer.loads.tangent.row(i));
    out += ']';
  }
  if (request.energy) {
    out += ",\"energy\":";
    out += answer.energy ? fmt::format("{:.17g}", *answer.energy) : "null";
  }
  if (const auto& notes = line.document.notes; !notes.empty()) out += ",\"notes\":" + json(notes).dump();
  return out + '}';
}

/// What `halfway check` asks first.
bool is_hello(const ParsedLine& line) {
  const auto& keys = line.document.root.keys;
  return std::ranges::find(keys, "hello") != keys.end();
}

std::string hello(std::string_view id) {
  const nlohmann::ordered_json says = {{"name", "halfway eval"},
                                       {"kinds", {"angular", "linear", "linear_angular"}},
                                       {"law", "full"},
                                       {"digits", 15},
                                       {"answers", {"strain", "loads", "tangent", "energy"}}};
  return fmt::format(R"({{"id":{},{})", id, says.dump().substr(1));
}

}  // namespace

std::string eval_line(std::string_view text) {
  ParsedLine line;
  try {
    line = parse_line(text);
    if (line.error) throw *line.error;
    if (is_hello(line)) return hello(line.id);
    const EvalRequest request = read_request(line.document);
    return written(line, request, evaluate(request));
  } catch (const reference::Refusal& e) {
    return refusal(line.id, e.code, e.what(), e.key);
  } catch (const std::exception& e) {
    return refusal(line.id, "internal_error", e.what(), "");
  }
}

std::string eval_refusal(std::string_view code, std::string_view message) {
  return refusal("null", code, message, "");
}

}  // namespace halfway::reports
