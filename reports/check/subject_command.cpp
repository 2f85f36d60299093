// halfway-check subject: a program that answers with a joint of ours, and with the mistakes of others.
#include "reference/programs/convention.hpp"
#include "reference/programs/joints.hpp"
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
  else if (const auto convention = convention_of(o.mistake))
    joint = reference::spoken(joint, *convention);
  else if (o.mistake != "hanging" && o.mistake != "crashing")
    throw reports::BadInput(fmt::format("no mistake is called '{}'", o.mistake));
  int count = 0;
  for (std::string text; std::getline(std::cin, text);) {
    const json line = json::parse(text, nullptr, false);
    if (!line.is_object()) continue;
    if (line.contains("hello")) {
      std::puts(json{{"id", line["id"]}, {"name", o.joint + (o.mistake.empty() ? "" : ", " + o.mistake)}}
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
  command->add_option("--mistake", o->mistake,
                      "transposed, scalar_last, rotation_first, swapped, wrong_point, joint_points, degrees, "
                      "on_bodies, lying, "
                      "hanging, crashing");
  command->add_option("--xi", o->xi, "Of a joint that has one");
  command->callback([o] { run(*o); });
}

}  // namespace halfway::check
