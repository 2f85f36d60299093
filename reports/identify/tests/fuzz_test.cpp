// The kept texts of `.ci/fuzz identify`, asked again, and what was found by it.
#include "reference/scene/text/document.hpp"
#include "reports/identify/read_other.hpp"
#include "reports/identify/tests/promises.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <string>

namespace reports = halfway::reports;

BOOST_AUTO_TEST_SUITE(fuzz)

BOOST_AUTO_TEST_CASE(kept_texts) {
  std::ifstream in(HALFWAY_IDENTIFY_CORPUS);
  int texts = 0;
  for (std::string line; std::getline(in, line); ++texts) {
    const std::string broken = reports::test::broken_promise(nlohmann::json::parse(line).get<std::string>());
    BOOST_TEST_CONTEXT(line.substr(0, 200)) { BOOST_TEST(broken == ""); }
  }
  BOOST_TEST(texts > 50);
}

/// What a unit or a zero compliance takes beyond doubles is refused where it stands.
BOOST_AUTO_TEST_CASE(numbers_that_overflow) {
  const auto refused_at = [](const std::string& text) {
    try {
      reports::read_data_file(text, "");
    } catch (const halfway::reference::Refusal& refusal) {
      return refusal.line;
    }
    return 0;
  };
  BOOST_TEST(refused_at("f_x [kN], u_x [m]\n1, 1\n1e307, 1\n") == 3);
  BOOST_TEST(refused_at("# sigma: f = 1e307 kN\nf_x [kN], u_x [m]\n1, 1\n") == 1);
  const std::string curve =
      R"({"inputs": {"force": [1e300, 0, 0], "moment": [0, 0, 1]}, "result": {"curves": [{"law": "a", "body": "b",
          "points": [{"factor": FACTOR, "d": [1, 0, 0], "theta": [0, 0, 0.1]}]}]}})";
  const auto with = [&](const char* factor) {
    return std::string(curve).replace(curve.find("FACTOR"), 6, factor);
  };
  BOOST_TEST(refused_at(with("1e300")) == 1);
  BOOST_TEST(refused_at(with("1")) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
