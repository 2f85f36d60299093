// MBDyn's paths of Fig. 4, through buckling and beyond, by arc length in both node orders.
#include "reference/solve/paths/continuation_load_steps.hpp"
#include "reference/truth/data.hpp"
#include "verify/oracle/mbdyn_orders.hpp"
#include "verify/oracle/scene_access.hpp"
#include "verify/oracle/worst.hpp"

#include <fmt/format.h>

#include <iterator>

namespace halfway::verify {
namespace {

using reference::Continuation;
using reference::ContinuationOptions;
using reference::Entry;
using reference::EquilibriumPath;

constexpr const char* kScene = "c3_buckling";

/// Largest turn between MBDyn's state and the path, over all loads.
std::vector<Finding> against_mbdyn(const MbdynOrder& order) {
  reference::Setting setting;
  setting.nodes_exchanged = order.exchanged;
  ContinuationOptions options;
  options.end_factor = scene(kScene).factor_end;
  const Entry& entry = *reference::find_formulation(order.formulation);
  const Continuation continuation(scene(kScene), entry, entry.probe_xi, options, setting);
  const EquilibriumPath path = continuation.from_rest();
  const auto data = reference::read_data("mbdyn/parallelepiped_angular.json").at("fig4").at(order.key);
  Measurement worst;
  for (std::size_t i = 0; i < data.at("M").size(); ++i) {
    const auto theta = data.at("theta")[i].get<std::vector<double>>();
    const Pose<double> node{{}, so3::exp<double>({theta[0], theta[1], theta[2]})};
    const reference::ArcState<double> theirs{continuation.problem().joint(node),
                                             data.at("M")[i].get<double>()};
    worst.include(distance_off_path(continuation, path, theirs), fmt::format("{} N m", theirs.factor));
  }
  return {
      finding(fmt::format("mbdyn/c3_arc_length/{}{}", order.formulation, order.exchanged ? "_exchanged" : ""))
          .of(order.formulation)
          .about(kScene)
          .measured(worst.value(), fmt::format("{}, of {} loads", worst.where(), data.at("M").size()))
          .in("rad")
          .at_most(1e-11,
                   "MBDyn stops at a residual of 1e-12 or so, which the nearly singular tangent amplifies")
          .by(Oracle::other_program)};
}

}  // namespace

void continuation_mbdyn(Checks& checks) {
  std::vector<MbdynOrder> orders(std::begin(kMbdynOrders), std::end(kMbdynOrders));
  orders.push_back({"att_ng", "attached_b", false});  // exchanged nodes by the other law
  for (const MbdynOrder& order : orders) {
    checks.push_back(
        {fmt::format("mbdyn/c3_arc_length/{}{}", order.formulation, order.exchanged ? "_exchanged" : ""),
         "stability", [order] { return against_mbdyn(order); }});
  }
}

}  // namespace halfway::verify
