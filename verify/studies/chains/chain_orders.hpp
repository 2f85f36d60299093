// How fast chains tend to the rod: errors of the tip against the number of links, computed once.
#pragma once

#include "verify/studies/chains/chain_rods.hpp"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace halfway::verify {

/// One chain; NaN where it was not solved.
struct ChainPoint {
  long links = 0;
  Vec3<double> miss =
      Vec3<double>::Constant(std::numeric_limits<double>::quiet_NaN());  ///< tip - rod's, over L
  int iterations = 0;
  double seconds = 0;  ///< of this thread, of the whole solution
  double error() const { return miss.norm(); }
};

/// Of one formulation and one rod, N = 8, 16 ... 256.
struct ChainOrder {
  std::vector<ChainPoint> points;
  double order = 0;      ///< of the last doubling
  double order_bar = 0;  ///< its change from the doubling before, and what the rod's digits leave open
};

/// @param order  which node of a joint is its node a
ChainOrder orders_of(const reference::Entry& entry, const ChainRod& rod, reference::chain::NodeOrder order);

/// The same of a rod's name, root first, computed once.
const ChainOrder& chain_order(const reference::Entry& entry, const std::string& rod);

/// Order and bar from the last three points.
void fit_order(const ChainRod& rod, ChainOrder& out);

/// What the facts of a formulation leave to expect: 2 where its moment is that of a rod to second order,
/// else 1.
double expected_order(const reference::Entry& entry);

/// How far the chains of a formulation stay from the rod however many links they have, over L, as kept;
/// nothing of those that tend to it.
std::optional<double> kept_limit(const reference::Entry& entry, const std::string& rod);

/// Processor time of this thread, s.
double thread_seconds();

/// Formulations whose chains are solved, those with a batch.
std::vector<const reference::Entry*> chain_formulations();

}  // namespace halfway::verify
