#include "verify/oracle/property.hpp"

namespace halfway::verify {

Finding property_finding(const Entry& entry, Kind kind, const std::string& property) {
  Finding f;
  f.formulation = entry.name;
  f.kind = to_string(kind);
  f.subject = property;
  f.name = f.formulation + "/" + f.kind + "/" + property;
  f.oracle = Oracle::independent;
  return f;
}

void add_property(Checks& checks, const std::string& property, std::initializer_list<Kind> kinds,
                  const std::function<Finding(const Entry&, Kind, Finding)>& measure) {
  for (const Entry& entry : reference::formulations()) {
    for (Kind kind : kinds) {
      const Finding named = property_finding(entry, kind, property);
      checks.push_back({named.name, "properties", [&entry, kind, named, measure] {
                          return std::vector<Finding>{judged(measure(entry, kind, named))};
                        }});
    }
  }
}

Finding held(Finding f, const Measurement& m, double limit, const std::string& reason,
             const std::string& unit) {
  f.value = m.value;
  f.parameter = m.where;
  f.unit = unit;
  f.high = limit;
  f.oracle = Oracle::independent;
  f.reason = reason;
  return judged(f);
}

void hold(Finding& f, const Measurement& measured, const Band& band) {
  f.value = measured.value;
  f.parameter = measured.where;
  f.unit = "relative";
  if (band.holds()) {
    f.comparison = Comparison::at_most;
    f.high = kRounding;
    f.reason = kRoundingReason;
  } else {
    f.comparison = Comparison::within;
    f.low = band.low;
    f.high = band.high;
    f.reason = "known failure of this formulation, held in the band that its header declares";
  }
}

}  // namespace halfway::verify
