#include "reports/views/stability_basins.hpp"

#include "verify/studies/limits/basin_map.hpp"
#include "verify/studies/limits/newton_order.hpp"

#include <cmath>

namespace halfway::reports {
namespace {

using namespace reference;
using nlohmann::json;

constexpr int kLoads = 31;
constexpr int kStarts = 41;
constexpr int kRuns = 7;
constexpr double kMoment = 1000;  // N m: beyond the critical moment of most laws of the block
constexpr int kEndFactor = 64;    // more than kMostBasinIterations
static_assert(kMostBasinIterations < kEndFactor);
/// Of the measured orders: small enough for every tangent to converge, rad.
const Vec3<double> kResponse{0.06, 0.05, 0.062}, kStart{0.01, -0.015, 0.008};

json grids_record(const std::vector<LoadGrid>& grids) {
  json out = json::array();
  for (const LoadGrid& g : grids) {
    out.push_back({{"name", g.name},
                   {"axes", {g.axes[0] + 1, g.axes[1] + 1}},
                   {"unit", g.is_response ? "rad" : "N m"},
                   {"largest", g.largest},
                   {"steps", g.steps},
                   {"angles", g.angles}});
  }
  return out;
}

json map_record(const LoadMap& map) {
  json cells = json::array();
  int wrapped = 0;
  for (const BasinCell& cell : map.cells) {
    cells.push_back(cell.iterations + kEndFactor * int(cell.end));
    wrapped += cell.has_wrapped;
  }
  return {{"share", map.share}, {"safe_step", map.safe_step}, {"wrapped", wrapped}, {"cells", cells}};
}

json maps_record(const std::vector<LoadGrid>& grids) {
  json out = json::array();
  for (const LoadGrid& grid : grids) {
    for (const Entry& entry : formulations()) {
      const BasinMaps maps(grid, entry);
      for (NewtonTangent tangent : kNewtonTangents) {
        json record = map_record(maps.map(tangent));
        record["grid"] = grid.name;
        record["formulation"] = entry.name;
        record["tangent"] = to_string(tangent);
        out.push_back(record);
      }
    }
  }
  return out;
}

json start_record(const Entry& entry) {
  const StartMap map = start_map(entry, NewtonTangent::analytic, kMoment, kStarts);
  json equilibria = json::array();
  for (const auto& e : map.equilibria)
    equilibria.push_back({{"theta", {e.theta[0], e.theta[1], e.theta[2]}}, {"cells", e.cells}});
  return {{"formulation", entry.name},    {"moment", kMoment},        {"resolution", map.resolution},
          {"has_branch", map.has_branch}, {"equilibria", equilibria}, {"cells", map.cells}};
}

json number(double x) { return std::isfinite(x) ? json(x) : json(nullptr); }

json order_record(const Scene& block, const Entry& entry, NewtonTangent tangent) {
  const NewtonOrder o = newton_order(block, entry, tangent, 1, kStart);
  const double order = tangent == NewtonTangent::analytic ? pooled_order(block, entry, 1, kRuns) : o.order;
  return {{"formulation", entry.name},  {"tangent", to_string(tangent)},    {"order", number(order)},
          {"factor", number(o.factor)}, {"predicted", number(o.predicted)}, {"iterations", o.iterations}};
}

}  // namespace

json stability_basins_record() {
  const std::vector<LoadGrid> grids = load_grids(kLoads);
  json tangents = json::array(), starts = json::array(), orders = json::array();
  for (NewtonTangent tangent : kNewtonTangents) tangents.push_back(to_string(tangent));
  const Scene block = block_scene(kResponse);
  for (const Entry& entry : formulations()) {
    starts.push_back(start_record(entry));
    for (NewtonTangent tangent : kNewtonTangents) orders.push_back(order_record(block, entry, tangent));
  }
  return {
      {"ends", {"continuous branch", "other equilibrium", "not converged", "singular tangent", "not finite"}},
      {"grids", grids_record(grids)},
      {"tangents", tangents},
      {"most_iterations", kMostBasinIterations},
      {"maps", maps_record(grids)},
      {"starts", starts},
      {"orders", orders}};
}

}  // namespace halfway::reports
