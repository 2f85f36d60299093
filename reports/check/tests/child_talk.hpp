// A talk with a program that misbehaves, for the tests: what is said of each request, and that none of its
// processes is left.
#pragma once

#include "reports/check/child/child.hpp"
#include "reports/check/child/words.hpp"
#include "reports/cli/errors.hpp"
#include "reports/cli/interrupts.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <csignal>
#include <fstream>

BOOST_TEST_DONT_PRINT_LOG_VALUE(halfway::check::Outcome::Sort)
BOOST_TEST_DONT_PRINT_LOG_VALUE(halfway::check::Lost)

namespace halfway::check::test {

using Sort = Outcome::Sort;
using std::chrono::duration;

inline constexpr duration<double> kShort{0.4};  // where it is waited for in vain
inline constexpr duration<double> kLong{20};    // else: a busy machine must not matter

inline std::string quoted_id(int number) { return fmt::format("\"p{:02}\"", number); }

inline std::vector<std::string> requests(int count, std::size_t padding = 0) {
  std::vector<std::string> lines;
  for (int i = 1; i <= count; ++i)
    lines.push_back(fmt::format("{{\"id\":{},\"x\":\"{}\"}}", quoted_id(i), std::string(padding, 'r')));
  return lines;
}

inline std::vector<std::string> misbehaving(const std::string& mode, const std::string& id = "") {
  std::vector<std::string> words = {HALFWAY_MISBEHAVING, mode};
  if (!id.empty()) words.push_back(id);
  return words;
}

inline bool is_left(pid_t group) { return kill(-group, 0) == 0 || errno != ESRCH; }

/// All that is known of a program when it is gone.
struct Talk {
  std::vector<Outcome> outcomes;
  Chatter chatter;
  std::vector<std::string> remarks;
  int starts = 0;

  /// "answered" or why not, of each request; neighbours that are alike counted: "2 answered, timed out".
  std::string summary() const {
    std::string text;
    for (std::size_t i = 0, n; i < outcomes.size(); i += n) {
      const auto name = [&](std::size_t k) {
        return std::string(outcomes[k].sort == Sort::missing ? to_string(outcomes[k].lost)
                                                             : to_string(outcomes[k].sort));
      };
      for (n = 1; i + n < outcomes.size() && name(i + n) == name(i);) ++n;
      text += (i > 0 ? ", " : "") + (n > 1 ? fmt::format("{} ", n) : "") + name(i);
    }
    return text;
  }
  const std::string& words(std::size_t number) const { return outcomes.at(number - 1).words; }
  bool each_has_its_own() const {
    for (std::size_t i = 0; i < outcomes.size(); ++i)
      if (outcomes[i].sort == Sort::answered && id_key(outcomes[i].line["id"]) != quoted_id(int(i) + 1))
        return false;
    return true;
  }
};

inline Talk talk(const std::vector<std::string>& words, const std::vector<std::string>& lines,
                 Manners manners = {}, duration<double> patience = kLong) {
  Talk talk;
  std::vector<pid_t> groups;
  {
    manners.start_up = duration<double>(0);
    Child child(words, manners);
    talk.outcomes = child.ask(lines, patience);
    talk.chatter = child.chatter();
    talk.remarks = child.remarks();
    groups = child.groups();
  }
  talk.starts = int(groups.size());
  for (const pid_t group : groups) BOOST_TEST(!is_left(group));
  BOOST_TEST(talk.outcomes.size() == lines.size());
  BOOST_TEST(talk.each_has_its_own());
  return talk;
}

/// Five requests; with an id the program misbehaves at that one alone.
inline Talk five(const std::string& mode, const std::string& id = "", duration<double> patience = kLong) {
  return talk(misbehaving(mode, id), requests(5), {}, patience);
}

double seconds_of(const auto& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace halfway::check::test
