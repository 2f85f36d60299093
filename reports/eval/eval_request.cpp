#include "reports/eval/eval_request.hpp"

#include "reports/eval/eval_law.hpp"
#include "reports/eval/suggest.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace halfway::reports {
namespace {

// Room for quaternions written with 7 digits; more is a mistake, not rounding.
constexpr double kUnitLength = 1e-6;

const reference::Entry& read_formulation(const Field& field) {
  const std::string& name = text(field);
  if (const auto* entry = reference::find_formulation(name)) return *entry;
  if (name == "linearized") {
    throw EvalError("scenes_only", "linearized has no finite pose: it exists for scenes only", field.path);
  }
  throw EvalError("unknown_formulation", unknown_name("formulation", name, formulation_names()), field.path);
}

Kind read_kind(const Field& field) {
  const std::string& name = text(field);
  if (name == "angular") return Kind::angular;
  if (name == "linear") return Kind::linear;
  if (name == "linear_angular") return Kind::linear_angular;
  throw EvalError("unknown_kind", unknown_name("kind", name, {"angular", "linear", "linear_angular"}),
                  field.path);
}

double read_xi(const Field& line, const reference::Entry& entry) {
  const auto field = member(line, "xi");
  if (!entry.needs_xi && field) {
    throw EvalError("xi_not_used", fmt::format("{} has no free xi; leave 'xi' out", entry.name), field->path);
  }
  if (entry.needs_xi && !field) {
    throw EvalError("xi_missing", fmt::format("{} needs 'xi', any real number", entry.name), "xi");
  }
  return field ? number(*field) : entry.probe_xi;
}

Mat3<double> read_rotation(const Field& field) {
  const Eigen::Vector4d q = numbers(field, 4);
  const double length = q.stableNorm();
  if (!(std::abs(length - 1) <= kUnitLength)) {
    throw EvalError(
        "not_unit_quaternion",
        fmt::format("a quaternion [w, x, y, z] has length 1 to {:g}, found {:.17g}", kUnitLength, length),
        field.path);
  }
  return so3::matrix<double>({q[0] / length, q.tail<3>() / length});
}

void read_node(const Field& node, Pose<double>& pose, JointEnd<double>& end) {
  require_object(node, {"x", "q", "o", "h"});
  pose.x = numbers(required(node, "x"), 3);
  pose.R = read_rotation(required(node, "q"));
  if (const auto o = member(node, "o")) end.o = numbers(*o, 3);
  if (const auto h = member(node, "h")) end.H = read_rotation(*h);
}

void read_want(const Field& field, EvalRequest& request) {
  if (!field.value.is_array()) {
    throw EvalError("wrong_type",
                    fmt::format("expected an array of strings, found: {}", field.value.type_name()),
                    field.path);
  }
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    const Field item{field.value[i], fmt::format("{}[{}]", field.path, i)};
    const std::string& name = text(item);
    if (name == "strain")
      request.strain = true;
    else if (name == "loads")
      request.loads = true;
    else if (name == "tangent")
      request.tangent = true;
    else if (name == "energy")
      request.energy = true;
    else {
      throw EvalError("unknown_want", unknown_name("output", name, {"strain", "loads", "tangent", "energy"}),
                      item.path);
    }
  }
}

}  // namespace

EvalRequest read_request(const nlohmann::json& json) {
  const Field line{json, ""};
  require_object(line, {"id", "formulation", "xi", "kind", "law", "a", "b", "want"});
  EvalRequest request;
  request.entry = &read_formulation(required(line, "formulation"));
  request.spec.xi = read_xi(line, *request.entry);
  request.spec.kind = read_kind(required(line, "kind"));
  request.spec.law = read_law(required(line, "law"), request.spec.kind, *request.entry);
  read_node(required(line, "a"), request.a, request.spec.a);
  read_node(required(line, "b"), request.b, request.spec.b);
  if (const auto want = member(line, "want"))
    read_want(*want, request);
  else
    request.strain = request.loads = true;
  return request;
}

}  // namespace halfway::reports
