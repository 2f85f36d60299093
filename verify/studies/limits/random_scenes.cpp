// Ten thousand random scenes: each ends in equilibrium or with a named reason. And five hundred random
// scene files: each is read, or refused with its line.
#include "reference/record/effort.hpp"
#include "reference/solve/solve.hpp"
#include "verify/oracle/kept.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/replay.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/limits/random_scene.hpp"
#include "verify/studies/limits/random_scene_text.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>

namespace halfway::verify {
namespace {

using reference::Entry;
using reference::RandomScene;
using reference::SceneError;

constexpr int kAllScenes = 600;  // of each formulation: more than 10 000 with the seventeen of the catalog
const int kScenes = by_effort(kAllScenes, 50);
constexpr int kNamed = 25;  // every so many also as a curve, for its sentence
constexpr int kTexts = 500;

struct Tally {
  int ends[4] = {};        ///< by Status
  int broken = 0;          ///< not finite, or a status that is none
  int unnamed = 0;         ///< curves that say nothing
  Measurement from_truth;  ///< of the converged states
  Measurement estimate;    ///< the same over the solver's own estimate
};

void include_truth(const Entry& entry, const RandomScene& random, const Outcome<double>& state,
                   const std::string& where, Tally& tally) {
  constexpr double kRead = 4e-16;  // of a pose's own numbers
  const double size = 1 + state.joint.x.norm();
  const double estimate = state.error.tail<3>().norm() + state.error.head<3>().norm() / size + kRead;
  const double distance = distance_to_equilibrium(random, entry, state);
  const auto worst = [&](Measurement& of, double value) {
    if (of.include(value, where)) of.set_replay(scene_text(random.scene, entry, random.xi, random.setting));
  };
  worst(tally.from_truth, distance);
  worst(tally.estimate, distance / estimate);
}

void solve_one(const Entry& entry, const RandomScene& random, int index, Tally& tally) {
  reference::Path<double> path(random.scene, entry, random.xi, random.setting);
  const Outcome<double>& state = path.advance(1);
  const auto end = std::size_t(state.status);
  const std::string where = fmt::format("scene {}, {}", index, to_string(random.scene.joint.kind));
  if (end > 3 || !is_finite(random, entry, state)) ++tally.broken;
  if (end <= 3) ++tally.ends[end];
  if (state.status == Status::converged) include_truth(entry, random, state, where, tally);
}

/// What a user reads: a sentence, and no row that is not a number.
bool is_named(const Entry& entry, const RandomScene& random) {
  reference::Scene scene = random.scene;
  scene.points = 2;
  scene.outputs = {scene.joint.kind == Kind::linear ? "u_x" : "theta_x"};
  const reference::Curve curve = solve_scene(scene, {&entry, random.xi});
  for (const auto& row : curve.rows) {
    if (!std::ranges::all_of(row, [](double x) { return std::isfinite(x); })) return false;
  }
  return curve.converged ? curve.outcome == "converged" : curve.outcome.starts_with("stopped");
}

Tally solve_all(const Entry& entry) {
  reference::Generator generator(20260);
  Tally tally;
  for (int i = 0; i < kScenes; ++i) {
    const RandomScene random = random_scene(generator, entry);
    solve_one(entry, random, i, tally);
    if (i % kNamed == 0) tally.unnamed += !is_named(entry, random);
  }
  return tally;
}

Draft of_scenes(const Entry& entry, const std::string& what) {
  return finding(fmt::format("{}/random_scenes/{}", entry.name, what))
      .of(std::string(entry.name))
      .about("random_scenes");
}

/// Scenes of 600 that end in equilibrium, kept from this code. Loads beyond what a law carries and laws that
/// soften leave the others without one; a solver that gives up early falls below.
struct Kept {
  std::string_view name;
  int converged;
};
constexpr Kept kConverged[] = {
    {"attached_a", 402},      {"attached_b", 394}, {"invariant", 397},   {"intrinsic", 386},
    {"jointc", 372},          {"field_a", 395},    {"field_b", 390},     {"conformal", 404},
    {"potential", 396},       {"helicoidal", 403}, {"quaternion", 388},  {"cayley", 486},
    {"simbody_xyz", 397},     {"drake_rpy", 399},  {"chrono_body", 396}, {"exudyn_intrinsic", 402},
    {"mbdyn_joint_inv", 400}, {"rod4", 393},       {"rod34", 389}};
constexpr int kFewest = 372;  ///< of a formulation that is not in the table
constexpr int kEdge = 12;     ///< scenes at a limit point: rounding says whether they arrive

/// A quick run draws the first of the same scenes.
Finding converged_share(const Entry& entry, const Tally& tally, const std::string& ends) {
  const auto* kept = kept_of(kConverged, entry);
  const double share = double((kept == nullptr ? kFewest : kept->converged) - kEdge) / kAllScenes;
  Draft f = of_scenes(entry, "converged")
                .measured(double(tally.ends[0]) / kScenes, ends)
                .in("share of the scenes")
                .by(Oracle::kept);
  if (!is_quick())
    return f.at_least(share, "as many as ever, but for 2 % of the scenes that stand at a limit point");
  return f.at_least(share - 4 * std::sqrt(share * (1 - share) / kScenes),
                    "the share of all scenes, less four standard deviations of so few");
}

std::vector<Finding> solved(const Entry& entry) {
  const Tally tally = solve_all(entry);
  const std::string ends = fmt::format(
      "of {}: {} converged, {} accurate to less than that, {} stopped at a singular tangent, "
      "{} where no load step converges",
      kScenes, tally.ends[0], tally.ends[1], tally.ends[2], tally.ends[3]);
  return {
      of_scenes(entry, "without_an_end")
          .measured(tally.broken + tally.unnamed, ends)
          .in("scenes")
          .at_most(0, "every scene ends with finite numbers and one of four named ends")
          .by(Oracle::closed_form),
      converged_share(entry, tally, ends),
      of_scenes(entry, "estimate")
          .measured(tally.estimate)
          .in("of the estimated error")
          .at_most(
              2, "eight roundings of each load through J^-1; a compliance is inverted with errors of its own")
          .by(Oracle::fifty_digits),
      of_scenes(entry, "distance_to_equilibrium")
          .measured(tally.from_truth)
          .in("rad, or of 1 m + |x|")
          .at_most(
              1e-5,
              "100 eps of the loads over a stiffness ratio of 1e8, and the condition of a softened or turned "
              "tangent")
          .by(Oracle::fifty_digits)};
}

/// "": read; else what is wrong with the refusal, or with what was read.
std::string fault(const std::filesystem::path& file) {
  try {
    const reference::Scene scene = reference::read_scene(file);
    const bool sound = !scene.loads.empty() && scene.factor_end > 0 && std::isfinite(scene.factor_end) &&
                       std::ranges::all_of(scene.loads, [](const auto& l) { return l.value.allFinite(); });
    return sound ? "" : "read, but it holds no finite load";
  } catch (const SceneError& error) {
    const std::string message = tapped(std::string(error.what())), head = file.string() + ":";
    const bool has_line =
        message.starts_with(head) && std::isdigit(static_cast<unsigned char>(message[head.size()]));
    return has_line && message.find("; allowed: ") != std::string::npos
               ? ""
               : "refused without its line: " + message;
  } catch (const std::exception& error) {
    return std::string("another exception: ") + error.what();
  }
}

std::vector<Finding> read_all() {
  const auto folder = std::filesystem::temp_directory_path() / fmt::format("halfway_random_{}", getpid());
  std::filesystem::create_directories(folder);
  reference::Generator generator(20261);
  int wrong = 0;
  std::string last;
  for (int i = 0; i < kTexts; ++i) {
    const auto file = folder / "scene.toml";
    std::ofstream(file, std::ios::binary) << random_scene_text(generator);
    const std::string what = fault(file);
    if (what.empty()) continue;
    ++wrong;
    last = fmt::format("file {}: {}", i, what);
  }
  std::filesystem::remove_all(folder);
  return {finding("scenes/random_mistakes")
              .about("scenes")
              .measured(wrong, last)
              .in("files")
              .at_most(0, "each is read, or refused with file, line and what is allowed")
              .by(Oracle::closed_form)};
}

}  // namespace

void random_scenes(Checks& checks) {
  for (const Entry& entry : reference::formulations()) {
    checks.push_back(
        {fmt::format("{}/random_scenes", entry.name), "stability", [&entry] { return solved(entry); }});
  }
  checks.push_back({"scenes/random_mistakes", "stability", read_all});
}

}  // namespace halfway::verify
