#include "verify/oracle/saboteurs/matrix.hpp"

#include "verify/oracle/saboteurs/claims.hpp"
#include "verify/oracle/saboteurs/sort.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <stdexcept>

namespace halfway::verify {
namespace {

Parts without(const Parts& seen, const Parts& ignored) {
  return {seen.moments && !ignored.moments, seen.forces && !ignored.forces, seen.tangent && !ignored.tangent,
          seen.strain && !ignored.strain,   seen.energy && !ignored.energy, seen.taps && !ignored.taps};
}

bool shares(const Parts& x, const Parts& y) {
  return (x.moments && y.moments) || (x.forces && y.forces) || (x.tangent && y.tangent) ||
         (x.strain && y.strain) || (x.energy && y.energy) || (x.taps && y.taps);
}

/// A row in the making: `judged` is what the check has to see.
struct Draw {
  std::size_t at = 0;  ///< of the check in the list of all
  Row row{};
  Parts judged{};
  bool has_finite_catch = false;
  bool has_mutant = false;
};

Draw met_the_witness(const Check& check, const Siblings& siblings, std::size_t at, const Trial& healthy) {
  Draw out{at, {check.name, check.label, siblings.members.size(), healthy.seen}};
  out.row.caught = mutants_of(siblings.sort);
  out.has_mutant = !out.row.caught.empty();
  if (healthy.outcome != Outcome::passed)
    out.row.wrong.push_back(fmt::format("healthy {}: {}", to_string(healthy.outcome), healthy.by));
  out.judged = without(healthy.seen, overlooked(check.name));
  out.has_finite_catch = !healthy.judges;  // one that only reports fails for what is no number
  if (!out.judged.any() && !out.has_mutant)
    out.row.wrong.emplace_back("looks at no formulation, at nothing that passes a tap, and has no mutant");
  return out;
}

/// Those that make NaN what the check judges, and the others until one was caught.
bool wanted(const Draw& draw, const Saboteur& saboteur) {
  if (!draw.judged.any()) return false;
  if (saboteur.nan.any()) return shares(draw.judged, saboteur.nan);
  const bool has_face = without(draw.judged, {.taps = true}).any();
  if (saboteur.name == "throws") return draw.judged.moments || draw.judged.forces;
  return !draw.has_finite_catch && (saboteur.tap == Tap::healthy ? has_face : draw.judged.taps);
}

void meet(Draw& draw, const Saboteur& saboteur, const Trial& trial) {
  const bool has_to = saboteur.nan.any() || saboteur.name == "throws";
  if (trial.caught()) {
    draw.row.caught.emplace_back(saboteur.name);
    draw.has_finite_catch = draw.has_finite_catch || !has_to;
  } else if (has_to || trial.outcome != Outcome::passed) {
    draw.row.wrong.push_back(fmt::format("{} {}", to_string(trial.outcome), saboteur.name));
  }
}

/// The first of its sort that judges, or else the first that is not left out.
Draw spokesman(const Checks& checks, const Siblings& siblings, int limit, const Parts& seen) {
  constexpr std::size_t kTried = 4;
  std::optional<Draw> reports;
  for (std::size_t i = 0; i < siblings.members.size() && (i < kTried || !reports); ++i) {
    const std::size_t at = siblings.members[i];
    const Trial healthy = run_apart(checks[at], limit, seen);
    if (healthy.left_out) continue;
    const Draw draw = met_the_witness(checks[at], siblings, at, healthy);
    if (healthy.judges || healthy.outcome != Outcome::passed) return draw;
    if (!reports) reports = draw;
  }
  if (reports) return *reports;
  const Check& first = checks[siblings.members.front()];
  Draw none{siblings.members.front(), {first.name, first.label, siblings.members.size()}};
  none.row.left_out = "all checks of its sort are left out";
  return none;
}

std::vector<Draw> healthy_rows(const std::function<Checks()>& make, const Sampling& sampling) {
  Parts seen;
  const reference::ScopedRegistry guard(witnessed(seen));
  const Checks checks = make();
  const std::vector<Siblings> sorts = sorted(checks);
  std::vector<Draw> out;
  for (std::size_t i = 0; i < sorts.size(); i += std::size_t(sampling.every))
    out.push_back(spokesman(checks, sorts[i], sampling.limit, seen));
  return out;
}

}  // namespace

std::vector<Row> matrix(const std::function<Checks()>& make, const Sampling& sampling) {
  std::vector<Draw> draws = healthy_rows(make, sampling);
  for (const Saboteur& saboteur : saboteurs()) {
    const ScopedSabotage guard(saboteur);
    const Checks checks = make();
    for (Draw& draw : draws) {
      if (checks.at(draw.at).name != draw.row.check)
        throw std::logic_error("checks change with the saboteur");
      if (wanted(draw, saboteur)) meet(draw, saboteur, run_apart(checks[draw.at], sampling.limit));
    }
  }
  std::vector<Row> out;
  for (Draw& draw : draws) {
    if (draw.judged.any() && !draw.has_finite_catch && !draw.has_mutant)
      draw.row.wrong.emplace_back("passed every finite saboteur");
    out.push_back(std::move(draw.row));
  }
  return out;
}

Finding finding_of(const Row& row) {
  const Draft draft = finding("saboteurs/" + row.check).about("saboteurs");
  if (!row.left_out.empty()) return Draft(draft).left_out(row.left_out);
  std::string where = row.wrong.empty() ? "" : fmt::format("{}; ", fmt::join(row.wrong, "; "));
  where +=
      row.caught.empty() ? "caught by nothing" : fmt::format("caught by {}", fmt::join(row.caught, ", "));
  if (row.siblings > 1) where += fmt::format("; it speaks for {} checks of its sort", row.siblings);
  return Draft(draft)
      .measured(double(row.wrong.size()), where)
      .in("saboteurs missed")
      .equal(
          0, 0,
          "NaN in what it judges has to fail it, and one finite mistake at least; none may crash it or hang")
      .by(Oracle::independent);
}

}  // namespace halfway::verify
