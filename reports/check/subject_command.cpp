// halfway-check subject: a program that answers with a joint of ours, and with the mistakes of others.
#include "reference/programs/convention.hpp"
#include "reference/programs/joints.hpp"
#include "reference/programs/path_joints.hpp"
#include "reports/check/commands.hpp"
#include "reports/check/judge/program.hpp"
#include "reports/check/known_joint.hpp"
#include "reports/cli/errors.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <thread>

namespace halfway::check {
namespace {

using nlohmann::json;
using reference::Convention;

struct SubjectOptions {
  std::string joint, mistake;
  double xi = 0.5;
};

/// The mistakes that are a convention.
std::optional<Convention> convention_of(const std::string& mistake) {
  using reference::Hearing, reference::Point;
  constexpr double kDegrees = 57.29577951308232;
  const std::map<std::string, Convention> all{{"", {}},
                                              {"transposed", {.hearing = Hearing::transposed}},
                                              {"scalar_last", {.hearing = Hearing::scalar_last}},
                                              {"rotation_first", {.hearing = Hearing::rotation_first}},
                                              {"swapped", {.hearing = Hearing::bodies_exchanged}},
                                              {"wrong_point", {.point = Point::origin}},
                                              {"joint_points", {.point = Point::joint_points}},
                                              {"degrees", {.moment_scale = kDegrees}},
                                              {"on_bodies", {.force_scale = -1, .moment_scale = -1}}};
  const auto found = all.find(mistake);
  if (found == all.end()) return std::nullopt;
  return found->second;
}

/// Right where the angle is small: another law beyond 0.4 rad.
Answerer lying(const Answerer& honest) {
  const Answerer other = reference::answerer(*reference::find_formulation("attached_a"), 0.5);
  return [honest, other](const Ask& ask) {
    const auto turn = reference::times(reference::conjugate(reference::times(ask.a.q, ask.a.h)),
                                       reference::times(ask.b.q, ask.b.h));
    return std::abs(turn[0]) > std::cos(0.2) ? honest(ask) : other(ask);
  };
}

/// The springs as somebody reads them who did not think of all.
Answerer with_springs(const Answerer& honest, void (*misread)(Ask&)) {
  return [honest, misread](Ask ask) {
    misread(ask);
    return honest(ask);
  };
}

Mat3<double> diagonal_of(const Mat3<double>& K) { return K.diagonal().asDiagonal(); }

/// None that is on is softer than a thousand millionth of the stiffest.
void floor_springs(Ask& ask) {
  const double least = 1e-9 * ask.K_m.maxCoeff();
  for (double& k : ask.K_m.reshaped())
    if (k > 0 && k < least) k = least;
}

/// None is stiffer than a million times the softest that is on.
void cap_springs(Ask& ask) {
  double softest = ask.K_m.maxCoeff();
  for (const double k : ask.K_m.diagonal())
    if (k > 0 && k < softest) softest = k;
  ask.K_m = ask.K_m.cwiseMin(1e6 * softest).eval();
}

/// Of the springs and of the ends; nullptr for another mistake.
void (*misreading_of(const std::string& mistake))(Ask&) {
  if (mistake == "diagonal") return [](Ask& a) { a.K_f = diagonal_of(a.K_f), a.K_m = diagonal_of(a.K_m); };
  if (mistake == "uncoupled") return [](Ask& a) { a.K_fm.setZero(); };
  if (mistake == "capped") return cap_springs;
  if (mistake == "floored") return floor_springs;
  if (mistake == "frame_of_a") return [](Ask& a) { a.b.h = a.a.h; };
  return nullptr;
}

void answer(const Answerer& joint, const json& line) {
  const TwelveLoads q = joint(reference::read_request(line));
  const json out{{"id", line.at("id")}, {"loads", std::vector<double>(q.data(), q.data() + 12)}};
  std::puts(out.dump().c_str());
  std::fflush(stdout);
}

void run(const SubjectOptions& o) {
  Answerer joint = known_joint(o.joint, o.xi);
  if (o.mistake == "lying")
    joint = lying(joint);
  else if (const auto misread = misreading_of(o.mistake))
    joint = with_springs(joint, misread);
  else if (const auto convention = convention_of(o.mistake))
    joint = reference::spoken(joint, *convention);
  else if (o.mistake != "hanging" && o.mistake != "crashing")
    throw reports::BadInput(fmt::format("no mistake is called '{}'", o.mistake));
  int count = 0;
  for (std::string text; std::getline(std::cin, text);) {
    const json line = json::parse(text, nullptr, false);
    if (!line.is_object()) continue;
    if (line.contains("hello")) {
      std::puts(json{{"id", line["id"]},
                     {"name", o.joint + (o.mistake.empty() ? "" : ", " + o.mistake)},
                     {"path", reference::find_path_joint(o.joint) != nullptr}}
                    .dump()
                    .c_str());
      std::fflush(stdout);
      continue;
    }
    ++count;
    if (o.mistake == "hanging" && count % 40 == 20) std::this_thread::sleep_for(std::chrono::hours(1));
    if (o.mistake == "crashing" && count % 40 == 20) std::abort();
    answer(joint, line);
  }
}

}  // namespace

void add_subject(CLI::App& app) {
  const auto o = std::make_shared<SubjectOptions>();
  CLI::App* command =
      app.add_subcommand("subject", "Answer questions of a check with a joint of ours, or with a mistake");
  command->add_option("JOINT", o->joint, "Its name")->required();
  command->add_option(
      "--mistake", o->mistake,
      "transposed, scalar_last, rotation_first, swapped, wrong_point, joint_points, degrees, "
      "on_bodies, diagonal, uncoupled, capped, floored, frame_of_a, lying, hanging, crashing");
  command->add_option("--xi", o->xi, "Of a joint that has one");
  command->callback([o] { run(*o); });
}

}  // namespace halfway::check
