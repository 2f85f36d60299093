// What the checks of rods share: kept numbers by their digits, kept rods, and their findings.
#pragma once

#include "reference/record/worst.hpp"
#include "reference/truth/rod/critical.hpp"
#include "verify/check.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace halfway::verify {

using reference::Measurement;

/// A finding on a rod: name "rods/...", subject "rods".
Draft rod_finding(const std::string& name);

/// One of values that were kept with their digits: at most a unit of the last digit but one apart.
Draft digits_finding(const std::string& name, const Measurement& worst);

/// |value - kept| in units of the last digit but one of the kept text, of a value on its way into a check.
double digits_apart(double value, const std::string& kept);
/// The same of a vector, the worst of its entries.
void include_digits(Measurement& worst, const Vec3<double>& value, const nlohmann::json& kept,
                    const std::string& where);

/// reference/data/rods/values.json
const nlohmann::json& kept_rods();

Vec3<double> vector_of(const nlohmann::json& numbers);

/// A rod, its loads and the tip that was kept of it.
struct KeptTip {
  std::string name;
  reference::rod::Rod rod;
  reference::rod::Loads loads;
  Mat3<double> clamp;  ///< axes of the clamp -> those of x
  nlohmann::json x, theta;
};
std::vector<KeptTip> kept_tips();

/// The rotation vector of R by the formula that shares nothing with the library's, 0 < |theta| < pi.
Vec3<double> rotation_of(const Mat3<double>& R);

/// Straight, uniform, inextensible.
/// @param bending  (GJ, EI2, EI3), N m^2; infinite where it is rigid
reference::rod::Rod straight_rod(double length, const Vec3<double>& bending);

/// Critical loads of one kind by the rod's determinants, on their way into a check.
struct CriticalLoads {
  Measurement apart;       ///< from closed forms, relative
  Measurement error_bars;  ///< that they state of themselves, relative
  Measurement digits;      ///< from kept values

  void against(const reference::rod::Critical& found, double exact, const std::string& where);
  void against(const reference::rod::Critical& found, const std::string& kept, const std::string& where);
};
/// What was measured of them: name, name/error_bar and name/digits below "rods/critical/".
std::vector<Finding> findings_of(const std::string& name, const CriticalLoads& loads);

/// |a/b - 1| of a value a on its way into a check.
double relative(double a, double b);

}  // namespace halfway::verify
