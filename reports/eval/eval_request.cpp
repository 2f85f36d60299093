#include "reports/eval/eval_request.hpp"

#include "reference/scene/names.hpp"
#include "reference/scene/read_joint.hpp"
#include "reference/scene/read_law.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace halfway::reports {
namespace {

using reference::Field;

const reference::Entry& read_formulation(const Field& field) {
  const auto names = reference::formulation_names();
  if (field.says(reference::kLinearized)) {
    field.refuse("has no finite pose: it exists for scenes only", fmt::format("{}", fmt::join(names, ", ")),
                 "scenes_only");
  }
  return *reference::find_formulation(field.one_of(names, "unknown_formulation"));
}

double read_xi(const Field& line, const reference::Entry& entry) {
  const auto field = line.find("xi");
  if (!entry.needs_xi && field)
    field->refuse(fmt::format("stands beside {}, which has no free xi", entry.name), "no xi", "xi_not_used");
  if (entry.needs_xi && !field) {
    throw reference::Refusal(
        "xi_missing", fmt::format("xi = nothing: {} needs one; allowed: any real number", entry.name), "xi");
  }
  return field ? field->number() : entry.probe_xi;
}

Pose<double> read_pose(const Field& node) {
  node.has_only({"x", "q", "o", "h"});
  const std::string position = "3 numbers, m, global axes";
  const std::string turn = "a quaternion [w, x, y, z] or the 3 rows of a rotation matrix";
  return {node.at("x", position).vector(3, position), reference::read_rotation(node.at("q", turn))};
}

void read_want(const Field& field, EvalRequest& request) {
  for (const Field& item : field.items("an array of strain, loads, tangent, energy")) {
    const std::string name = item.one_of({"strain", "loads", "tangent", "energy"}, "unknown_want");
    request.strain |= name == "strain";
    request.loads |= name == "loads";
    request.tangent |= name == "tangent";
    request.energy |= name == "energy";
  }
}

void check_coupling(const EvalRequest& request, const Field& law) {
  if (reference::accepts_law(*request.entry, request.spec)) return;
  reference::matrix_field(law).refuse(
      fmt::format("couples translation and rotation, which {} does not", request.entry->name),
      "off-diagonal 3x3 blocks of zeros", "block_diagonal_law_only");
}

}  // namespace

EvalRequest read_request(reference::Document& document) {
  const Field line(document);
  reference::Names keys = reference::kJointKeys;
  for (const char* key : {"id", "formulation", "xi", "want"}) keys.push_back(key);
  line.has_only(keys);
  EvalRequest request;
  request.entry = &read_formulation(line.at("formulation", "a name of ./halfway list"));
  const double xi = read_xi(line, *request.entry);
  request.a = read_pose(line.at("a", "a node {x, q}"));
  request.b = read_pose(line.at("b", "a node {x, q}"));
  request.spec = reference::read_joint(line);
  request.spec.xi = xi;
  check_coupling(request, line.at("law", ""));
  if (const auto want = line.find("want"))
    read_want(*want, request);
  else
    request.strain = request.loads = true;
  return request;
}

}  // namespace halfway::reports
