#include "reports/check/judge/run_check.hpp"

#include "reference/programs/path_joints.hpp"
#include "reports/check/judge/springs.hpp"
#include "reports/check/judge/tangent.hpp"
#include "reports/check/judge/wrong_twins.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace halfway::check {
namespace {

using reference::Answered;
using reference::Candidate;

class Checking {
 public:
  Checking(Program& program, bool as_bond, const Told& told)
      : program_(program), as_bond_(as_bond), told_(told) {}

  Verdict run() {
    verdict_.hello = program_.hello();
    identify();
    examine_all();
    verdict_.results.push_back(check_tangent(program_, verdict_.hello, verdict_.identity.convention));
    verdict_.remarks = program_.remarks();
    return verdict_;
  }

 private:
  /// Asks what is on the list and has not been asked.
  void ask_rest(const std::string& what) {
    constexpr std::size_t kAtOnce = 64;
    while (asked_ < questions_.size()) {
      told_(int(asked_), int(questions_.size()), what);
      const std::size_t end = std::min(asked_ + kAtOnce, questions_.size());
      const std::vector<std::string> ids(questions_.ids().begin() + long(asked_),
                                         questions_.ids().begin() + long(end));
      const std::vector<Ask> asks(questions_.asks().begin() + long(asked_),
                                  questions_.asks().begin() + long(end));
      const auto said = program_.ask(ids, asks);
      for (std::size_t i = 0; i < said.size(); ++i) keep(asked_ + i, said[i]);
      asked_ = end;
    }
  }

  void keep(std::size_t i, const Said& said) {
    ++verdict_.asked;
    if (said.loads) {
      questions_.answer(i, *said.loads);
      ++verdict_.answered;
    } else if (said.skipped) {
      ++verdict_.skipped;
    } else {
      verdict_.lost.push_back(questions_.ids()[i] + ": " + said.why);
    }
  }

  std::vector<Answered> answered(const std::vector<Ask>& asks, const Answerer& read) const {
    std::vector<Answered> out;
    for (const Ask& ask : asks) {
      const TwelveLoads loads = read(ask);
      if (loads.allFinite()) out.push_back({ask, loads});
    }
    return out;
  }

  void identify() {
    auto asks = identity_asks(verdict_.hello);
    if (verdict_.hello.path)
      for (Ask& ask : asks) ask = reference::with_road(ask);
    const Answerer write = questions_.writer("level1/identity");
    for (const Ask& ask : asks) write(ask);
    ask_rest("who is it");
    auto candidates = known_joints();
    for (auto& twin : wrong_twins()) candidates.push_back(std::move(twin));
    if (verdict_.hello.springs == Hello::Springs::isotropic)  // who takes one stiffness, too, is named first
      std::stable_partition(candidates.begin(), candidates.end(),
                            [](const auto& c) { return c.is_isotropic; });
    const double near = tolerance(verdict_.hello);
    verdict_.identity = reference::identify(answered(asks, questions_.reader()), candidates, near);
    verdict_.is_known = verdict_.identity.distance <= near;
    if (verdict_.is_known) law_ = *std::ranges::find(candidates, verdict_.identity.name, &Candidate::name);
    if (verdict_.is_known || verdict_.identity.name.empty()) return;
    const auto more = family_asks(verdict_.hello);
    const Answerer write_more = as_asked(questions_.writer("level1/family"));
    for (const Ask& ask : more) write_more(ask);
    ask_rest("which family");
    verdict_.family = reference::fit_family(answered(more, as_asked(questions_.reader())));
  }

  void examine_all() {
    examined(as_asked(questions_.writer("level2")));
    ask_rest("what it does");
    verdict_.results = examined(as_asked(questions_.reader()));
  }

  std::vector<Result> examined(const Answerer& joint) const {
    auto out = examine(joint, verdict_.hello, as_bond_);
    if (as_bond_) return out;
    for (auto& r : examine_springs(joint, verdict_.hello, law_)) out.push_back(std::move(r));
    return out;
  }

  /// In our convention, along a road where the joint has a memory.
  Answerer as_asked(const Answerer& program) const {
    return along_road(verdict_.hello, reference::translated(program, verdict_.identity.convention));
  }

  /// Those with a memory first: along a straight road some of them are joints without one.
  std::vector<Candidate> known_joints() const {
    std::vector<Candidate> out;
    if (verdict_.hello.path)
      for (const auto& joint : reference::path_joints())
        out.push_back({std::string(joint.name), joint.answer});
    for (auto& known : reference::known_joints()) out.push_back(std::move(known));
    return out;
  }

  Program& program_;
  bool as_bond_;
  const Told& told_;
  Questions questions_;
  std::optional<Candidate> law_;  ///< what it is, where that is known
  std::size_t asked_ = 0;
  Verdict verdict_;
};

}  // namespace

Verdict run_check(Program& program, bool as_bond, const Told& told) {
  return Checking(program, as_bond, told).run();
}

namespace {

Questions all_questions(const Hello& hello, bool as_bond) {
  Questions questions;
  const auto write_all = [&](const char* group, const std::vector<Ask>& asks) {
    const Answerer write = questions.writer(group);
    for (const Ask& ask : asks) write(ask);
  };
  write_all("level1/identity", identity_asks(hello));
  write_all("level1/family", family_asks(hello));
  examine(questions.writer("level2"), hello, as_bond);
  return questions;
}

}  // namespace

std::string questions_as_lines(const Hello& hello, bool as_bond, const Answerer& joint) {
  const Questions questions = all_questions(hello, as_bond);
  std::string out;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    std::string line = request_line(questions.ids()[i], questions.asks()[i], !hello.linear_angular, "");
    if (joint) {
      line.back() = ',';
      line += fmt::format("\"loads\":[{}]}}", fmt::join(joint(questions.asks()[i]), ","));
    }
    out += line + "\n";
  }
  return out;
}

std::string questions_as_table(const Hello& hello, bool as_bond, const Answerer& joint) {
  const Questions questions = all_questions(hello, as_bond);
  std::string out = "id";
  for (const char* node : {"a", "b"}) {
    for (const char* what : {"x", "q", "o", "h"}) {
      const int count = *what == 'q' || *what == 'h' ? 4 : 3;
      for (int i = 0; i < count; ++i) out += fmt::format(",{}_{}{}", what, node, i);
    }
  }
  for (const char* what : {"Kf", "Km"})
    for (int i = 0; i < 9; ++i) out += fmt::format(",{}{}{}", what, i / 3, i % 3);
  if (joint) {
    for (const char* what : {"fa", "ma", "fb", "mb"})
      for (int i = 0; i < 3; ++i) out += fmt::format(",{}{}", what, i);
  }
  const auto add = [&](const auto& values) {
    for (const double x : values.reshaped()) out += fmt::format(",{}", x);
  };
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const Ask& ask = questions.asks()[i];
    out += "\n" + questions.ids()[i];
    for (const reference::AskedBody* body : {&ask.a, &ask.b})
      add(body->x), add(body->q), add(body->o), add(body->h);
    add(Mat3<double>(ask.K_f.transpose())), add(Mat3<double>(ask.K_m.transpose()));
    if (joint) add(joint(ask));
  }
  return out + "\n";
}

}  // namespace halfway::check
