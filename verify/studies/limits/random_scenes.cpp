// Ten thousand random scenes: each ends in equilibrium or with a named reason. And five hundred random
// scene files: each is read, or refused with its line.
#include "reference/solve/solve.hpp"
#include "verify/oracle/property.hpp"
#include "verify/studies/limits/random_scene.hpp"
#include "verify/studies/limits/random_scene_text.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

namespace halfway::verify {
namespace {

using reference::Entry;
using reference::RandomScene;
using reference::SceneError;

constexpr int kScenes = 600;  // of each formulation: more than 10 000 with the seventeen of the catalog
constexpr int kNamed = 25;    // every so many also as a curve, for its sentence
constexpr int kTrue = 5;      // every so many also at 50 digits
constexpr int kTexts = 500;

struct Tally {
  int ends[3] = {};         ///< by Status
  int broken = 0;           ///< not finite, or a status that is none
  int unnamed = 0;          ///< curves that say nothing
  Measurement in_rounding;  ///< of converged states
  Measurement iterations;
  Measurement from_truth;  ///< of some of the converged states
};

void solve_one(const Entry& entry, const RandomScene& random, int index, Tally& tally) {
  reference::Path<double> path(random.scene, entry, random.xi, random.setting);
  const Outcome<double>& state = path.advance(1);
  const auto end = std::size_t(state.status);
  const std::string where = fmt::format("scene {}, {}", index, to_string(random.scene.joint.kind));
  const reference::Soundness sound = soundness(random, entry, state);
  if (end > 2 || !sound.is_finite) ++tally.broken;
  if (end <= 2) ++tally.ends[end];
  if (state.status == Status::converged) tally.in_rounding.include(sound.in_rounding, where);
  if (state.status == Status::converged && index % kTrue == 0)
    tally.from_truth.include(distance_to_equilibrium(random, entry, state), where);
  tally.iterations.include(state.iterations, where);
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
  return curve.converged ? curve.outcome == "converged"
                         : curve.outcome.starts_with("stopped at load factor ");
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

Finding finding(const Entry& entry, const std::string& what) {
  Finding f;
  f.name = fmt::format("{}/random_scenes/{}", entry.name, what);
  f.formulation = entry.name;
  f.subject = "random_scenes";
  return f;
}

std::vector<Finding> solved(const Entry& entry) {
  const Tally tally = solve_all(entry);
  Finding ends = finding(entry, "without_an_end");
  ends.value = tally.broken + tally.unnamed;
  ends.unit = "scenes";
  ends.parameter =
      fmt::format("of {}: {} converged, {} stopped at a singular tangent, {} where no load step converges",
                  kScenes, tally.ends[0], tally.ends[1], tally.ends[2]);
  ends.reason = "every scene ends with finite numbers and one of three named ends";
  return {
      judged(ends),
      held(
          finding(entry, "imbalance"), tally.in_rounding, 100,
          "what the solver itself takes for rounding, here by the formulation's own loads: 78 at worst, what "
          "stops too early 1000 and more; distance_to_equilibrium is the independent road",
          "eps of the loads and of the tangent times the pose"),
      held(finding(entry, "iterations"), tally.iterations, 40000,
           "an advance ends after 20 000 iterations at its next rejected step, at most 1e4 iterations later",
           "Newton iterations"),
      held(finding(entry, "distance_to_equilibrium"), tally.from_truth, 1e-5,
           "100 eps of the loads over a stiffness ratio of 1e8, and the condition of a softened or turned "
           "tangent",
           "rad, or of 1 m + |x|")};
}

/// "": read; else what is wrong with the refusal, or with what was read.
std::string fault(const std::filesystem::path& file) {
  try {
    const reference::Scene scene = reference::read_scene(file);
    const bool sound = !scene.loads.empty() && scene.factor_end > 0 && std::isfinite(scene.factor_end) &&
                       std::ranges::all_of(scene.loads, [](const auto& l) { return l.value.allFinite(); });
    return sound ? "" : "read, but it holds no finite load";
  } catch (const SceneError& error) {
    const std::string message = error.what(), head = file.string() + ":";
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
  Finding f;
  f.name = "scenes/random_mistakes";
  f.subject = "scenes";
  f.unit = "files";
  f.reason = "each is read, or refused with file, line and what is allowed";
  for (int i = 0; i < kTexts; ++i) {
    const auto file = folder / "scene.toml";
    std::ofstream(file, std::ios::binary) << random_scene_text(generator);
    const std::string what = fault(file);
    if (what.empty()) continue;
    f.value += 1;
    f.parameter = fmt::format("file {}: {}", i, what);
  }
  std::filesystem::remove_all(folder);
  return {judged(f)};
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
