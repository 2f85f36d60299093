#include "reports/check/child/child.hpp"

#include "reports/cli/errors.hpp"
#include "reports/cli/interrupts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace halfway::check {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kLook{20};      // between looks at whether it still runs, and at interrupts
constexpr milliseconds kLeave{500};    // in which a program goes by itself, its input being closed
constexpr milliseconds kUnclear{100};  // after which the answer itself is not expected any more
constexpr int kMostLostInARow = 3;
constexpr std::size_t kMostChatter = 5, kMostRemarks = 20;
constexpr std::size_t kMostUnsent = 1 << 16;  // bytes
constexpr double kSilent = 0.25;              // of the patience: perhaps it waits for the end of its input

}  // namespace

Child::Child(std::vector<std::string> words, Manners manners)
    : words_(std::move(words)), manners_(std::move(manners)), log_(manners_.log) {
  reports::catch_interrupts();
  start();
}

Child::~Child() { stop(kLeave); }

std::vector<Outcome> Child::ask(const std::vector<std::string>& requests, Seconds per_answer) {
  const QuietPipes quiet;
  Round round(requests);
  while (!round.is_done()) {
    if (lost_in_a_row_ >= kMostLostInARow) {
      round.give_up(fmt::format("not asked: {} requests in a row had no answer, the last one: {}",
                                kMostLostInARow, last_loss_));
      break;
    }
    if (process_ && answers_ > 0 && process_->has_ended()) judge_end(round);  // since it was asked last
    if (!process_) start();
    talk(round, per_answer);
  }
  if (process_ && !process_->takes_input()) stop(kLeave);
  asked_.insert(round.ids().begin(), round.ids().end());
  return round.outcomes();
}

void Child::start() {
  log_.mark();
  process_ = std::make_unique<Process>(words_, log_.descriptor());
  groups_.push_back(process_->group());
  lines_ = {};
  unsent_.clear();
  answers_ = 0;
  unclear_ = 0;
  has_output_ = true;
  input_is_over_ = waits_for_end_of_input_;
  last_answer_ = Clock::now();
}

void Child::stop(milliseconds leave) {
  if (process_) process_->end(leave);
  process_.reset();
}

/// With one program, until all is answered or it is gone.
void Child::talk(Round& round, Seconds per_answer) {
  last_answer_ = Clock::now();
  while (process_ && !round.is_done()) {
    if (reports::interrupted()) {
      stop();
      throw reports::FailedRun("interrupted");
    }
    send(round);
    process_->wait(!unsent_.empty(), kLook);
    receive(round);
    log_.bound();
    if (round.is_done()) break;
    if (process_->has_ended() || !has_output_)
      judge_end(round);
    else if (!process_->takes_input() && round.under_way() == 0)
      stop(kLeave);  // the next one is another program's
    else if (!judge_unclear(round, per_answer))
      judge_silence(round, per_answer);
  }
}

void Child::send(Round& round) {
  const std::size_t most = one_at_a_time_ ? 1 : input_is_over_ ? std::size_t(-1) : manners_.most_under_way;
  while (process_->takes_input() && round.any_waiting() && round.under_way() < most &&
         unsent_.size() < kMostUnsent)
    unsent_ += round.send_next();
  unsent_.erase(0, process_->write(unsent_));
  const bool all_sent = unsent_.empty() && round.under_way() > 0 && (one_at_a_time_ || !round.any_waiting());
  if (input_is_over_ && all_sent) process_->close_input();
}

void Child::receive(Round& round) {
  std::string bytes;
  has_output_ = process_->read(bytes);
  lines_.add(bytes);
  while (const auto line = lines_.next()) take(round, *line);
}

void Child::take(Round& round, const Line& line) {
  Reading reading = read_answer(line);
  if (reading.id && round.knows(*reading.id)) return settle(round, *reading.id, reading.outcome);
  keep_chatter(line.text);
  if (!reading.is_answer || (reading.id && asked_.contains(*reading.id))) return;
  ++unclear_;
  last_unclear_time_ = Clock::now();
  last_unclear_ = std::move(reading.outcome);
  if (last_unclear_.sort == Outcome::Sort::missing) return;
  const std::string has = reading.id ? readable(*reading.id) : "no id";
  const std::string says =
      last_unclear_.words.empty() ? "" : fmt::format(", and says: {}", last_unclear_.words);
  last_unclear_ = {.lost = Lost::wrong_id, .words = fmt::format("the answer has {}{}", has, says)};
}

void Child::settle(Round& round, const std::string& id, const Outcome& outcome) {
  if (!round.settle(id, outcome)) {
    remark("it answers a request more than once; the first answer counts");
    return;
  }
  if (!process_->takes_input() && input_is_over_ && !waits_for_end_of_input_ && answers_ == 0) {
    waits_for_end_of_input_ = true;
    remark("it answers only when its input has ended: it should flush its output after each line");
  }
  ++answers_;
  if (round.under_way() == 0) unclear_ = 0;
  lost_in_a_row_ = 0;
  last_chatter_.clear();
  last_answer_ = Clock::now();
}

/// What the last line that answers nothing says of the first request under way.
Outcome Child::unclear_outcome(const Round& round) {
  unclear_ = 0;
  Outcome outcome = std::exchange(last_unclear_, {});
  if (outcome.lost == Lost::wrong_id)
    outcome.words = fmt::format("wrong id: asked {}, {}", readable(round.first()), outcome.words);
  return outcome;
}

/// Are there as many lines that look like answers, to no request, as there are requests under way?
bool Child::judge_unclear(Round& round, Seconds per_answer) {
  if (round.under_way() == 0 || unclear_ < round.under_way()) return false;
  const Seconds quiet = Clock::now() - std::max(last_unclear_time_, last_answer_);
  // They may be logs between answers.
  if (quiet < (last_answer_ > last_unclear_time_ ? kSilent * per_answer : Seconds(kUnclear))) return false;
  const Outcome outcome = unclear_outcome(round);
  if (one_at_a_time_again(round, outcome.words)) {
    stop();
  } else {
    round.lose_first(outcome.lost, outcome.words);
    last_answer_ = Clock::now();
  }
  return true;
}

void Child::judge_silence(Round& round, Seconds per_answer) {
  if (round.under_way() == 0) return;
  const Seconds patience = per_answer + (answers_ == 0 ? manners_.start_up : Seconds(0));
  const Seconds silent = Clock::now() - last_answer_;
  const bool has_read_all = unsent_.empty() && process_->unread() == 0;
  if (silent > kSilent * patience && has_read_all) input_is_over_ = true;
  if (silent < patience) return;
  stop();
  std::string words = fmt::format("timed out: no answer within {:.3g} s", patience.count());
  if (!has_read_all) words += "; it has not read all that it was sent";
  if (const auto rest = lines_.rest())
    words += fmt::format("; it has begun a line without ending it: {}", readable(rest->text, 80));
  if (!last_chatter_.empty()) words += fmt::format("; the last line that it printed: {}", last_chatter_);
  lose(round, Lost::timed_out, words + log_.last_words());
}

/// Ends what is over, or closed its standard output, and reads what it had written before.
Child::End Child::see_end(Round& round) {
  End end;
  end.by_itself = process_->ends_within(kLeave);
  end.left_unread = process_->unread() + unsent_.size() > 0;
  end.saw_end_of_input = !process_->takes_input() && input_is_over_;
  process_->end();
  receive(round);
  end.failed = !end.by_itself || process_->failed();
  end.how = end.by_itself ? process_->how() : "closed its standard output and went on";
  if (const auto rest = lines_.rest()) {
    const Reading reading = read_answer(*rest);
    if (!reading.is_answer || reading.outcome.sort != Outcome::Sort::missing)
      take(round, *rest);  // chatter, or an answer without a line end
    else
      end.broken_line = rest->text;
  }
  process_.reset();
  return end;
}

void Child::judge_end(Round& round) {
  const End end = see_end(round);
  const std::string last_words = end.failed ? log_.last_words() : "";
  if (round.under_way() == 0) {
    if (end.failed) remark(fmt::format("it {} after an answer{}", end.how, last_words));
  } else if (answers_ > 0 && end.left_unread && round.under_way() == 1) {
    remark(fmt::format("it {} after an answer; it is started again for the next request{}", end.how,
                       last_words));
    round.ask_again();  // it was never read
  } else if (!end.broken_line.empty() && end.by_itself) {
    lose(round, Lost::truncated,
         fmt::format("truncated line: it {} after {}", end.how, readable(end.broken_line, 80)));
  } else if (!end.failed && unclear_ >= round.under_way()) {
    const Outcome outcome = unclear_outcome(round);
    lose(round, outcome.lost, outcome.words);
  } else if (end.saw_end_of_input && !end.failed) {
    lose(round, Lost::timed_out, fmt::format("no answer, and it {} at the end of its input", end.how));
  } else {
    lose(round, end.by_itself ? Lost::crashed : Lost::closed,
         fmt::format("{}it {}{}", end.by_itself ? "crashed: " : "", end.how, log_.last_words()));
  }
}

/// Which of several it was is not known: all of them are asked again.
bool Child::one_at_a_time_again(Round& round, const std::string& words) {
  if (round.under_way() <= 1) return false;
  one_at_a_time_ = true;
  remark(fmt::format("with {} requests under way: {}; asked again one at a time", round.under_way(), words));
  round.ask_again();
  return true;
}

void Child::lose(Round& round, Lost lost, const std::string& words) {
  if (one_at_a_time_again(round, words)) return;
  round.lose_first(lost, words);
  ++lost_in_a_row_;
  last_loss_ = words;
}

void Child::keep_chatter(const std::string& text) {
  last_chatter_ = readable(text);
  if (++chatter_.count <= long(kMostChatter)) chatter_.first.push_back(last_chatter_);
}

void Child::remark(std::string text) {
  if (remarks_.size() < kMostRemarks && std::ranges::find(remarks_, text) == remarks_.end())
    remarks_.push_back(std::move(text));
}

}  // namespace halfway::check
