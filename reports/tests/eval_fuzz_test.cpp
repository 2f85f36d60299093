// eval: mutated requests of a fixed seed; each must be answered by one valid line.
#include "reports/eval/eval_line.hpp"
#include "reports/tests/eval_support.hpp"

#include <boost/test/unit_test.hpp>

#include <random>

using namespace halfway;
using namespace halfway::reports::test;
using nlohmann::json;

namespace {

class Mutator {
 public:
  std::size_t below(std::size_t n) { return std::size_t(engine_() % n); }

  std::string mutated(std::string line) {
    const bool stays_well_formed = below(2) == 0;
    for (std::size_t i = 0, n = 1 + below(3); i < n && !line.empty(); ++i) {
      if (stays_well_formed)
        replace_number(line, below(line.size()));
      else
        change(line);
    }
    return line;
  }

 private:
  void change(std::string& line) {
    const std::size_t at = below(line.size());
    const std::size_t length = std::min(1 + below(12), line.size() - at);
    switch (below(6)) {
      case 0:
        line[at] = char(engine_());
        break;
      case 1:
        line.erase(at, length);
        break;
      case 2:
        line.insert(at, line.substr(below(line.size()), length));
        break;
      case 3:
        line.insert(at, token());
        break;
      case 4:
        line.resize(at);
        break;
      default:
        std::swap(line[at], line[below(line.size())]);
    }
  }

  /// Reaches the numerics instead of the parser.
  void replace_number(std::string& line, std::size_t from) {
    constexpr const char* kDigits = "0123456789";
    const std::size_t at = line.find_first_of(kDigits, from);
    if (at == std::string::npos) return;
    const std::size_t end = line.find_first_not_of("0123456789.eE+-", at);
    line.replace(at, end == std::string::npos ? std::string::npos : end - at, number());
  }

  std::string number() {
    static const std::vector<std::string> edge = {"0",
                                                  "-0.0",
                                                  "1",
                                                  "1e308",
                                                  "1e-320",
                                                  "1e999",
                                                  "5e-324",
                                                  "1e16",
                                                  "1.7976931348623157e308",
                                                  "-1",
                                                  "99999999999999999999999"};
    return edge[below(edge.size())];
  }

  std::string token() {
    static const std::vector<std::string> tokens = {
        "{",    "}",    "[",   "]", ",",  ":",       "\"",          "\\",         "\\u0000",      "\\ud800",
        "null", "true", "NaN", "-", "1e", "\"id\":", "\"xi\":0.5,", "[[[[[[[[[[", "\xef\xbb\xbf", "\xf0\x9f"};
    return tokens[below(tokens.size())];
  }

  std::mt19937_64 engine_{20112};
};

}  // namespace

BOOST_AUTO_TEST_SUITE(fuzz)

BOOST_AUTO_TEST_CASE(mutated_lines) {
  constexpr int kLines = 20000;
  std::vector<std::string> seeds;
  for (const auto& entry : reference::formulations()) {
    for (Kind kind : kKinds) seeds.push_back(generic_request(entry, kind).dump());
  }
  Mutator mutator;
  int answered = 0, malformed = 0, refused = 0;
  for (int i = 0; i < kLines; ++i) {
    const std::string line = mutator.mutated(seeds[mutator.below(seeds.size())]);
    const json found = answer(line);
    if (!found.contains("error")) {
      ++answered;
      continue;
    }
    const std::string code = found["error"].value("code", "");
    BOOST_TEST(code != "internal_error", line);
    BOOST_TEST(!code.empty(), line);
    (code == "malformed_json" ? malformed : refused) += 1;
  }
  BOOST_TEST_MESSAGE(answered << " answered, " << malformed << " malformed, " << refused << " refused");
  // The mutations reach all three ways through the code, or they test less than they say.
  BOOST_TEST(answered > kLines / 20);
  BOOST_TEST(malformed > kLines / 20);
  BOOST_TEST(refused > kLines / 20);
}

BOOST_AUTO_TEST_SUITE_END()
