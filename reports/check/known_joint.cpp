#include "reports/check/known_joint.hpp"

#include "reference/programs/joints.hpp"
#include "reference/programs/path_joints.hpp"
#include "reports/check/judge/wrong_twins.hpp"
#include "reports/cli/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace halfway::check {

reference::Answerer known_joint(const std::string& name, double xi) {
  if (const auto* program = reference::find_program_joint(name)) return program->in_double;
  if (const auto* path = reference::find_path_joint(name)) return path->answer;
  if (const auto* entry = reference::find_formulation(name)) return reference::answerer(*entry, xi);
  for (const auto& twin : wrong_twins())
    if (twin.name.find(name) != std::string::npos) return twin.answer;
  std::vector<std::string> names;
  for (const auto& known : reference::known_joints()) names.push_back(known.name);
  for (const auto& known : reference::path_joints()) names.emplace_back(known.name);
  throw reports::BadInput(fmt::format("no joint is called '{}'; allowed: {}", name, fmt::join(names, ", ")));
}

}  // namespace halfway::check
