#include "verify/oracle/saboteurs/matrix.hpp"

#include "verify/oracle/saboteurs/claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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
};

Draw met_the_witness(const Check& check, std::size_t at, const Trial& healthy) {
  Draw out{at, {check.name, check.label, healthy.seen}, {}};
  if (healthy.outcome != Outcome::passed)
    out.row.wrong.push_back(fmt::format("healthy {}: {}", to_string(healthy.outcome), healthy.by));
  out.judged = without(healthy.seen, overlooked(check.name));
  out.has_finite_catch = !healthy.judges;  // one that only reports fails for what is no number
  if (!out.judged.any())
    out.row.wrong.emplace_back("looks at no formulation, and at nothing that passes a tap");
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

std::vector<Draw> healthy_rows(const std::function<Checks()>& make, const Sampling& sampling) {
  Parts seen;
  const reference::ScopedRegistry guard(witnessed(seen));
  const Checks checks = make();
  std::vector<Draw> out;
  for (std::size_t i = 0; i < checks.size(); i += std::size_t(sampling.every)) {
    const Trial healthy = run_apart(checks[i], sampling.limit, seen);
    if (!healthy.left_out) out.push_back(met_the_witness(checks[i], i, healthy));
  }
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
    if (draw.judged.any() && !draw.has_finite_catch)
      draw.row.wrong.emplace_back("passed every finite saboteur");
    out.push_back(std::move(draw.row));
  }
  return out;
}

Finding finding_of(const Row& row) {
  const std::string caught =
      row.caught.empty() ? "caught by nothing" : fmt::format("caught by {}", fmt::join(row.caught, ", "));
  const std::string where =
      row.wrong.empty() ? caught : fmt::format("{}; {}", fmt::join(row.wrong, "; "), caught);
  return finding("saboteurs/" + row.check)
      .about("saboteurs")
      .measured(double(row.wrong.size()), where)
      .in("saboteurs missed")
      .equal(
          0, 0,
          "NaN in what it judges has to fail it, and one finite mistake at least; none may crash it or hang")
      .by(Oracle::independent);
}

}  // namespace halfway::verify
