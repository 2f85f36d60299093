#include "verify/studies/rods/rod_access.hpp"

#include "reference/numbers/digits.hpp"
#include "reference/truth/closed_forms.hpp"
#include "reference/truth/data.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {

namespace rod = reference::rod;

Draft rod_finding(const std::string& name) { return finding("rods/" + name).about("rods"); }

Draft digits_finding(const std::string& name, const Measurement& worst) {
  return rod_finding(name)
      .measured(worst)
      .in("units of the last digit but one")
      .at_most(1, "the kept digits are good to the last but one; the rod's own error is at rounding")
      .by(Oracle::independent);
}

double digits_apart(double value, const std::string& kept) {
  return std::abs(tapped(value) - std::stod(kept)) / (10 * reference::last_digit(kept));
}

void include_digits(Measurement& worst, const Vec3<double>& value, const nlohmann::json& kept,
                    const std::string& where) {
  for (int i = 0; i < 3; ++i)
    worst.include(digits_apart(value[i], kept.at(std::size_t(i)).get<std::string>()),
                  fmt::format("{}, component {}", where, i + 1));
}

const nlohmann::json& kept_rods() {
  static const nlohmann::json data = reference::read_data("rods/values.json");
  return data;
}

Vec3<double> vector_of(const nlohmann::json& numbers) {
  return {numbers.at(0).get<double>(), numbers.at(1).get<double>(), numbers.at(2).get<double>()};
}

std::vector<KeptTip> kept_tips() {
  std::vector<KeptTip> out;
  for (const nlohmann::json& row : kept_rods().at("tips")) {
    const auto vector = [&](const char* key) {
      return row.contains(key) ? vector_of(row.at(key)) : Vec3<double>(0, 0, 0);
    };
    KeptTip tip{row.at("name"), {}, {}, Mat3<double>::Identity(), row.at("x"), nullptr};
    const Vec3<double> bending = vector("stiffness_bending");
    tip.rod.section = row.contains("stiffness_stretching")
                          ? rod::of_stiffness(bending, vector("stiffness_stretching"))
                          : rod::of_stiffness(bending);
    tip.rod.length = row.at("length");
    tip.rod.curvature0 = vector("curvature0");
    tip.loads = {.force = vector("force"), .moment = vector("moment")};
    if (row.contains("clamp_axes")) {
      for (int i = 0; i < 3; ++i) tip.clamp.col(i) = vector_of(row.at("clamp_axes").at(std::size_t(i)));
    }
    if (row.contains("theta")) tip.theta = row.at("theta");
    out.push_back(std::move(tip));
  }
  return out;
}

Vec3<double> rotation_of(const Mat3<double>& R) { return reference::closed::rotation_vector(R); }

rod::Rod straight_rod(double length, const Vec3<double>& bending) {
  return rod::straight(length, rod::of_stiffness(bending));
}

void CriticalLoads::against(const rod::Critical& found, double exact, const std::string& where) {
  apart.include(relative(found.load, exact), where);
  error_bars.include(tapped(found.error / found.load), where);
}

void CriticalLoads::against(const rod::Critical& found, const std::string& kept, const std::string& where) {
  digits.include(digits_apart(found.load, kept), where);
  error_bars.include(tapped(found.error / found.load), where);
}

std::vector<Finding> findings_of(const std::string& name, const CriticalLoads& loads) {
  std::vector<Finding> out;
  const auto limit = [&](const std::string& which, const Measurement& m, double most, const char* why,
                         Oracle oracle) {
    out.push_back(
        rod_finding("critical/" + name + which).measured(m).in("relative").at_most(most, why).by(oracle));
  };
  if (!loads.apart.is_empty())
    limit("", loads.apart, 1e-12,
          "closed forms: rounding of some hundred steps over the slope of the determinant at its zero",
          Oracle::closed_form);
  if (!loads.digits.is_empty()) out.push_back(digits_finding("critical/" + name + "/digits", loads.digits));
  limit("/error_bar", loads.error_bars, 1e-12,
        "half the steps: order 8 leaves 256 times the error of the steps taken, which is at rounding",
        Oracle::independent);
  return out;
}

double relative(double a, double b) { return std::abs(tapped(a) / b - 1); }

}  // namespace halfway::verify
