#include "verify/studies/paths/block_paths.hpp"

#include "verify/once.hpp"
#include "verify/oracle/scene_access.hpp"

#include <memory>

namespace halfway::verify {

using namespace reference;

ContinuationOptions whole_load() {
  ContinuationOptions out;
  out.end_factor = scene(kBlockPathScene).factor_end;
  return out;
}

BlockPath::BlockPath(const Entry& entry)
    : continuation(scene(kBlockPathScene), entry, entry.probe_xi, whole_load()),
      path(continuation.from_rest()) {}

const BlockPath& skewed_path(const Entry& entry) {
  static Once<std::unique_ptr<BlockPath>> known;
  return *known(entry, [&] { return std::make_unique<BlockPath>(entry); });
}

const BlockSteps& load_steps(const Entry& entry, int count) {
  static Once<BlockSteps, int> known;
  return known(entry, count, [&] {
    const auto& [continuation, path] = skewed_path(entry);
    const double end = scene(kBlockPathScene).factor_end;
    BlockSteps out;
    out.newton = newton_load_steps(continuation.problem(), end, count);
    out.gsl = gsl_load_steps(continuation.problem(), end, count);
    out.newton_off = off_path(continuation, path, out.newton);
    out.gsl_off = off_path(continuation, path, out.gsl);
    return out;
  });
}

BlockBranches::BlockBranches(const Entry& entry)
    : continuation(straight_block(), entry, entry.probe_xi, whole_load()),
      branches(reference::branches(continuation)) {}

const Scene& straight_block() {
  static const Scene& skewed = scene(kBlockPathScene);
  static const Scene straight = without_skew(skewed, skewed.critical_axis - 1);
  return straight;
}

const BlockBranches& straight_branches(const Entry& entry) {
  static Once<std::unique_ptr<BlockBranches>> known;
  return *known(entry, [&] { return std::make_unique<BlockBranches>(entry); });
}

}  // namespace halfway::verify
