// Lines cut from bytes, and what each line is: an answer, chatter, or a broken answer whose id is still
// found.
#include "reports/check/child/child_answer.hpp"

#include <boost/test/unit_test.hpp>

using namespace halfway::check;
using Sort = Outcome::Sort;
using namespace std::string_literals;

namespace {

Reading read(const std::string& text) {
  Lines lines;
  lines.add(text + "\n");
  const auto line = lines.next();
  return line ? read_answer(*line) : Reading{};
}

}  // namespace

BOOST_TEST_DONT_PRINT_LOG_VALUE(Outcome::Sort)
BOOST_TEST_DONT_PRINT_LOG_VALUE(Lost)

BOOST_AUTO_TEST_SUITE(answers)

BOOST_AUTO_TEST_CASE(lines_from_pieces) {
  const std::string bytes = "one\r\n\n   \ntwo\nthr";
  for (std::size_t piece = 1; piece <= bytes.size(); ++piece) {
    Lines lines;
    for (std::size_t i = 0; i < bytes.size(); i += piece) lines.add(bytes.substr(i, piece));
    BOOST_TEST(lines.next()->text == "one");
    BOOST_TEST(lines.next()->text == "two");
    BOOST_TEST(!lines.next());
    BOOST_TEST(lines.rest()->text == "thr");
    BOOST_TEST(!lines.rest());
  }
}

BOOST_AUTO_TEST_CASE(long_lines_are_not_kept) {
  Lines lines;
  lines.add(std::string(kLongestLine, 'x') + "\n");
  BOOST_TEST(!lines.next()->is_too_long);
  lines.add("{\"id\":7,");
  for (int i = 0; i < 100; ++i) lines.add(std::string(kLongestLine, 'x'));
  lines.add("\nnext\n");
  const auto line = lines.next();
  BOOST_TEST(line->is_too_long);
  BOOST_TEST(line->text.size() == 4096u);
  BOOST_TEST(*read_answer(*line).id == "7");
  BOOST_TEST(lines.next()->text == "next");
}

BOOST_AUTO_TEST_CASE(good_answers) {
  const Reading answered = read(R"({"id":"p07","loads":[1,2]})");
  BOOST_TEST(answered.is_answer);
  BOOST_TEST(*answered.id == "\"p07\"");
  BOOST_TEST(answered.outcome.sort == Sort::answered);
  BOOST_TEST(answered.outcome.line["loads"][1] == 2);
  const Reading skipped = read(R"( {"skipped":"no \u001b frames","id":3.0} )");
  BOOST_TEST(*skipped.id == "3");
  BOOST_TEST(skipped.outcome.sort == Sort::skipped);
  BOOST_TEST(skipped.outcome.words == "no \\u001b frames");
  const Reading refused = read(R"({"id":3,"error":{"code":"bad","message":"no"}})");
  BOOST_TEST(refused.outcome.sort == Sort::refused);
  BOOST_TEST(refused.outcome.words == "bad: no");
  BOOST_TEST(read(R"({"id":3,"error":"no"})").outcome.words == "no");
  BOOST_TEST(read(R"({"id":3,"error":{"why":1}})").outcome.words == R"({"why":1})");
}

BOOST_AUTO_TEST_CASE(ids) {
  BOOST_TEST(*read(R"({"id":1e0})").id == *read(R"({"id":1})").id);
  BOOST_TEST(*read(R"({"id":"1"})").id != *read(R"({"id":1})").id);
  BOOST_TEST(*read(R"({"id":12345678901234567890})").id == "12345678901234567890");
  BOOST_TEST(*read(R"({"id":0.5})").id == "0.5");
  BOOST_TEST(*read(R"({"id":null})").id == "null");
  BOOST_TEST(*read(R"({"id":[[1]]})").id == "array");
}

BOOST_AUTO_TEST_CASE(chatter_is_no_answer) {
  for (const char* text :
       {"Loading", "[1,2]", "7", "\"id\"", R"(x {"id":1})", R"({"level":"info"})", "\xff\xfe"})
    BOOST_TEST(!read(text).is_answer, text);
}

BOOST_AUTO_TEST_CASE(what_is_no_json_by_name) {
  const auto words = [](const std::string& text) {
    const Reading reading = read(text);
    BOOST_TEST((reading.is_answer && reading.outcome.lost == Lost::not_json), text);
    return reading.outcome.words;
  };
  BOOST_TEST(words(R"({"id":1,"x":[1,NaN]})") == "not JSON: NaN at byte 16 is no number of JSON");
  BOOST_TEST(words(R"({"id":1,"x":[-Infinity]})") == "not JSON: -Infinity at byte 14 is no number of JSON");
  BOOST_TEST(words(R"({"id":1,"x":[-inf]})") == "not JSON: -inf at byte 14 is no number of JSON");
  BOOST_TEST(words(R"({"id":1,"note":"nan","x":nan})") == "not JSON: nan at byte 26 is no number of JSON");
  BOOST_TEST(words(R"({"id":1,"x":1e999})") ==
             "not JSON: the number 1e999 is too large for double precision");
  BOOST_TEST(words(R"({"id":1,"x":[1,2)").starts_with("not JSON: byte "));
  BOOST_TEST(words("{'id': 1}").starts_with("not JSON: byte 2: "));
  BOOST_TEST(words("{\"id\":\"\xff\"}").starts_with("not JSON: byte 8: "));
  BOOST_TEST(words(R"({"id":1,"x":)" + std::string(100000, '[')) ==
             "not JSON to be read: nested deeper than 64 levels");
}

BOOST_AUTO_TEST_CASE(id_of_what_is_broken) {
  BOOST_TEST(*read(R"({"id":"p\"3","x":NaN})").id == R"("p\"3")");
  BOOST_TEST(*read(R"({"x":NaN, "id" : 4.0})").id == "4");
  BOOST_TEST(!read(R"({"x":NaN,"id":"p)").id);
  BOOST_TEST(!read(R"({"x":NaN,"id":1)").id);  // may be 1, 10, 1.5
  BOOST_TEST(!read(R"({"x":NaN,"id")").id);
  BOOST_TEST(!read(R"({"x":NaN})").id);
}

BOOST_AUTO_TEST_CASE(nul_and_length) {
  const Reading nul = read(std::string("{\"id\":1,\"x\":\0}", 14));
  BOOST_TEST((nul.outcome.lost == Lost::nul_byte));
  BOOST_TEST(nul.outcome.words == "a NUL byte in the line, at byte 13");
  const Reading huge = read("{\"id\":1,\"x\":\"" + std::string(kLongestLine, 'x') + "\"}");
  BOOST_TEST((huge.outcome.lost == Lost::too_long));
  BOOST_TEST(huge.outcome.words == "a line of more than 1000000 bytes");
}

BOOST_AUTO_TEST_CASE(readable_in_a_message) {
  BOOST_TEST(readable("a\x1b[1m\xff\0b\n"s) == "a\\u001b[1m\xEF\xBF\xBD\\u0000b\\u000a");
  BOOST_TEST(readable("abcdef", 3) == "abc...");
}

BOOST_AUTO_TEST_SUITE_END()
