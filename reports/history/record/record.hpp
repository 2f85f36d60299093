// One run as it enters the history: its circumstances, and what each figure came to.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace halfway::history {

inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct Machine {
  std::string cpu;
  int cores = 0;
  std::string caches, microcode;  ///< empty: not known
  bool operator==(const Machine&) const = default;
};

/// Figures are compared only within a series.
struct Series {
  Machine machine;
  std::string compiler, flags, build_type;
  std::string isa;  ///< the widest instruction set: avx512, avx2, sse2; empty: not known
  bool operator==(const Series&) const = default;
};

struct Run {
  int id = 0;      ///< its number in the file; 0: not kept
  int series = 0;  ///< index, see History
  std::string commit;
  bool dirty = false;       ///< the tree was not what was committed
  std::string date;         ///< UTC, 2026-11-29T04:32:45Z
  std::string title;        ///< subject of the commit
  std::string release;      ///< name of a tag; empty: none
  double load = kNone;      ///< of the machine, before the timings
  std::string libraries{};  ///< JSON object, name -> version
};

enum class Kind { accuracy, time, count };
enum class Better { down, up, none };
/// As in results.json; none: nothing was said about this figure.
enum class Comparison { none, at_most, at_least, within, equal, report };
enum class Verdict {
  none,
  pass,
  known_failure,
  fail,
  left_out,
  gone
};  ///< gone: nothing measures it any more

struct Figure {
  std::string name{};  ///< unique
  std::string unit{};
  Kind kind = Kind::accuracy;
  Better better = Better::none;
  std::string formulation{};  ///< empty: of none
  bool operator==(const Figure&) const = default;
};

/// What a deterministic figure came to.
struct Reading {
  double value = kNone;  ///< NaN: nothing was measured
  Comparison comparison = Comparison::none;
  double expected = 0, low = 0, high = 0;  ///< read as `comparison` says
  Verdict verdict = Verdict::none;
};
bool same(const Reading& a, const Reading& b);  ///< NaN is NaN

/// Seconds since 1970 of a date as above. Throws std::invalid_argument.
std::int64_t seconds_of(const std::string& date);

/// The size whose digits count, and the largest that is allowed; NaN where there is none.
double error_of(const Reading& reading);
double limit_of(const Reading& reading);

/// Decimal digits of an error, at most 17: a zero is as good as the smallest rounding.
double digits_of(double error);

/// What a time came to, over its repetitions.
struct Time {
  std::int64_t median = 0;  ///< ps per joint or solve
  int low = 0, high = 0;    ///< least and largest repetition, permille of the median; 0: not known
  int n = 0;                ///< repetitions; 0: not known
  double ns() const { return double(median) / 1e3; }
  double low_ns() const { return low > 0 ? double(median * low) / 1e6 : kNone; }
  double high_ns() const { return high > 0 ? double(median * high) / 1e6 : kNone; }
  bool operator==(const Time&) const = default;
};
using Repetitions = std::vector<std::int64_t>;  ///< ps

struct Record {
  Run run;
  Series series;
  struct Exact {
    Figure figure;
    Reading reading;
  };
  struct Timed {
    Figure figure;
    Time time;
    Repetitions repetitions{};
  };
  std::map<std::string, Exact> exact{};  ///< by name
  std::map<std::string, Timed> timed{};
  bool is_partial = false;  ///< figures that are not here hold their last value, else they are gone
};

const char* to_string(Kind);
const char* to_string(Better);
const char* to_string(Comparison);
const char* to_string(Verdict);
/// Throws std::invalid_argument "kind 'x'; allowed: accuracy, time, count".
void from_string(const std::string& text, Kind& out);
void from_string(const std::string& text, Better& out);
void from_string(const std::string& text, Comparison& out);
void from_string(const std::string& text, Verdict& out);

}  // namespace halfway::history
