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
    "the trapezoidal and the one-sided rule: a law in the frame half-way errs at h^2, another at h; 64 to "
    "256 links "
    "leave 0.03 of the next order";

/// By the frame of the law: what the mean of both ends' frames gives, and what it does not.
std::optional<Expected> by_facts(const Entry& entry) {
  const double frame = frame_of(entry);
  if (std::isnan(frame)) return std::nullopt;
  return Expected{frame == 0.5 ? 2. : 1., kOrderTolerance, kTheory, Oracle::closed_form};
}

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
  return is_known ? std::nullopt : by_facts(entry);
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
  if (!wanted) return f.reported("no target: neither kept nor told by the frame of the law");
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

std::vector<Finding> orders_and_constants(const Entry& entry) {
  std::vector<Finding> out;
  for (const char* rod : kOrderRods) {
    const auto wanted = expected(entry, rod);
    out.push_back(order_of(entry, rod, wanted));
    if (wanted && !wanted->constant.empty()) out.push_back(constant_of(entry, rod, *wanted));
  }
  return out;
}

}  // namespace

void chain_orders(Checks& checks) {
  for (const Entry* entry : chain_formulations()) {
    checks.push_back({fmt::format("chains/{}/order", entry->name), "chains",
                      [entry] { return orders_and_constants(*entry); }});
  }
}

}  // namespace halfway::verify
