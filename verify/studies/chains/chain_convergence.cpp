// Chains tend to the rod: half-way joints with N^-2, those of one node's frame with 1/N and opposite bias.
#include "reference/truth/data.hpp"
#include "verify/check.hpp"
#include "verify/studies/chains/chain_orders.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

using nlohmann::json;
using reference::Entry;

/// What the kept table says of a formulation and a rod.
struct Expected {
  double order, tolerance;
  std::string why;
  Oracle oracle;
  std::string constant{};  ///< digits as kept; empty: none
};

constexpr double kOrderTolerance = 0.03;
constexpr const char* kTheory =
    "the midpoint rule: a moment that is the rod's to second order errs at h^2, another at h; the next order "
    "leaves "
    "less than 0.03 from 64 links on";

std::optional<Expected> expected(const Entry& entry, const std::string& rod) {
  static const json table = reference::read_data("chains/orders.json")["orders"];
  bool is_known = false;
  for (const json& row : table) {
    if (row["formulation"] != entry.name) continue;
    is_known = true;
    if (row["rod"] != rod) continue;
    return Expected{row["order"], row.value("tolerance", kOrderTolerance),
                    "kept of an independent prototype, 64 to 256 links; " + std::string(kTheory),
                    Oracle::independent, row.value("constant", "")};
  }
  if (is_known || kept_limit(entry, rod)) return std::nullopt;
  return Expected{expected_order(entry), kOrderTolerance, kTheory, Oracle::closed_form};
}

Draft draft_of(const Entry& entry, const std::string& rod, const char* what) {
  return finding(fmt::format("chains/{}/{}/{}", entry.name, what, rod))
      .about("chains")
      .of(std::string(entry.name), "linear_angular");
}

Finding order_of(const Entry& entry, const std::string& rod, const std::optional<Expected>& wanted) {
  const ChainOrder& found = chain_order(entry, rod);
  Draft f = draft_of(entry, rod, "order");
  f.measured(found.order,
             fmt::format("{:.4f} +- {:.1g}; error {:.3g} L at 64 links, {:.3g} L at 256", found.order,
                         found.order_bar, found.points.at(3).error(), found.points.back().error()));
  if (!wanted) return f.reported("no target: none is kept, or its chains tend to another rod");
  return f.equal(wanted->order, wanted->tolerance, wanted->why).by(wanted->oracle, found.order_bar);
}

/// Error N^p at the most links, over the one that was kept with some digits.
Finding constant_of(const Entry& entry, const std::string& rod, const Expected& wanted) {
  const ChainPoint& last = chain_order(entry, rod).points.back();
  const double power = std::round(wanted.order);
  const double kept = std::stod(wanted.constant);
  const auto digits = double(wanted.constant.size() - wanted.constant.find('.') - 1);
  const double rounded = 0.5 * std::pow(10., -digits);
  return draft_of(entry, rod, "constant")
      .measured(last.error() * std::pow(double(last.links), power))
      .in("L/N^order")
      .equal(kept, 0.02 * kept + rounded,
             "2 %: what the next order leaves at 256 links, and half of the last digit kept")
      .by(Oracle::independent, rounded);
}

/// What is left at h -> 0 once h and h^2 are removed from the last three points.
Finding limit_of(const Entry& entry, const std::string& rod) {
  const auto& points = chain_order(entry, rod).points;
  const auto miss = [&](std::size_t back) { return points.at(points.size() - back).miss; };
  const Vec3<double> coarse = 2 * miss(2) - miss(3), fine = 2 * miss(1) - miss(2);
  Draft f = draft_of(entry, rod, "limit");
  f.measured(((4 * fine - coarse) / 3).norm()).in("L");
  if (const auto kept = kept_limit(entry, rod)) {
    return f
        .within(0.8 * *kept, 1.25 * *kept,
                "the moment of a joint's force on its elongation is missing: n joints have n times as little "
                "of it, so "
                "it stays; a quarter either way of what was measured once")
        .by(Oracle::kept);
  }
  return f.at_most(1e-6, "the terms of h^3 that are left, some units times 8/256^3")
      .by(Oracle::independent, chain_rod(rod).uncertainty);
}

std::vector<Finding> orders_and_constants(const Entry& entry) {
  std::vector<Finding> out;
  for (const char* rod : kOrderRods) {
    const auto wanted = expected(entry, rod);
    out.push_back(order_of(entry, rod, wanted));
    out.push_back(limit_of(entry, rod));
    if (wanted && !wanted->constant.empty()) out.push_back(constant_of(entry, rod, *wanted));
  }
  return out;
}

}  // namespace

void chain_convergence(Checks& checks) {
  for (const Entry* entry : chain_formulations()) {
    checks.push_back({fmt::format("chains/{}/order", entry->name), "chains",
                      [entry] { return orders_and_constants(*entry); }});
  }
}

}  // namespace halfway::verify
