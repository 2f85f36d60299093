#include "reports/advise/truth/truth.hpp"

#include "reports/cli/errors.hpp"

#include <fmt/format.h>

#include <charconv>

namespace halfway::advise {
namespace {

using reports::BadInput;

constexpr int kMostJoints = 1000;

int joints_of(const std::string& name) {
  int joints = 0;
  const std::string_view digits = std::string_view(name).substr(6);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), joints);
  if (error != std::errc() || end != digits.data() + digits.size() || joints < 2 || joints > kMostJoints)
    throw BadInput(fmt::format("--truth {}: allowed: chain:N, N joints one after the other, 2 to {}", name,
                               kMostJoints));
  return joints;
}

}  // namespace

const char* to_string(TruthKind kind) {
  constexpr const char* kNames[] = {"none", "rod", "chain", "body", "form", "table"};
  return kNames[int(kind)];
}

Truth truth_of(const reference::Scene& scene, const std::string& name) {
  if (name == "auto")
    return has_body(scene) ? body_truth(scene) : has_rod(scene) ? rod_truth(scene) : none_truth(scene);
  if (name == "none") return none_truth(scene);
  if (name == "rod") return rod_truth(scene);
  if (name == "body") return body_truth(scene);
  if (name == "form") return form_truth(scene);
  if (name.starts_with("chain:")) return chain_truth(scene, joints_of(name));
  if (name.ends_with(".csv")) return table_truth(scene, name);
  throw BadInput(
      fmt::format("--truth {}: allowed: auto, rod, chain:N, body, form, none, or a file NAME.csv with the "
                  "columns factor, {} ...",
                  name, scene.outputs.front()));
}

Truth none_truth(const reference::Scene& scene) {
  Truth out;
  out.described = "none: laws are held against each other, and how far they are apart is no error";
  out.scene = scene;
  return out;
}

}  // namespace halfway::advise
