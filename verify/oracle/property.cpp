#include "verify/oracle/property.hpp"

namespace halfway::verify {

std::string property_name(const Entry& entry, Kind kind, const std::string& property) {
  return std::string(entry.name) + "/" + to_string(kind) + "/" + property;
}

Draft property_finding(const Entry& entry, Kind kind, const std::string& property) {
  return finding(property_name(entry, kind, property))
      .of(std::string(entry.name), to_string(kind))
      .about(property);
}

void add_property(Checks& checks, const std::string& property, std::initializer_list<Kind> kinds,
                  const std::function<Finding(const Entry&, Kind, Draft)>& measure) {
  for (const Entry& entry : reference::formulations()) {
    for (Kind kind : kinds) {
      checks.push_back(
          {property_name(entry, kind, property), "properties", [&entry, kind, property, measure] {
             return std::vector{measure(entry, kind, property_finding(entry, kind, property))};
           }});
    }
  }
}

Draft hold(Draft f, const Measurement& measured, const Band& band, Oracle oracle) {
  f.measured(measured).in("relative");
  if (band.holds()) return f.at_most(kRounding, kRoundingReason).by(oracle);
  return f
      .within(band.low, band.high,
              "known failure of this formulation, held in the band that its header keeps")
      .by(Oracle::kept);
}

}  // namespace halfway::verify
