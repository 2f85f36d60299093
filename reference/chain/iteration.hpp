// One Newton iteration of a chain, over and over: what there is to time.
#pragma once

#include "reference/chain/chain.hpp"

#include <memory>

namespace halfway::reference::chain {

/// Tangent, elimination and substitution of a chain at rest, without loads.
class Iterating {
 public:
  /// Throws std::invalid_argument: no such formulation, or an instruction set that this machine lacks. The
  /// chain's numbers are not looked at.
  Iterating(const Chain& chain, std::optional<batch::Isa> isa);
  ~Iterating();
  void run();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace halfway::reference::chain
