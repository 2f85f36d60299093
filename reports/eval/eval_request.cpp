#include "reports/eval/eval_request.hpp"

#include "reference/scene/names.hpp"
#include "reference/scene/read_joint.hpp"
#include "reference/scene/read_matrix.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace halfway::reports {
namespace {

using reference::Field;

const reference::Entry& read_formulation(const Field& field) {
  for (const reference::Entry& entry : reference::formulations()) {
    if (field.says(entry.name)) return entry;
  }
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

void check_rod(const Field& line, const reference::Entry& entry) {
  for (const std::string_view key : reference::kRodKeys) {
    const auto field = line.find(key);
    if (field && !entry.needs_length)
      field->refuse(fmt::format("stands beside {}, which is no rod with a length", entry.name),
                    fmt::format("no {}", key), "length_not_used");
  }
  if (entry.needs_length && !line.find("length")) {
    throw reference::Refusal(
        "length_missing", fmt::format("length = nothing: {} needs one; allowed: a number > 0, m", entry.name),
        "length");
  }
}

constexpr std::string_view kNode = "a node {x, q}";
constexpr std::string_view kPosition = "3 numbers, m, global axes";
constexpr std::string_view kTurn = "a quaternion [w, x, y, z] or the 3 rows of a rotation matrix";

/// A node as far as it is given in one place: x, q, or both.
struct Given {
  std::optional<Vec3<double>> x;
  std::optional<Mat3<double>> R;
};

Given read_given(const Field& node) {
  Given given;
  if (const auto x = node.find("x")) given.x = x->vector<3>(kPosition, reference::dimension::length);
  if (const auto q = node.find("q")) given.R = reference::read_rotation(*q);
  return given;
}

/// A node beside the poses, for all of them: o and h too, which are read with the joint.
Given read_common(const Field& line, std::string_view key) {
  const auto node = line.find(key);
  if (!node) return {};
  node->has_only({"x", "q", "o", "h"});
  return read_given(*node);
}

Pose<double> pose_of(const Field& node, const Given& given) {
  if (!given.x) node.at("x", kPosition);  // throws
  if (!given.R) node.at("q", kTurn);
  return {*given.x, *given.R};
}

/// A pose's own node, completed by what is common.
Pose<double> read_pose(const Field& pose, std::string_view key, const Given& common) {
  const auto node = pose.find(key);
  if (!node && common.x && common.R) return {*common.x, *common.R};
  if (!node) pose.at(key, kNode);
  node->has_only({"x", "q"});
  Given given = read_given(*node);
  if (!given.x) given.x = common.x;
  if (!given.R) given.R = common.R;
  return pose_of(*node, given);
}

void read_poses(const Field& line, EvalRequest& request) {
  const auto poses = line.find("poses");
  request.is_block = poses.has_value();
  if (!poses) {
    for (const char* key : {"a", "b"}) line.at(key, kNode);
  }
  const Given a = read_common(line, "a"), b = read_common(line, "b");
  if (!poses) {
    request.poses.push_back({pose_of(*line.find("a"), a), pose_of(*line.find("b"), b)});
    return;
  }
  const auto items = poses->items("an array of poses {a, b}, each node {x, q}");
  request.poses.reserve(std::size_t(std::distance(items.begin(), items.end())));
  for (const Field pose : items) {
    pose.has_only({"a", "b"});
    request.poses.push_back({read_pose(pose, "a", a), read_pose(pose, "b", b)});
  }
}

void read_want(const Field& field, EvalRequest& request) {
  for (const Field item : field.items("an array of strain, loads, tangent, energy")) {
    const std::string name = item.one_of({"strain", "loads", "tangent", "energy"}, "unknown_want");
    request.strain |= name == "strain";
    request.loads |= name == "loads";
    request.tangent |= name == "tangent";
    request.energy |= name == "energy";
  }
}

void check_law(const EvalRequest& request, const Field& law) {
  const reference::LawRefusal* refusal = reference::law_refusal(*request.entry, request.spec);
  if (refusal == nullptr) return;
  const Field at = request.entry->block_diagonal_law_only ? reference::matrix_field(law) : law;
  at.refuse(fmt::format("is refused: {} {}", request.entry->name, refusal->what), refusal->allowed,
            refusal->code);
}

reference::Names known_keys() {
  reference::Names keys = reference::kJointKeys;
  for (const char* key : {"id", "formulation", "xi", "length", "axis", "poses", "want"}) keys.push_back(key);
  return keys;
}

}  // namespace

EvalRequest read_request(reference::Document& document) {
  static const reference::Names keys = known_keys();
  const Field line(document);
  line.has_only(keys);
  EvalRequest request;
  request.entry = &read_formulation(line.at("formulation", "a name of ./halfway list"));
  const double xi = read_xi(line, *request.entry);
  check_rod(line, *request.entry);
  read_poses(line, request);
  request.spec = reference::read_joint(line);
  request.spec.xi = xi;
  reference::read_rod(line, request.spec);
  check_law(request, line.at("law", ""));
  if (const auto want = line.find("want"))
    read_want(*want, request);
  else
    request.strain = request.loads = true;
  return request;
}

}  // namespace halfway::reports
