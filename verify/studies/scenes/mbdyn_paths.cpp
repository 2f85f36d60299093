// MBDyn's own equilibria: Table 1, and the paths of Figs. 3 and 4 in both node orders.
#include "reference/truth/data.hpp"
#include "verify/oracle/mbdyn_orders.hpp"
#include "verify/oracle/scene_access.hpp"
#include "verify/oracle/worst.hpp"

#include <fmt/format.h>

namespace halfway::verify {
namespace {

using reference::Setting;

/// Largest difference of theta over a path, rad.
Finding along(const std::string& scene_name, const MbdynOrder& order, const nlohmann::json& loads,
              const nlohmann::json& thetas, double limit, const std::string& reason) {
  Setting setting;
  setting.nodes_exchanged = order.exchanged;
  reference::Path<double> path(scene(scene_name), *reference::find_formulation(order.formulation), 0.5,
                               setting);
  Measurement worst;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const std::string at = fmt::format("load {}", loads[i].get<double>());
    if (path.advance(loads[i]).status != Status::converged)
      worst.include(std::nan(""), at + ": no equilibrium");
    int axis = 0;
    for (const char* name : {"theta_x", "theta_y", "theta_z"}) {
      worst.include(std::abs(path.output(name) - thetas[i][axis++].get<double>()),
                    fmt::format("{} at {}", name, at));
    }
  }
  return finding(fmt::format("mbdyn/{}/{}", scene_name, order.key))
      .of(order.formulation)
      .about(scene_name)
      .measured(worst)
      .in("rad")
      .at_most(limit, reason)
      .by(Oracle::other_program);
}

}  // namespace

void mbdyn_paths(Checks& checks) {
  for (const MbdynOrder& order : kMbdynOrders) {
    const std::string key = order.key;
    checks.push_back(
        {"mbdyn/c1_skewed_torque/" + key, "peers", [order, key] {
           const auto data = reference::read_data("mbdyn/table1.json").at("cases").at(key).at("theta");
           return std::vector{along("c1_skewed_torque", order, nlohmann::json::array({1.0}),
                                    nlohmann::json::array({data}), 1e-15,
                                    "MBDyn's rotations are good to its Newton tolerance of 1e-15")};
         }});
    checks.push_back({"mbdyn/c2_parallelepiped_small/" + key, "peers", [order, key] {
                        const auto data =
                            reference::read_data("mbdyn/parallelepiped_angular.json").at("fig3").at(key);
                        return std::vector{along("c2_parallelepiped_small", order, data.at("M"),
                                                 data.at("theta"), 1e-15, "as Table 1")};
                      }});
    checks.push_back(
        {"mbdyn/c3_buckling/" + key, "peers", [order, key] {
           const auto data = reference::read_data("mbdyn/parallelepiped_angular.json").at("fig4").at(key);
           return std::vector{along(
               "c3_buckling", order, data.at("M"), data.at("theta"), 1e-11,
               "MBDyn stops at a residual of 1e-12 or so, which the nearly singular tangent amplifies")};
         }});
  }
}

}  // namespace halfway::verify
