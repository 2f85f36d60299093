#include "reports/views/stability/basins.hpp"

#include "verify/studies/newton/basin_map.hpp"
#include "verify/studies/newton/newton_order.hpp"

#include <cmath>

namespace halfway::reports {
namespace {

using namespace reference;
using nlohmann::json;

constexpr int kEndFactor = 64;  // more than kMostBasinIterations
static_assert(kMostBasinIterations < kEndFactor);

json grids_record() {
  json out = json::array();
  for (const LoadGrid& g : load_grids()) {
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

json maps_record() {
  json out = json::array();
  for (const LoadGrid& grid : load_grids()) {
    for (const Entry& entry : formulations()) {
      for (NewtonTangent tangent : kNewtonTangents) {
        json record = map_record(load_map(entry, grid, tangent));
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
  const StartMap& map = start_map(entry, kStartMoment);
  json equilibria = json::array();
  for (const auto& e : map.equilibria)
    equilibria.push_back({{"theta", {e.theta[0], e.theta[1], e.theta[2]}}, {"cells", e.cells}});
  return {{"formulation", entry.name},    {"moment", map.moment},     {"resolution", map.resolution},
          {"has_branch", map.has_branch}, {"equilibria", equilibria}, {"cells", map.cells}};
}

json number(double x) { return std::isfinite(x) ? json(x) : json(nullptr); }

json order_record(const Entry& entry, NewtonTangent tangent) {
  const NewtonOrder& o = block_order(entry, tangent);
  const double order = tangent == NewtonTangent::analytic ? pooled_order(entry) : o.order;
  return {{"formulation", entry.name},  {"tangent", to_string(tangent)},    {"order", number(order)},
          {"factor", number(o.factor)}, {"predicted", number(o.predicted)}, {"iterations", o.iterations}};
}

}  // namespace

json stability_basins_record() {
  json tangents = json::array(), starts = json::array(), orders = json::array();
  for (NewtonTangent tangent : kNewtonTangents) tangents.push_back(to_string(tangent));
  for (const Entry& entry : formulations()) {
    starts.push_back(start_record(entry));
    for (NewtonTangent tangent : kNewtonTangents) orders.push_back(order_record(entry, tangent));
  }
  return {
      {"ends", {"continuous branch", "other equilibrium", "not converged", "singular tangent", "not finite"}},
      {"grids", grids_record()},
      {"tangents", tangents},
      {"most_iterations", kMostBasinIterations},
      {"maps", maps_record()},
      {"starts", starts},
      {"orders", orders}};
}

}  // namespace halfway::reports
