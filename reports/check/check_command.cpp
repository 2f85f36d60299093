// halfway check: what joint is that program's?
#include "reports/check/commands.hpp"
#include "reports/check/judge/run_check.hpp"
#include "reports/check/known_joint.hpp"
#include "reports/check/self_test.hpp"
#include "reports/cli/errors.hpp"
#include "reports/cli/progress.hpp"
#include "reports/cli/streams.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

namespace halfway::check {
namespace {

struct CheckOptions {
  std::string command, answers, fields, expected, out, junit, markdown, badge, questions, joint;
  double seconds = 10;
  bool bond = false, ctest = false, self_test = false;
};

void write(const CheckOptions& o, const Verdict& verdict, Program& program) {
  const auto to = [](const std::string& file, const std::string& text) {
    if (!file.empty()) reports::write_file(file, text);
  };
  to(o.junit, as_junit(verdict));
  to(o.markdown, as_markdown(verdict));
  to(o.badge, as_badge(verdict));
  if (o.ctest) reports::print(as_ctest(verdict));
  if (o.out.empty()) return;
  for (const std::string& file : write_failures(verdict, o.out, program))
    reports::tell(fmt::format("wrote {}\n", file));
}

void run(const CheckOptions& o) {
  if (o.self_test) return self_test();
  if (!o.questions.empty()) {
    const Answerer joint = o.joint.empty() ? Answerer() : known_joint(o.joint, 0.5);
    const bool is_table = o.questions.ends_with(".csv");
    reports::write_file(o.questions, is_table ? questions_as_table({}, o.bond, joint)
                                              : questions_as_lines({}, o.bond, joint));
    reports::print(fmt::format("wrote {}\n", o.questions));
    return;
  }
  if (o.command.empty() == o.answers.empty())
    throw reports::BadInput("one of --command \"PROGRAM ARGUMENTS\" and --answers FILE is needed");
  if (!o.out.empty()) reports::try_folder(o.out);
  const auto program =
      o.command.empty() ? answered_program(o.answers) : running_program(o.command, o.seconds, o.fields);
  reports::Progress progress("questions");
  Verdict verdict = run_check(*program, o.bond, std::ref(progress));
  if (!o.expected.empty()) expect(verdict, o.expected);
  reports::print(as_text(verdict));
  write(o, verdict, *program);
  if (verdict.fails()) throw reports::FailedRun("the joint has failures that nobody expected");
}

}  // namespace

void add_check(CLI::App& app) {
  const auto o = std::make_shared<CheckOptions>();
  CLI::App* command =
      app.add_subcommand("check", "Tell a program what its joint is, and what it does not do");
  command->add_option("--command", o->command,
                      "The program and its arguments; JSON lines in, JSON lines out");
  command->add_option("--answers", o->answers, "Or its answers to the questions of --questions, JSON lines");
  command->add_option("--questions", o->questions,
                      "Write the questions to a file, and ask nobody: JSON lines, or FILE.csv");
  command->add_option("--joint", o->joint, "With --questions: the loads of this joint beside them");
  command->add_option("--fields", o->fields, "JSON object that is added to every question");
  command->add_option("--timeout", o->seconds, "Seconds for an answer")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command->add_flag("--bond", o->bond, "Its points rest a metre apart along z");
  command->add_option("--expected", o->expected,
                      "File of failures that are known: an id or level3/* a line, # a comment");
  command->add_option("--out", o->out, "Folder of the failures: the smallest question that has each");
  command->add_option("--junit", o->junit, "JUnit file");
  command->add_option("--markdown", o->markdown, "Markdown file");
  command->add_option("--badge", o->badge, "Badge, JSON of shields.io's endpoint");
  command->add_flag("--ctest", o->ctest, "Print measurements that ctest reads");
  command->add_flag("--self-test", o->self_test, "Check programs whose mistakes are known");
  command->callback([o] { run(*o); });
}

}  // namespace halfway::check
