// eval: mutated requests of a fixed seed, and lines that libFuzzer found to go ways of their own; each must
// be answered by one valid line.
#include "reports/eval/read_fast.hpp"
#include "reports/tests/eval_promises.hpp"
#include "reports/tests/eval_support.hpp"
#include "reports/tests/scene_promises.hpp"

#include <boost/test/unit_test.hpp>

#include <fstream>
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

/// A law of curves, shifted, with units.
json curved_request(Kind kind) {
  json request = generic_request(*reference::find_formulation("invariant"), kind);
  const json axes[] = {{{"x", {-2, -1, 0, 1, 3}}, {"y", {-50, -20, 0, 20, 30}}, {"interpolation", "akima"}},
                       {{"negative", 18}, {"positive", 26}},
                       {{"k1", 20}, {"k3", 5}}};
  const std::size_t n = std::size_t(strain_count(kind));
  json law = {{"type", "per_axis"}, {"axis", json::array()}};
  for (std::size_t i = 0; i < n; ++i) law["axis"].push_back(axes[i % 3]);
  law["preload"] = std::vector<double>(n, 0.5);
  law["offset"] = {{"values", std::vector<double>(n, 0.25)}, {"unit", kind == Kind::linear ? "mm" : "deg"}};
  if (kind == Kind::linear_angular) law["offset"] = {"1 mm", 0, "1 in", "2 deg", 0, "3 mrad"};
  request["law"] = law;
  request["a"]["o"] = {"12 mm", 0, "0.1 in"};
  return request;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(fuzz)

BOOST_AUTO_TEST_CASE(curves_are_accepted) {
  for (Kind kind : kKinds)
    BOOST_TEST(!answer(curved_request(kind)).contains("error"), answer(curved_request(kind)).dump());
}

BOOST_AUTO_TEST_CASE(mutated_lines) {
  constexpr int kLines = 20000;
  std::vector<std::string> seeds;
  for (const auto& entry : reference::formulations()) {
    for (Kind kind : kKinds) {
      json request = generic_request(entry, kind);
      seeds.push_back(request.dump());
      request["poses"] = {{{"a", {{"x", {0.5, 0, 1}}}}}, {{"b", {{"q", {0.6, 0, 0.8, 0}}}}}};
      seeds.push_back(request.dump());
    }
  }
  for (Kind kind : kKinds) seeds.push_back(curved_request(kind).dump());
  Mutator mutator;
  int answered = 0, malformed = 0, refused = 0;
  for (int i = 0; i < kLines; ++i) {
    const std::string line = mutator.mutated(seeds[mutator.below(seeds.size())]);
    BOOST_TEST(broken_promise(line) == "");
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

/// Kept by .ci/fuzz.
BOOST_AUTO_TEST_CASE(kept_lines) {
  std::ifstream file(HALFWAY_FUZZ_CORPUS);
  int lines = 0;
  for (std::string line; std::getline(file, line); ++lines) BOOST_TEST(broken_promise(line) == "");
  BOOST_TEST(lines > 100);
}

/// Files of scenes, kept by `.ci/fuzz scenes`: each a JSON text.
BOOST_AUTO_TEST_CASE(kept_scenes) {
  std::ifstream file(HALFWAY_SCENES_CORPUS);
  int texts = 0;
  for (std::string line; std::getline(file, line); ++texts)
    BOOST_TEST(broken_scene_promise(json::parse(line).get<std::string>()) == "", line);
  BOOST_TEST(texts > 100);
}

/// Or all answers would be right, and late.
BOOST_AUTO_TEST_CASE(requests_are_read_by_simdjson) {
  for (const auto& entry : reference::formulations()) {
    for (Kind kind : kKinds) {
      reference::Document document;
      BOOST_TEST(reports::read_fast(generic_request(entry, kind).dump(), document));
    }
  }
}

/// What the promises are there for: each would be seen.
BOOST_AUTO_TEST_CASE(strict_where_nlohmann_is) {
  for (const char* line :
       {"{\"id\":\"\\ud83d\\ude00\"}", "{\"\\u0000\":[1E+2,-0,0.0e-0,1e-400]}", "\xEF\xBB\xBF{}",
        "{\"id\":\"\xF4\x8F\xBF\xBF\xEF\xBF\xBF\x7F\"}", " {\t\"a\" : [ ] , \"b\":{ }\r} "}) {
    BOOST_TEST(broken_promise(line) == "");
    BOOST_TEST(answer(std::string(line))["error"].value("code", "") != "malformed_json", line);
  }
  for (const char* line : {"{\"a\":01}",
                           "{\"a\":-}",
                           "{\"a\":1.}",
                           "{\"a\":1.e5}",
                           "{\"a\":.5}",
                           "{\"a\":1e}",
                           "{\"a\":1e+}",
                           "{\"a\":+1}",
                           "{\"a\":-inf}",
                           "{\"a\":nan}",
                           "{\"a\":0x1p3}",
                           "{\"a\":1,}",
                           "{\"a\":[1,]}",
                           "{\"a\":[,1]}",
                           "{\"a\" 1}",
                           "{a:1}",
                           "{\"a\":tru}",
                           "{\"a\":truee}",
                           "{\"a\":\"\\x\"}",
                           "{\"a\":\"\\u12g4\"}",
                           "{\"a\":\"\\ud800\"}",
                           "{\"a\":\"\\ude00\"}",
                           "{\"a\":\"\\ud800\\u0041\"}",
                           "{\"a\":\"\xC0\x80\"}",
                           "{\"a\":\"\xED\xA0\x80\"}",
                           "{\"a\":\"\xF4\x90\x80\x80\"}",
                           "{\"a\":\"\xE2\x82\"}",
                           "{\"a\":\"\t\"}",
                           "{\"a\":\"",
                           "{\"a\":\"\\",
                           "{\"a\":1}}",
                           "{\"a\":1} x"}) {
    BOOST_TEST(broken_promise(line) == "");
    BOOST_TEST(answer(std::string(line))["error"].value("code", "") == "malformed_json", line);
  }
}

BOOST_AUTO_TEST_SUITE_END()
