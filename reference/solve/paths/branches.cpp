#include "reference/solve/paths/branches.hpp"

#include <fmt/format.h>

namespace halfway::reference {

std::vector<Branch> branches(const Continuation& continuation) {
  std::vector<Branch> out{{"primary", continuation.from_rest()}};
  const std::vector<SingularPoint> met = out.front().path.singular;
  int crossing = 0;
  for (const SingularPoint& s : met) {
    if (s.type != Singularity::branching) continue;
    ++crossing;
    const char* side = "+";
    for (EquilibriumPath& half : continuation.other_path(s)) {
      out.push_back({fmt::format("second {}{}", crossing, side), std::move(half)});
      side = "-";
    }
  }
  return out;
}

Scene without_skew(const Scene& scene, int axis) {
  Scene out = scene;
  for (SceneLoad& load : out.loads) {
    if (load.type == LoadType::fixed_moment) load.value = load.value.norm() * Vec3<double>::Unit(axis);
  }
  return out;
}

}  // namespace halfway::reference
