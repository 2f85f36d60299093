#include "reports/check/judge/tangent.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::check {
namespace {

/// Poses moved by h along each of (dx_a, w_a, dx_b, w_b), spins in global axes, and by -h.
std::vector<Ask> moved(const Ask& ask, double h) {
  std::vector<Ask> out;
  for (int k = 0; k < 12; ++k) {
    for (const double step : {h, -h}) {
      Ask other = ask;
      reference::AskedBody& body = k < 6 ? other.a : other.b;
      const Vec3<double> along = step * Vec3<double>::Unit(k % 3);
      if (k % 6 < 3)
        body.x += along;
      else
        body.q = reference::times(reference::quaternion_of(along), body.q);
      out.push_back(other);
    }
  }
  return out;
}

std::vector<std::string> ids(const char* what, std::size_t count) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(fmt::format("level3/tangent/{}/{:02}", what, i + 1));
  return out;
}

/// Largest difference over the largest entry; NaN of what was not answered.
double difference(Program& program, const Ask& ask, double h) {
  const auto said = program.ask(ids("tangent", 1), {ask}, true)[0];
  const auto steps = moved(ask, h);
  const auto around = program.ask(ids("loads", steps.size()), steps);
  Eigen::Matrix<double, 12, 12> numeric;
  for (int k = 0; k < 12; ++k) {
    const auto &up = around[std::size_t(2 * k)].loads, &down = around[std::size_t(2 * k + 1)].loads;
    if (!up || !down || !said.tangent) return std::nan("");
    numeric.col(k) = (*up - *down) / (2 * h);
  }
  return (numeric - *said.tangent).cwiseAbs().maxCoeff() / numeric.cwiseAbs().maxCoeff();
}

}  // namespace

Result check_tangent(Program& program, const Hello& hello, const reference::Convention& convention) {
  Result r{"level3/tangent", "the tangent is the derivative of the loads", "T = dq / d(x_a, w_a, x_b, w_b)"};
  r.where = "the program does not say that it gives one";
  if (!hello.tangent || !program.is_live()) return r;
  r.where = "its loads depend on the road";
  if (hello.path) return r;
  r.where = "its convention is not ours";
  if (convention.oddities() > 0) return r;
  const double h = std::pow(10, -hello.digits / 3);  // h^2 and 10^-digits / h are alike
  reference::Measurement worst;
  for (const Ask& ask : reference::generic_asks(4, 0.3, 1.3, reference::Springs::diagonal))
    worst.include(difference(program, ask, h), fmt::format("by differences of {:.0e}", h));
  r.value = worst.value();
  r.limit = 100 * h * h;
  r.where = r.value == r.value ? worst.where() : "not answered";
  if (r.value == r.value) r.status = r.value <= r.limit ? Status::pass : Status::fail;
  return r;
}

}  // namespace halfway::check
