#include "reports/views/stability/stability.hpp"

#include "reports/views/stability/basins.hpp"
#include "reports/views/stability/energy.hpp"
#include "reports/views/stability/kind.hpp"
#include "reports/views/stability/paths.hpp"
#include "reports/views/stability/range.hpp"
#include "verify/studies/joints/defects.hpp"

#include <iterator>

namespace halfway::reports {
namespace {

nlohmann::json defects_record() {
  nlohmann::json out = nlohmann::json::array();
  for (const verify::DefectSeries& s : verify::defect_series())
    out.push_back({{"what", s.what}, {"formulation", s.formulation}, {"x", s.phi}, {"error", s.error}});
  return out;
}

struct Part {
  const char* name;
  nlohmann::json (*record)();
};
constexpr Part kParts[] = {{"paths", stability_paths_record},   {"kind", stability_kind_record},
                           {"range", stability_range_record},   {"energy", stability_energy_record},
                           {"basins", stability_basins_record}, {"defects", defects_record}};

}  // namespace

nlohmann::json stability_record(const std::function<void(int, int, const std::string&)>& progress) {
  nlohmann::json out = nlohmann::json::object();
  int done = 0;
  for (const Part& part : kParts) {
    out[part.name] = part.record();
    progress(++done, int(std::size(kParts)), part.name);
  }
  return out;
}

}  // namespace halfway::reports
