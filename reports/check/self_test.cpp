#include "reports/check/self_test.hpp"

#include "reports/check/judge/run_check.hpp"
#include "reports/cli/errors.hpp"
#include "reports/cli/streams.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace halfway::check {
namespace {

/// A subject and words that its verdict has to have.
struct Known {
  const char* subject;
  std::vector<const char*> words;
};

const std::vector<Known>& known() {
  static const std::vector<Known> all{
      {"invariant", {"your joint is invariant", "0 failed"}},
      {"invariant --mistake transposed", {"your joint is invariant", "transposed matrix"}},
      {"invariant --mistake scalar_last", {"your joint is invariant", "(x, y, z, w)"}},
      {"invariant --mistake rotation_first", {"your joint is invariant", "rotations first"}},
      {"simbody_xyz --mistake swapped", {"your joint is simbody_xyz", "bodies a and b are exchanged"}},
      {"attached_a --mistake swapped", {"your joint is attached_b"}},  // which it is
      {"invariant --mistake wrong_point", {"your joint is invariant", "about the global origin"}},
      {"invariant --mistake joint_points", {"your joint is invariant", "about the joint points"}},
      {"invariant --mistake degrees", {"your joint is invariant", "degrees"}},
      {"invariant --mistake on_bodies", {"your joint is invariant", "those on the bodies"}},
      {"'half rate'", {"half rate"}},
      {"'projected with node a'", {"projected with node a"}},
      {"intrinsic --xi 0.37", {"unknown, of the family", "xi = 0.37", "rotation vector"}},
      {"jolt_6dof", {"your joint is jolt_6dof", "FAIL             level3/body_order"}},
      {"bullet_6dof",
       {"your joint is bullet_6dof", "FAIL             level3/moment_balance",
        "FAIL             level3/loop_one"}},
      {"bullet_default", {"your joint is bullet_default", "FAIL             level3/masses"}},
      {"invariant --mistake diagonal",
       {"your joint is invariant", "FAIL             level2/coupled_axes", "2 failed"}},
      {"invariant --mistake uncoupled",
       {"your joint is invariant", "FAIL             level2/coupled_moves", "1 failed"}},
      {"invariant --mistake capped", {"your joint is invariant", "FAIL             level4/stiffness_ratio"}},
      {"invariant --mistake floored", {"your joint is invariant", "FAIL             level4/soft_axis"}},
      {"conformal --mistake frame_of_a", {"unknown", "FAIL             level2/ends"}},
      {"lsdyna_scoor_0", {"your joint is lsdyna_scoor_0", "FAIL             level3/closed_path"}},
      {"lsdyna_scoor_2", {"your joint is lsdyna_scoor_2", "FAIL             level3/closed_path"}},
      {"lsdyna_scoor_-1 --mistake transposed", {"your joint is lsdyna_scoor_-1", "transposed matrix"}},
      {"lsdyna_scoor_-3", {"your joint is lsdyna_scoor_-3", "FAIL             level3/closed_path"}},
      {"invariant --mistake lying", {"unknown", "FAIL"}},
      {"invariant --mistake hanging", {"your joint is invariant", "LOST"}},
      {"invariant --mistake crashing", {"your joint is invariant", "LOST"}},
  };
  return all;
}

std::string missing(const Known& k, const std::string& text) {
  for (const char* words : k.words)
    if (text.find(words) == std::string::npos) return words;
  return "";
}

}  // namespace

void self_test() {
  const std::string me = std::filesystem::read_symlink("/proc/self/exe");
  int wrong = 0;
  for (const Known& k : known()) {
    const auto program = running_program(fmt::format("'{}' subject {}", me, k.subject), 1, "");
    const std::string text = as_text(run_check(*program, false, [](int, int, const std::string&) {}));
    const std::string miss = missing(k, text);
    reports::print(fmt::format("{:<6} {}\n", miss.empty() ? "ok" : "WRONG", k.subject));
    if (miss.empty()) continue;
    ++wrong;
    reports::print(fmt::format("  it was not told '{}':\n{}", miss, text));
  }
  if (wrong > 0)
    throw reports::FailedRun(
        fmt::format("{} of {} programs were not told what they are", wrong, known().size()));
}

}  // namespace halfway::check
