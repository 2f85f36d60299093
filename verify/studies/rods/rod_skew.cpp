// What a rod does where the moment of one joint is critical: a small skew grows about the intermediate axis,
// and oscillates about the others.
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/rods/rod_access.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

namespace rod = reference::rod;

/// Body components of m at the tip over the skew, skew -> 0: Euler's equations linearised about axis 1,
/// (u sinh(r L) (C1 - C3)/r, cosh(r L)) with the rate r = M sqrt((C2 - C1)(C1 - C3)); of an extreme axis cos
/// and sin.
std::vector<Finding> skew() {
  constexpr double kSkew = 1e-7;
  const Vec3<double> intermediate = vector_of(kept_rods().at("skew_growth").at("compliance"));
  const Vec3<double> extreme(intermediate[1], intermediate[0], intermediate[2]);
  Measurement worst;
  for (const Vec3<double>& C : {intermediate, extreme}) {
    for (const double M : {200., 600., 1200.}) {
      const rod::Tip tip = tip_under_moment(straight_rod(1, C.cwiseInverse()), M * Vec3<double>(1, 0, kSkew));
      const Vec3<double> along = tapped<Vec3<double>>(tip.R.transpose() * Vec3<double>(1, 0, kSkew) / kSkew);
      const double square = (C[1] - C[0]) * (C[0] - C[2]), rate = M * std::sqrt(std::abs(square));
      const double even = square > 0 ? std::cosh(rate) : std::cos(rate);
      const double odd = M * (C[0] - C[2]) * (square > 0 ? std::sinh(rate) : std::sin(rate)) / rate;
      worst.include(std::hypot(along[1] - odd, along[2] - even) / std::hypot(odd, even),
                    fmt::format("{} N m, {}", M, square > 0 ? "grows" : "oscillates"));
    }
  }
  Measurement digits;
  for (const nlohmann::json& row : kept_rods().at("skew_growth").at("rows")) {
    const double M = std::stod(row.at(0).get<std::string>());
    const rod::Tip tip =
        tip_under_moment(straight_rod(1, intermediate.cwiseInverse()), M * Vec3<double>(1, 0, kSkew));
    digits.include(digits_apart(rotation_of(tip.R)[1] / kSkew, row.at(1).get<std::string>()),
                   fmt::format("{} N m", M));
  }
  return {
      digits_finding("skew/theta_2", digits),
      rod_finding("skew/growth")
          .measured(worst)
          .in("relative")
          .at_most(1e-7,
                   "a skew of 1e-7 grown 100 times is 1e-5: its square, of what is kept to first order, is "
                   "1e-10; rounding of 1 beside the skew is 1e-9")
          .by(Oracle::closed_form)};
}

}  // namespace

void rod_skew(Checks& checks) { checks.push_back({"rods/skew", "", skew}); }

}  // namespace halfway::verify
