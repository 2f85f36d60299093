// The kept texts of `.ci/fuzz advise`, asked again.
#include "reports/advise/tests/promises.hpp"
#include "reports/advise/truth/read_table.hpp"
#include "reports/cli/errors.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <string>

namespace advise = halfway::advise;

BOOST_AUTO_TEST_SUITE(fuzz)

BOOST_AUTO_TEST_CASE(kept_texts) {
  std::ifstream in(HALFWAY_ADVISE_CORPUS);
  int texts = 0;
  for (std::string line; std::getline(in, line); ++texts) {
    const std::string broken =
        advise::test::broken_table_promise(nlohmann::json::parse(line).get<std::string>());
    BOOST_TEST_CONTEXT(line.substr(0, 200)) { BOOST_TEST(broken == ""); }
  }
  BOOST_TEST(texts > 50);
}

/// A head below a comment is named by its own line, a table begins as spreadsheets begin it, and neither a
/// null character nor a long line cuts or drowns what is said.
BOOST_AUTO_TEST_CASE(what_reading_it_found) {
  const auto said = [](const std::string& text) -> std::string {
    try {
      advise::read_table(text, {"theta_x"}, "f.csv");
    } catch (const halfway::reports::BadInput& refusal) {
      return refusal.what();
    }
    return "";
  };
  BOOST_TEST(said("# a note\n\nload,theta_x\n1,1\n").starts_with("f.csv: line 3: no column 'factor'"));
  BOOST_TEST(said("\xEF\xBB\xBF"
                  "factor,theta_x\n1,1\n") == "");
  BOOST_TEST(said(std::string("factor,theta_x\n1,a\0b\n", 21)).ends_with("is not a finite number"));
  BOOST_TEST(said(std::string(5000, 'x') + "\n").size() < 500);
}

BOOST_AUTO_TEST_SUITE_END()
