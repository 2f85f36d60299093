// Every check proves that it can fail: the suite's own checks against sabotaged formulations.
#include "reference/record/effort.hpp"
#include "verify/oracle/saboteurs/claims.hpp"
#include "verify/oracle/saboteurs/matrix.hpp"
#include "verify/oracle/saboteurs/sort.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <iterator>
#include <map>
#include <stdexcept>

namespace halfway::verify {
namespace {

/// Each room of checks.def, once.
std::vector<std::string> rooms() {
  std::vector<std::string> out;
  for (const char* room : {
#define HALFWAY_CHECK(room, function) #room,
#include "verify/checks.def"
#undef HALFWAY_CHECK
       }) {
    if (std::ranges::find(out, room) == out.end()) out.emplace_back(room);
  }
  return out;
}

/// Without those of this file: what they have to see is in self().
Checks of_room(const std::string& room) {
  Checks checks = all_checks();
  std::erase_if(checks, [&](const Check& check) {
    return check.label != room || check.name.starts_with("saboteurs/");
  });
  return checks;
}

std::map<std::string, std::vector<Row>>& tables() {
  static std::map<std::string, std::vector<Row>> all;
  return all;
}

std::vector<Finding> findings_of_room(const std::string& room) {
  std::vector<Finding> out;
  for (const Row& row : rows_of_room(room)) out.push_back(finding_of(row));
  return out;
}

// The mechanism itself ------------------------------------------------------------------------------

std::vector<Finding> passing(double value) {
  return {finding("dummy").measured(value).at_most(1, "a dummy").by(Oracle::independent)};
}

double moment() {
  const auto& entry = *reference::find_formulation("invariant");
  const Pose<double> a;
  Pose<double> b;
  b.R = so3::exp<double>({0.3, -0.5, 0.7});
  reference::JointSpec spec;
  spec.law = reference::LinearSpec{Eigen::Vector3d(1, 2, 3).asDiagonal().toDenseMatrix(), false};
  return entry.in_double.angular(spec, a, b, false).m_b.norm();
}

Row row_of(const std::string& name, const std::function<std::vector<Finding>()>& run) {
  const auto make = [&] { return Checks{{name, "dummies", run}}; };
  return matrix(make, {.every = 1, .limit = 1}).front();
}

Finding seen(const std::string& what, const Row& row, std::string_view wrong) {
  const bool is_red = finding_of(row).verdict == Verdict::fail;
  const bool is_named = std::ranges::any_of(row.wrong, [&](const auto& w) { return w.starts_with(wrong); });
  return finding("saboteurs/self/" + what)
      .about("saboteurs")
      .measured(is_red && is_named ? 1 : 0, finding_of(row).parameter)
      .equal(1, 0, "a check that " + what + " turns the suite red")
      .by(Oracle::independent);
}

bool is_of_another_tool(std::string_view check) { return check.starts_with("packaging/"); }

/// What claims.cpp names: mutants that are checks of the suite, of sorts that the suite has.
Finding claims_are_checks() {
  const Checks checks = all_checks();
  int missing = 0;
  std::string which;
  const auto look_for = [&](std::string_view name, auto projection) {
    if (std::ranges::find(checks, name, projection) != checks.end()) return;
    ++missing;
    which += fmt::format("{}{}", which.empty() ? "" : ", ", name);
  };
  for (const Shown& shown : shown_by_mutants()) {
    if (is_of_another_tool(shown.sort)) continue;
    look_for(shown.mutant, &Check::name);
    look_for(shown.sort, [](const Check& check) { return sort_of(check.name); });
  }
  return finding("saboteurs/self/claims_are_checks")
      .about("saboteurs")
      .measured(missing, which)
      .equal(0, 0, "a mutant that is gone claims nothing")
      .by(Oracle::independent);
}

Finding green(const std::string& what, const Row& row, const std::string& why) {
  return finding("saboteurs/self/" + what)
      .about("saboteurs")
      .measured(double(row.wrong.size()), finding_of(row).parameter)
      .equal(0, 0, why)
      .by(Oracle::independent);
}

/// Checks that no suite should have, each registered here alone.
std::vector<Finding> self() {
  const auto is_nan = [] { return std::isnan(moment()); };
  const double healthy = moment();
  return {seen("cannot_fail", row_of("dummies/cannot_fail", [] { return passing(0 * int(moment() > 0)); }),
               "passed moments_nan"),
          seen("looks_at_nothing", row_of("dummies/looks_at_nothing", [] { return passing(0); }),
               "looks at no formulation"),
          seen("sees_no_finite_mistake",
               row_of("dummies/sees_nan_alone", [=] { return passing(is_nan() ? 2 : 0); }),
               "passed every finite"),
          seen("crashes",
               row_of("dummies/crashes",
                      [=] {
                        if (is_nan()) std::raise(SIGSEGV);
                        return passing(std::abs(moment() - healthy) * 1e9);
                      }),
               "crashed moments_nan"),
          seen("hangs",
               row_of("dummies/hangs",
                      [=] {
                        for (volatile bool forever = is_nan(); forever;) continue;
                        return passing(std::abs(moment() - healthy) * 1e9);
                      }),
               "hung moments_nan"),
          green("sound", row_of("dummies/sound", [=] { return passing(std::abs(moment() - healthy) * 1e9); }),
                "a check that sees both stays green"),
          green("mutant_is_enough", row_of("identities/eq_29_printed", [] { return passing(0); }),
                "a check that looks at nothing stays green where a mutant makes its measurement"),
          claims_are_checks()};
}

}  // namespace

const std::vector<Row>& rows_of_room(const std::string& room) {
  auto& all = tables();
  if (const auto it = all.find(room); it != all.end()) return it->second;
  return all[room] = matrix([&] { return of_room(room); }, {.every = by_effort(1, 12), .limit = 40});
}

std::vector<Row> computed_rows() {
  std::vector<Row> out;
  for (const auto& [room, rows] : tables())
    std::ranges::copy_if(rows, std::back_inserter(out), &std::string::empty, &Row::left_out);
  for (const Shown& shown : shown_by_mutants()) {
    if (is_of_another_tool(shown.sort))
      out.push_back(
          {.check = std::string(shown.sort), .room = "packaging", .caught = {std::string(shown.mutant)}});
  }
  return out;
}

void saboteurs(Checks& checks) {
  for (const std::string& room : rooms())
    checks.push_back({"saboteurs/" + room, "oracle", [room] { return findings_of_room(room); }});
  checks.push_back({"saboteurs/self", "oracle", self});
}

}  // namespace halfway::verify
