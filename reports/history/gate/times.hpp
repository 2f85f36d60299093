// Two programs, timed in turn: which figures are slower, and how sure is that?
#pragma once

#include "reports/history/gate/journal.hpp"

#include <functional>
#include <string>
#include <vector>

namespace halfway::gate {

struct Side {
  std::string name;                             ///< as the caller named it
  std::string commit{};                         ///< empty: not known
  std::vector<std::filesystem::path> programs;  ///< of one source, in layouts of their own; in turn
};

struct TimeRules {
  int pairs = 9;          ///< processes of each side
  double chance = 0.001;  ///< one-sided, by ranks
  /// Likewise, of fresh pairs by themselves: they are asked whether an alarm comes again, not to raise one.
  double again = 0.05;
  double least = 0.03;                      ///< relative change of the median that counts at all
  std::map<std::string, double> allowed{};  ///< by figure, where its layout alone moves it by more
  double allowed_of(const std::string& figure) const;
};

/// Both sides' numbers of one figure, of its usual layouts, in the order of the pairs.
struct Samples {
  std::vector<double> base, head;
  double base_error = std::numeric_limits<double>::quiet_NaN();  ///< of the last pair
  double head_error = std::numeric_limits<double>::quiet_NaN();
  std::string base_wrong{}, head_wrong{};  ///< why a time is missing
};

/// One figure in one round.
struct Compared {
  double base = 0, head = 0;  ///< medians, ns
  double ratio = 0;           ///< head / base
  double slower = 1;          ///< chance of ranks that high if head is no slower
  double faster = 1;          ///< of ranks that low if it is no faster
};

/// Empty numbers and NaN give NaN ratios and chances of 1. Throws nothing.
Compared compared(const std::vector<double>& base, const std::vector<double>& head);

bool is_slower(const Compared& c, const TimeRules& rules, double allowed);
bool is_faster(const Compared& c, const TimeRules& rules, double allowed);

/// Does an alarm count? Fresh pairs are slower by themselves, and both rounds together are as the first was:
/// a second round judged alone by the first one's rules would lose one real slow-down in thirty (self.json),
/// and all of them where six samples a side are left, whose ranks reach 0.001 in no case.
bool comes_again(const Samples& first, const Samples& again, const TimeRules& rules, double allowed);

/// The samples without those of layouts that are by themselves slower: whose median is more than a tenth
/// above the middle one of the layouts' medians. A change of code moves all layouts of its side; one layout
/// in twelve took a kernel 30 % longer (self.json), and ranks of both sides that overlap for that say nothing
/// of the code.
/// @param layouts  which one each sample is of
std::vector<double> of_usual_layouts(const std::vector<double>& samples, const std::vector<int>& layouts);

using Table = std::map<std::string, Samples>;

using Told = std::function<void(int done, int total, const std::string& left)>;

/// One round: what the journal has is taken from there. Which side goes first changes from pair to pair.
/// Throws reports::FailedRun of a program that fails.
Table measure_round(Journal& journal, const Side& base, const Side& head, const BenchOptions& options,
                    int run, int round, int pairs, const std::filesystem::path& folder, const Told& told);

/// The first round, and of the figures that are slower in it a second with fresh pairs alone.
struct Measured {
  Table first, again;
};
Measured measure_times(Journal& journal, const Side& base, const Side& head, const BenchOptions& options,
                       const TimeRules& rules, int run, const std::filesystem::path& folder,
                       const Told& told);

}  // namespace halfway::gate
