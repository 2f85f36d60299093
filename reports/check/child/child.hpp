// The program under check: asked by lines on its standard input, answering by lines on its standard output,
// and whatever it does instead said of the request that it did it to.
#pragma once

#include "reports/check/child/child_answer.hpp"
#include "reports/check/child/child_log.hpp"
#include "reports/check/child/child_process.hpp"
#include "reports/check/child/child_round.hpp"

#include <chrono>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace halfway::check {

/// Lines of standard output that answer nothing.
struct Chatter {
  long count = 0;
  std::vector<std::string> first{};  ///< five of them, as a message can show them
};

/// How patient, besides the time for each answer.
struct Manners {
  std::chrono::duration<double> start_up{10};  ///< more time for the first answer after each start
  std::size_t most_under_way = 16;             ///< requests sent before their answers have come
  std::filesystem::path log{};                 ///< keeps the standard error; else it is a temporary file
};

class Child {
 public:
  /// Starts it; from here on SIGINT and SIGTERM are caught (reports::catch_interrupts()), and ask() throws
  /// for them. Throws reports::BadInput when it cannot be started.
  explicit Child(std::vector<std::string> words, Manners manners = {});
  /// Ends it: its input is closed, then it has half a second to go by itself.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Writes the requests and reads the answers, in any order, as the program takes and gives them.
  ///
  /// Several are under way at once. Where the program ends or is silent too long, those are asked again one
  /// at a time, and from then on all others are: so it is known which request it was. That one is missing,
  /// the program is started again for the next; after three in a row it is given up. A program that is silent
  /// with everything read sees the end of its input: some answer only then.
  ///
  /// @param requests    JSON objects, a line each without its end, ids that differ: strings or numbers
  /// @param per_answer  since the last one
  /// @return  in the requests' order
  /// Throws reports::FailedRun when this process was interrupted; the program is ended then.
  std::vector<Outcome> ask(const std::vector<std::string>& requests,
                           std::chrono::duration<double> per_answer);

  const Chatter& chatter() const { return chatter_; }
  /// What a report should say of the program beside the outcomes.
  const std::vector<std::string>& remarks() const { return remarks_; }
  /// The process group of each start so far.
  const std::vector<pid_t>& groups() const { return groups_; }

 private:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;

  /// How a program ended.
  struct End {
    bool by_itself = false;    ///< else it closed its standard output and was ended
    bool failed = false;       ///< with another exit code than 0
    bool left_unread = false;  ///< the request that was sent last
    bool saw_end_of_input = false;
    std::string how{};          ///< after "it"
    std::string broken_line{};  ///< the answer it ended in
  };

  void start();
  void stop(std::chrono::milliseconds leave = {});
  void talk(Round& round, Seconds per_answer);
  void send(Round& round);
  void receive(Round& round);
  void take(Round& round, const Line& line);
  void settle(Round& round, const std::string& id, const Outcome& outcome);
  void judge_silence(Round& round, Seconds per_answer);
  Outcome unclear_outcome(const Round& round);
  bool judge_unclear(Round& round, Seconds per_answer);
  End see_end(Round& round);
  void judge_end(Round& round);
  void lose(Round& round, Lost lost, const std::string& words);
  bool one_at_a_time_again(Round& round, const std::string& words);
  void keep_chatter(const std::string& text);
  void remark(std::string text);

  std::vector<std::string> words_;
  Manners manners_;
  Log log_;

  // Of the program that runs.
  std::unique_ptr<Process> process_;
  Lines lines_;
  std::string unsent_;
  Clock::time_point last_answer_;  ///< or its start, or when it was asked after a rest
  long answers_ = 0;
  bool has_output_ = true;      ///< its standard output is open
  bool input_is_over_ = false;  ///< it shall see its end
  // Lines that look like answers, to none of the requests.
  std::size_t unclear_ = 0;
  Outcome last_unclear_;
  Clock::time_point last_unclear_time_;

  // Of every program so far.
  bool one_at_a_time_ = false;
  bool waits_for_end_of_input_ = false;  ///< it answers only then
  int lost_in_a_row_ = 0;
  std::string last_loss_;
  std::set<std::string> asked_;  ///< ids
  std::string last_chatter_;
  Chatter chatter_;
  std::vector<std::string> remarks_;
  std::vector<pid_t> groups_;
};

}  // namespace halfway::check
