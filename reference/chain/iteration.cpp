#include "reference/chain/iteration.hpp"

#include "reference/chain/joints.hpp"
#include "reference/chain/links.hpp"
#include "reference/chain/sweeps.hpp"

namespace halfway::reference::chain {

struct Iterating::Parts {
  detail::State state;
  const detail::Joints joints;
  const detail::Sweeps& sweeps;
};

Iterating::Iterating(const Chain& chain, std::optional<batch::Isa> isa) {
  Settings settings;
  settings.isa = isa;
  parts_.reset(new Parts{detail::State(chain, false), detail::Joints(chain, settings),
                         detail::sweeps(batch::choose(isa))});
}
Iterating::~Iterating() = default;

void Iterating::run() {
  constexpr double kNone[6] = {};
  double largest[6];
  detail::AtTip at_tip;
  parts_->sweeps.eliminate(parts_->state.links(), parts_->joints.how(), 0, at_tip);
  parts_->sweeps.substitute(parts_->state.links(), kNone, largest);
}

}  // namespace halfway::reference::chain
