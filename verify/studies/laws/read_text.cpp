#include "verify/studies/laws/read_text.hpp"

#include "verify/oracle/temporary_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace halfway::verify {

reference::Scene scene_of_law(Kind kind, const std::string& law, const std::string& joint) {
  const TemporaryScene file(
      "law", fmt::format("title = \"t\"\n[joint]\nkind = \"{}\"\n{}\n[joint.law]\n{}\n[[load]]\ntype = "
                         "\"{}\"\nvalue = [1, 0, 0]\n[path]\nfactor_end = 1\n",
                         to_string(kind), joint, law, kind == Kind::linear ? "fixed_force" : "fixed_moment"));
  return reference::read_scene(file.path());
}

std::string thrice(const std::string& axis) {
  return fmt::format(
      "type = \"per_axis\"\n[[joint.law.axis]]\n{0}\n[[joint.law.axis]]\n{0}\n[[joint.law.axis]]\n{0}\n",
      axis);
}

std::string list_text(const std::vector<double>& numbers) {
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

}  // namespace halfway::verify
