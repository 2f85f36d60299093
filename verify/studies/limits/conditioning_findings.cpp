// How many digits each formulation loses, and to what: error = constant x eps x a known factor. The
// constants are held; the factors are what conditioning means.
#include "verify/oracle/property.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/limits/conditioning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfway::verify {
namespace {

using reference::ErrorRow, reference::ErrorRows, reference::errors, reference::errors_at_bad_stiffness,
    reference::errors_over_distance, reference::errors_over_drift, reference::errors_over_phi,
    reference::errors_over_ratio, reference::scene_refusal;

constexpr double kEps = std::numeric_limits<double>::epsilon();
constexpr double kFloatEps = std::numeric_limits<float>::epsilon();

using Scale = double (*)(double x);

/// Largest error of a series over eps x scale(x).
Finding held(const Entry& entry, const ErrorRows& rows, const std::string& series,
             const std::string& property, double eps, Scale scale, double limit, const std::string& reason) {
  const Kind kind = series.ends_with("linear_angular") ? Kind::linear_angular
                    : series.ends_with("linear")       ? Kind::linear
                                                       : Kind::angular;
  Measurement worst;
  for (const ErrorRow& row : rows) {
    if (row.what != series || !row.note.empty()) continue;
    worst.include(row.error / (eps * scale(row.x)), fmt::format("{:.2g}", row.x));
  }
  return property_finding(entry, kind, "conditioning_" + property)
      .measured(worst)
      .in("eps")
      .at_most(limit, reason)
      .by(Oracle::fifty_digits);
}

bool has(const ErrorRows& rows, const std::string& series) {
  return std::any_of(rows.begin(), rows.end(), [&](const ErrorRow& r) { return r.what == series; });
}

ErrorRows up_to_one(ErrorRows rows) {  // beyond, poles and folds of the measure magnify on their own
  std::erase_if(rows, [](const ErrorRow& r) { return r.x > 1.5; });
  return rows;
}

std::vector<Finding> over_phi(const Entry& entry) {
  const ErrorRows rows = up_to_one(errors(entry, errors_over_phi));
  const Scale plain = [](double phi) { return 1 / std::min(phi, 1.); };
  const Scale none = [](double) { return 1.; };
  const std::string lost = "products of poses leave a few eps of the relative rotation: eps/phi of the loads";
  std::vector<Finding> out = {held(entry, rows, "phi/double", "phi_double", kEps, plain, 8, lost)};
  if (has(rows, "phi/kernel"))
    out.push_back(held(entry, rows, "phi/kernel", "phi_kernel", kEps, plain, 8, lost));
  if (has(rows, "phi/float"))
    out.push_back(held(entry, rows, "phi/float", "phi_float", kFloatEps, plain, 8, lost));
  if (has(rows, "phi/compensated"))
    out.push_back(held(entry, rows, "phi/compensated", "phi_compensated", kEps, none, 8,
                       "compensated products: a few roundings at any angle, none magnified"));
  return out;
}

std::vector<Finding> over_ratio(const Entry& entry) {
  const ErrorRows& rows = errors(entry, errors_over_ratio);
  const Scale none = [](double) { return 1.; };
  const Scale ratio = [](double r) { return r; };
  std::vector<Finding> out;
  for (const std::string law : {"ratio_diagonal", "ratio_rotated"}) {
    out.push_back(held(entry, rows, law + "/loads", law + "_loads", kEps, none, 10,
                       "a sum of products, relative to its largest term: no inverse, no ratio"));
    out.push_back(held(entry, rows, law + "/solve", law + "_solve", kEps, ratio, 8,
                       "eps of the stiffest axis' moment turns the softest axis by eps x ratio"));
  }
  int unfinished = 0, unsolved = 0;
  std::string which;
  for (const ErrorRow& row : rows) {
    if (row.note.empty()) continue;
    ++(std::isfinite(row.error) ? unfinished : unsolved);
    which += fmt::format("{} at {:.0e}: {}; ", row.what, row.x, row.note);
  }
  const auto counted = [&](const char* what, int count, const char* why) {
    return property_finding(entry, Kind::angular, what)
        .measured(count, which)
        .in("of 18 solves")
        .at_most(0, why)
        .by(Oracle::closed_form);
  };
  out.push_back(
      counted("conditioning_ratio_unfinished", unfinished, "what is called converged has ended at rounding"));
  out.push_back(counted("conditioning_ratio_unsolved", unsolved,
                        "0.3 rad about the softest axis is far from any limit point"));
  return out;
}

std::vector<Finding> at_bad_stiffness(const Entry& entry) {
  if (entry.convex_radius)
    return {property_finding(entry, Kind::angular, "conditioning_singular_loads")
                .left_out("takes no law whose angular stiffness is not positive definite")};
  return {held(
      entry, errors(entry, errors_at_bad_stiffness), "singular/loads", "singular_loads", kEps,
      [](double) { return 1.; }, 4, "loads need no inverse: singular and indefinite laws evaluate")};
}

/// log of the error's growth from 1e-9 to 1e-4, a decade.
Finding slope(const Entry& entry, const ErrorRows& rows, const std::string& series, double expected,
              const std::string& reason) {
  double first = std::nan(""), last = std::nan("");
  for (const ErrorRow& row : rows) {
    if (row.what != series) continue;
    if (std::abs(row.x / 1e-9 - 1) < 1e-6) first = row.error;
    if (std::abs(row.x / 1e-4 - 1) < 1e-6) last = row.error;
  }
  const auto slash = series.find('/');
  const Kind kind = series.substr(slash + 1) == "angular" ? Kind::angular : Kind::linear_angular;
  return property_finding(entry, kind, "conditioning_" + series.substr(0, slash) + "_slope")
      .measured(std::log10(last / first) / 5, fmt::format("{:.3g} x drift at 1e-4", last / 1e-4))
      .equal(expected, 1e-4, reason + "; the next order is 1e-4 of it at the largest drift, 1e-5 of a decade")
      .by(Oracle::closed_form);
}

std::vector<Finding> over_drift(const Entry& entry) {
  const ErrorRows& rows = errors(entry, errors_over_drift);
  std::vector<Finding> out;
  for (const std::string kind : {"angular", "linear_angular"}) {
    out.push_back(slope(entry, rows, "drift/" + kind, 1, "loads are smooth in the entries of R"));
    out.push_back(slope(entry, rows, "drift_quaternion/" + kind, 1,
                        "a quaternion read off some entries is a rotation, but not the nearest one"));
    out.push_back(slope(entry, rows, "drift_polar/" + kind, 2, "a Newton step towards the nearest rotation"));
  }
  return out;
}

std::vector<Finding> over_distance(const Entry& entry) {
  const ErrorRows& rows = errors(entry, errors_over_distance);
  // Node and joint points' coordinates, over a strain of 0.1 m.
  const Scale from_origin = [](double length) { return 1 + (length + 2 * 0.3) / 0.1; };
  const Scale from_nodes = [](double length) { return 1 + (0.2 + 2 * length) / 0.1; };
  std::vector<Finding> out;
  for (const std::string place : {"distance", "offset"}) {
    for (const std::string kind : {"linear", "linear_angular"}) {
      out.push_back(held(
          entry, rows, place + "/" + kind, place, kEps, place == "distance" ? from_origin : from_nodes, 8,
          "a turned arm is 5 roundings of its length (matrix of a quaternion, three products), a "
          "force as many of its own"));
    }
  }
  return out;
}

/// The scene reader says what is wrong with a law that no body can have. A singular one is allowed: it has a
/// free direction, and `run` refuses the load that works on it.
std::vector<Finding> refusals() {
  struct Bad {
    const char* what;
    Mat3<double> K;
    const char* message;
  };
  Mat3<double> indefinite;
  indefinite << 1, 2, 0, 2, 1, 0, 0, 0, 1;
  std::vector<Finding> out;
  for (const Bad& bad : {Bad{"indefinite", indefinite, "is indefinite"},
                         Bad{"negative", Vec3<double>(-1, 1, 2).asDiagonal(), "has -1 on its diagonal"}}) {
    const std::string message = tapped(scene_refusal(bad.K));
    out.push_back(finding(fmt::format("conditioning/refused/{}", bad.what))
                      .about("conditioning")
                      .measured(message.find(bad.message) == std::string::npos,
                                message.empty() ? "it was accepted" : message)
                      .in("missing message")
                      .at_most(0, fmt::format("must say: {}", bad.message))
                      .by(Oracle::closed_form));
  }
  return out;
}

}  // namespace

void conditioning(Checks& checks) {
  for (const Entry& entry : reference::formulations()) {
    const std::string name = fmt::format("{}/angular/conditioning", entry.name);
    const auto add = [&](const char* what, std::vector<Finding> (*measure)(const Entry&)) {
      checks.push_back({name + what, "stability", [&entry, measure] { return measure(entry); }});
    };
    add("_phi", over_phi), add("_ratio", over_ratio), add("_singular", at_bad_stiffness);
    add("_drift", over_drift), add("_distance", over_distance);
  }
  checks.push_back({"conditioning/refused", "stability", refusals});
}

}  // namespace halfway::verify
