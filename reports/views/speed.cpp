#include "reports/views/speed.hpp"

#include "bench/harness/instructions.hpp"
#include "bench/harness/published.hpp"
#include "bench/peak/bandwidth.hpp"
#include "reports/views/cheapest.hpp"

#include <cmath>

namespace halfway::bench {

static void to_json(nlohmann::json& json, const Peak& p) {
  json = {{"isa", p.isa}, {"precision", p.precision}, {"flops_per_ns", p.flops_per_ns}};
}
static void to_json(nlohmann::json& json, const Bandwidth& b) {
  json = {{"what", b.what}, {"bytes_per_ns", b.bytes_per_ns}};
}
static void to_json(nlohmann::json& json, const Published& p) {
  json = {{"program", p.program}, {"version", p.version}, {"what", p.what},    {"ns", p.ns},
          {"machine", p.machine}, {"date", p.date},       {"source", p.source}};
}
static void to_json(nlohmann::json& json, const InstructionCount& c) {
  json = {{"name", c.name}, {"instructions", c.instructions}};
}

}  // namespace halfway::bench

namespace halfway::reports {

static void to_json(nlohmann::json& json, const Target& t) {
  json = {{"name", t.name},
          {"value", t.value},
          {"limit", t.limit},
          {"comparison", t.at_least ? "at_least" : "at_most"},
          {"met", std::isfinite(t.value) && t.met()},
          {"note", t.note}};
}

nlohmann::json speed_record(const Results& results, const bench::Run& run) {
  return {{"peaks", run.peaks},
          {"bandwidth", bench::measured_bandwidths()},
          {"targets", speed_targets(run)},
          {"published", bench::published()},
          {"cheapest", cheapest(results)},
          {"instructions", bench::kept_instructions()}};
}

}  // namespace halfway::reports
