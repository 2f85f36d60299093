#include "reports/history/gate/judge.hpp"

#include "reports/cli/errors.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::gate {
namespace {

std::string named(const Side& side) {
  return side.commit.empty() ? side.name : fmt::format("{} ({})", side.name, side.commit.substr(0, 12));
}

std::string sizes(const Compared& c) {
  return fmt::format("time {:.4g} -> {:.4g} ns ({:+.1f} %)", c.base, c.head, 100 * (c.ratio - 1));
}

/// "time +6 %, instructions +0 %: layout or machine"
std::string with_instructions(const std::optional<double>& base, const std::optional<double>& head) {
  if (!base || !head) return "";
  const double change = 100 * (*head / *base - 1);
  // Below 0.5 %, no slow-down of 3 % comes from them.
  return fmt::format(", instructions {:+.1f} %{}", change,
                     std::abs(change) < 0.5 ? ": layout or machine" : "");
}

class Judge {
 public:
  Judge(const Measured& measured, const Side& base, const Side& head, const TimeRules& rules,
        const Instructions& count)
      : measured_(measured), base_(base), head_(head), rules_(rules), count_(count) {
    out_.title = fmt::format("{} against {}", named(head), named(base));
  }

  Outcome run() {
    for (const auto& [name, s] : measured_.first) {
      if (!s.head_wrong.empty())
        add(Sense::regression, name, "not measured: " + s.head_wrong);
      else if (s.head.empty())
        add(Sense::regression, name, "gone: nothing measures it any more");
      else if (s.base.empty() || !s.base_wrong.empty())
        add(Sense::change, name, s.base.empty() ? "new" : "measured again; before: " + s.base_wrong);
      else
        both(name, s);
    }
    if (out_.compared == 0 && out_.count(Sense::regression) == 0)
      throw reports::FailedRun("nothing compared: no figure was measured on both sides");
    return out_;
  }

 private:
  void add(Sense sense, const std::string& name, const std::string& text) {
    out_.lines.push_back({sense, name, text});
  }

  void both(const std::string& name, const Samples& s) {
    ++out_.compared;
    errors(name, s);
    const double allowed = rules_.allowed_of(name);
    const Compared first = compared(s.base, s.head);
    if (is_faster(first, rules_, allowed))
      add(Sense::improvement, name, fmt::format("{}, p = {:.1g}", sizes(first), first.faster));
    if (is_slower(first, rules_, allowed)) slower(name, s, first, allowed);
  }

  void slower(const std::string& name, const Samples& s, const Compared& first, double allowed) {
    const auto found = measured_.again.find(name);
    const Compared again = found == measured_.again.end()
                               ? Compared{.ratio = std::numeric_limits<double>::quiet_NaN()}
                               : compared(found->second.base, found->second.head);
    if (found == measured_.again.end() || std::isnan(again.ratio))
      return add(Sense::regression, name, sizes(first) + ", and not measured when it was measured again");
    if (!comes_again(s, found->second, rules_, allowed)) {
      out_.notes.push_back(fmt::format("{}: {} at first, {:+.1f} % with fresh pairs: no alarm", name,
                                       sizes(first), 100 * (again.ratio - 1)));
      return;
    }
    add(Sense::regression, name,
        fmt::format("{}{}, since {}; p = {:.1g}, with fresh pairs {:+.1f} %, p = {:.1g}; {:.1f} % is allowed",
                    sizes(first), with_instructions(count_(base_, name), count_(head_, name)), named(base_),
                    first.slower, 100 * (again.ratio - 1), again.slower, 100 * allowed));
  }

  void errors(const std::string& name, const Samples& s) {
    if (std::isnan(s.base_error) && std::isnan(s.head_error)) return;
    const auto change = statistics::exact_change({.value = s.base_error, .error = s.base_error},
                                                 {.value = s.head_error, .error = s.head_error});
    if (change) add(change->sense, name, "error " + change->text);
  }

  const Measured& measured_;
  const Side &base_, &head_;
  const TimeRules& rules_;
  const Instructions& count_;
  Outcome out_;
};

}  // namespace

Outcome judge(const Measured& measured, const Side& base, const Side& head, const TimeRules& rules,
              const Instructions& instructions) {
  return Judge(measured, base, head, rules, instructions).run();
}

}  // namespace halfway::gate
