#include "verify/oracle/saboteurs/trial.hpp"

#include "verify/forked.hpp"

#include <nlohmann/json.hpp>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <exception>

namespace halfway::verify {
namespace {

bool can_fail(const Finding& f) {
  return f.verdict != Verdict::left_out && f.comparison != Comparison::report;
}

Trial run_here(const Check& check, const Parts& seen) {
  Trial out{.outcome = Outcome::passed};
  tap_state().passed = 0;  // what the parent has run before is not this check's
  try {
    const auto findings = check.run();
    const auto failed = std::ranges::find(findings, Verdict::fail, &Finding::verdict);
    out.judges = std::ranges::any_of(findings, can_fail);
    out.left_out =
        std::ranges::all_of(findings, [](const Finding& f) { return f.verdict == Verdict::left_out; });
    if (findings.empty()) {
      out = {.outcome = Outcome::failed, .by = "no finding"};
    } else if (failed != findings.end()) {
      out.outcome = Outcome::failed;
      out.by = failed->name;
    }
  } catch (const std::exception& e) {
    out = {.outcome = Outcome::threw, .by = e.what()};
  } catch (...) {
    out = {.outcome = Outcome::threw, .by = "what is no std::exception"};
  }
  out.seen = seen;
  out.seen.taps = tap_state().passed > 0;
  return out;
}

/// One line of JSON; its end says that nothing was cut off.
std::string text_of(const Trial& t) {
  const nlohmann::json json = {int(t.outcome), t.by,           t.judges,      t.left_out,    t.seen.moments,
                               t.seen.forces,  t.seen.tangent, t.seen.strain, t.seen.energy, t.seen.taps};
  return json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace) + "\n";
}

Trial trial_of(const std::string& text) {
  const auto json = nlohmann::json::parse(text);
  const auto is = [&](std::size_t i) { return json[i].get<bool>(); };
  return {Outcome(json[0].get<int>()),
          json[1].get<std::string>(),
          is(2),
          is(3),
          {is(4), is(5), is(6), is(7), is(8), is(9)}};
}

void try_within(const Check& check, int limit, const Parts& seen, int output) {
  const rlimit seconds{rlim_t(limit), rlim_t(limit)}, no_core{0, 0};
  setrlimit(RLIMIT_CPU, &seconds);
  setrlimit(RLIMIT_CORE, &no_core);
  // A test framework's handlers would go on with the parent's tests in here.
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM}) std::signal(signal, SIG_DFL);
  alarm(unsigned(20 * limit));  // of one that waits for ever; other programs may take most of the processor
  write_all(output, text_of(run_here(check, seen)));
}

std::string all_of(int input) {
  std::string out;
  char part[4096];
  for (;;) {
    const ssize_t n = read(input, part, sizeof part);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return out;
    out.append(part, std::size_t(n));
  }
}

}  // namespace

const char* to_string(Outcome outcome) {
  constexpr const char* names[] = {"passed", "failed", "threw", "crashed", "hung"};
  return names[int(outcome)];
}

Trial run_apart(const Check& check, int limit, const Parts& seen) {
  Forked child([&](int output) { try_within(check, limit, seen, output); });
  const std::string text = all_of(child.input());
  const int status = child.status();
  if (text.ends_with('\n')) return trial_of(text);
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  const bool hung = signal == SIGXCPU || signal == SIGKILL || signal == SIGALRM;
  return {.outcome = hung ? Outcome::hung : Outcome::crashed, .by = "signal " + std::to_string(signal)};
}

}  // namespace halfway::verify
