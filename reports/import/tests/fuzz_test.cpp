// The kept texts of .ci/fuzz, asked again.
#include "reports/import/tests/promises.hpp"
#include "reports/import/tests/support.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <fstream>

namespace halfway::imports::test {
namespace {

BOOST_AUTO_TEST_SUITE(fuzz)

BOOST_AUTO_TEST_CASE(kept_texts) {
  std::ifstream in(HALFWAY_IMPORT_CORPUS);
  int texts = 0;
  for (std::string line; std::getline(in, line); ++texts) {
    const std::string broken = broken_promise(nlohmann::json::parse(line).get<std::string>());
    BOOST_TEST_CONTEXT(line.substr(0, 200)) { BOOST_TEST(broken == ""); }
  }
  BOOST_TEST(texts > 50);
}

/// A text that breaks a promise is seen: a joint whose refusal has no line, one that is not finite.
BOOST_AUTO_TEST_CASE(samples_keep_them) {
  for (const char* name : {"drake.sdf", "opensim_new.osim", "chrono.yaml", "chrono.json",
                           "mbdyn_prestress.mbd", "mount.bus", "bushing_force.adm", "bush.bdf"})
    BOOST_TEST(broken_promise(sample(name)) == "");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace halfway::imports::test
