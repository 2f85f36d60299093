#include "reports/views/stability/stability.hpp"

#include "reports/views/parts.hpp"
#include "reports/views/stability/basins.hpp"
#include "reports/views/stability/energy.hpp"
#include "reports/views/stability/kind.hpp"
#include "reports/views/stability/paths.hpp"
#include "reports/views/stability/range.hpp"
#include "verify/studies/joints/defects.hpp"

namespace halfway::reports {
namespace {

nlohmann::json defects_record() {
  nlohmann::json out = nlohmann::json::array();
  for (const verify::DefectSeries& s : verify::defect_series())
    out.push_back({{"what", s.what}, {"formulation", s.formulation}, {"x", s.phi}, {"error", s.error}});
  return out;
}

constexpr RecordPart kParts[] = {{"paths", stability_paths_record},   {"kind", stability_kind_record},
                                 {"range", stability_range_record},   {"energy", stability_energy_record},
                                 {"basins", stability_basins_record}, {"defects", defects_record}};

}  // namespace

nlohmann::json stability_record(const std::function<void(int, int, const std::string&)>& progress) {
  return record_of(kParts, progress);
}

}  // namespace halfway::reports
