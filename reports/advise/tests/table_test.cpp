// The report's table of cheapest sufficient models is what `advise --truth form` answers.
#include "bench/harness/flops.hpp"
#include "reports/advise/tests/support.hpp"
#include "reports/views/cheapest.hpp"

#include <boost/test/unit_test.hpp>

namespace halfway::advise {
namespace {

/// Counted flops stand for nanoseconds, so that the table is the same on every machine.
reports::Results counted_results() {
  reports::Results out;
  for (const auto& scene : reference::canonical_scenes()) {
    out.scenes.emplace_back();
    out.scenes.back().name = scene.name;
  }
  for (const auto& [name, flops] : bench::kept_flops()) {
    bench::Timing t;
    t.name = name, t.ns = flops, t.flops = flops;
    out.timings.push_back(t);
  }
  return out;
}

BOOST_AUTO_TEST_SUITE(table)

BOOST_AUTO_TEST_CASE(is_the_advice) {
  const auto rows = reports::cheapest(counted_results());
  BOOST_TEST(rows.size() == 3 * reference::canonical_scenes().size());
  for (const auto& row : rows) {
    const double tolerance = row.at("tolerance");
    BOOST_TEST_CONTEXT(row.dump()) {
      BOOST_TEST(row.at("note").get<std::string>().find("truth: in") != std::string::npos);
      if (row.at("formulation") == "") continue;
      BOOST_TEST(row.at("error").get<double>() <= tolerance);
      BOOST_TEST(row.at("ns").get<double>() > 0);
    }
  }
  // One of them asked directly; the linear analysis is timed in the table, and is out here.
  const Advice direct = advised({canonical("c4_frustum"), 1e-4, "form"});
  for (const auto& row : rows) {
    if (row.at("scene") != "c4_frustum" || row.at("tolerance") != 1e-4) continue;
    BOOST_TEST(row.at("formulation").get<std::string>() == direct.chosen()->candidate.formulation());
    BOOST_TEST(row.at("error").get<double>() == direct.chosen()->error, boost::test_tools::tolerance(1e-6));
  }
}

BOOST_AUTO_TEST_CASE(is_empty_without_timings) { BOOST_TEST(reports::cheapest({}).empty()); }

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace halfway::advise
