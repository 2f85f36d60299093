// The xi that comes nearest to a body without mirror symmetry.
#include "reports/advise/core/fit_xi.hpp"

#include <cmath>

namespace halfway::advise {

std::optional<double> fitted_xi(const Truth& truth, const Envelope& envelope, const Answers& answers,
                                Measure measure) {
  const auto* intrinsic = reference::find_formulation("intrinsic");
  if (!intrinsic || (truth.kind != TruthKind::body && truth.kind != TruthKind::table)) return std::nullopt;
  const std::vector<double> factors(envelope.factors.begin(),
                                    envelope.factors.begin() + std::ptrdiff_t(envelope.rows));
  const auto error = [&](double xi) {
    const Answers path = follow(truth.scene, {intrinsic, xi, true, truth.scene.joint.kind}, factors);
    return worst_of(errors_of(path, answers, measure),
                    path.value.size() < factors.size() ? 0 : factors.size());
  };
  // Golden section: one minimum between both nodes and as far again, for a linear coupling has one.
  constexpr double kGolden = 0.6180339887498949;
  double low = -0.5, high = 1.5;
  double x = high - kGolden * (high - low), y = low + kGolden * (high - low);
  double at_x = error(x), at_y = error(y);
  for (int i = 0; i < 24; ++i) {  // to 2e-5
    if (at_x < at_y) {
      high = y, y = x, at_y = at_x;
      x = high - kGolden * (high - low), at_x = error(x);
    } else {
      low = x, x = y, at_x = at_y;
      y = low + kGolden * (high - low), at_y = error(y);
    }
  }
  const double best = (low + high) / 2;
  return std::isfinite(error(best)) ? std::optional(best) : std::nullopt;
}

}  // namespace halfway::advise
