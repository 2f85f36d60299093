// Real programs whose lines are no answers: chatter, halves, wrong ids, floods.
#include "reports/check/tests/child_talk.hpp"

using namespace halfway;
using namespace halfway::check;
using namespace halfway::check::test;
using namespace std::string_literals;

BOOST_AUTO_TEST_SUITE(child)

BOOST_AUTO_TEST_CASE(chatter) {
  const Talk t = five("chatter");
  BOOST_TEST(t.summary() == "5 answered");
  BOOST_TEST(t.chatter.count == 15);
  BOOST_TEST(t.chatter.first.size() == 5u);
  BOOST_TEST(t.chatter.first[0] == "Loading model \"p01\" ...");
  BOOST_TEST(t.chatter.first[2] == "{\"level\": \"info\"}");
}

BOOST_AUTO_TEST_CASE(partial_line) {
  const Talk t = five("partial", "p03");
  BOOST_TEST(t.summary() == "2 answered, truncated, 2 answered");
  BOOST_TEST(t.words(3) == "truncated line: it ended with exit code 0 after {\"id\":\"p03\",\"loads\":[1,2");
}

BOOST_AUTO_TEST_CASE(line_without_end) {
  const Talk t = five("partial_hang", "p03", kShort);
  BOOST_TEST(t.summary() == "2 answered, timed out, 2 answered");
  BOOST_TEST(t.words(3) ==
             "timed out: no answer within 0.4 s; it has begun a line without ending it: "
             "{\"id\":\"p03\",\"loads\":[1,2]}");
  BOOST_TEST(talk(misbehaving("no_line_end"), requests(1)).summary() == "answered");
}

BOOST_AUTO_TEST_CASE(wrong_ids) {
  const Talk t = five("wrong_id");
  BOOST_TEST(t.summary() == "5 wrong id");
  BOOST_TEST(t.words(3) == "wrong id: asked \"p03\", the answer has \"xp03\"");
  BOOST_TEST(t.starts == 2);
  const Talk one = five("wrong_id", "p02", kShort);
  BOOST_TEST(one.summary() == "answered, wrong id, 3 answered");
  const Talk late = five("buffered_wrong_id", "", kShort);
  BOOST_TEST(late.summary() == "3 wrong id, 2 not asked");
  BOOST_TEST(late.words(1) == "wrong id: asked \"p01\", the answer has \"xp01\"");
  const Talk none = five("no_id", "p01", kShort);
  BOOST_TEST(none.summary() == "wrong id, 4 answered");
  BOOST_TEST(none.words(1) == "wrong id: asked \"p01\", the answer has no id, and says: what is hello?");
  BOOST_TEST(none.starts == 1);
  const Talk null = five("null_id", "p02", kShort);
  BOOST_TEST(null.summary() == "answered, wrong id, 3 answered");
  BOOST_TEST(null.words(2) ==
             "wrong id: asked \"p02\", the answer has null, and says: bad: cannot read this");
}

BOOST_AUTO_TEST_CASE(endless_answers_to_nothing) {
  const Talk t = five("spam", "p05", kShort);
  BOOST_TEST(t.summary() == "4 answered, timed out");
  BOOST_TEST(t.words(5) ==
             "timed out: no answer within 0.4 s; the last line that it printed: {\"id\":\"zzz\"}");
  BOOST_TEST(t.chatter.count > 1000);
}

BOOST_AUTO_TEST_CASE(duplicated_ids) {
  const Talk t = five("twice");
  BOOST_TEST(t.summary() == "5 answered");
  for (int i = 0; i < 5; ++i) BOOST_TEST(t.outcomes[i].line["n"] == i + 1);
  BOOST_TEST(t.remarks.size() == 1u);
  BOOST_TEST(t.remarks[0] == "it answers a request more than once; the first answer counts");
  // The second answer to the last one of a round comes in the next.
  Child child(misbehaving("twice"));
  child.ask(requests(1), kLong);
  usleep(50000);
  const auto next = child.ask({R"({"id":"q1"})"}, kLong);
  BOOST_TEST((next[0].sort == Sort::answered));
  BOOST_TEST(next[0].line["id"] == "q1");
}

BOOST_AUTO_TEST_CASE(reverse_order) {
  const Talk t = talk(misbehaving("reverse"), requests(40));
  BOOST_TEST(t.summary() == "40 answered");
  BOOST_TEST(t.starts == 1);
}

BOOST_AUTO_TEST_CASE(huge_line) {
  const Talk t = five("huge", "p03");
  BOOST_TEST(t.summary() == "2 answered, too long, 2 answered");
  BOOST_TEST(t.words(3) == "a line of more than 1000000 bytes");
  BOOST_TEST(t.starts == 1);
}

BOOST_AUTO_TEST_CASE(nul_byte) {
  const Talk t = five("nul", "p03");
  BOOST_TEST(t.summary() == "2 answered, NUL byte, 2 answered");
  BOOST_TEST(t.words(3) == "a NUL byte in the line, at byte 17");
}

BOOST_AUTO_TEST_CASE(not_a_number) {
  const Talk t = five("nan", "p03");
  BOOST_TEST(t.summary() == "2 answered, not JSON, 2 answered");
  BOOST_TEST(t.words(3) == "not JSON: NaN at byte 24 is no number of JSON");
  BOOST_TEST(t.starts == 1);
}

BOOST_AUTO_TEST_CASE(garbled) {
  const Talk t = five("garbled", "p03", kShort);
  BOOST_TEST(t.summary() == "2 answered, not JSON, 2 answered");
  BOOST_TEST(t.words(3).starts_with("not JSON: byte 2: "));
}

BOOST_AUTO_TEST_CASE(ten_megabytes_on_stderr) {
  const Talk t = five("stderr");
  BOOST_TEST(t.summary() == "5 answered");
  BOOST_TEST(t.starts == 1);
}

BOOST_AUTO_TEST_CASE(more_than_pipes_hold_both_ways) {
  const Talk t = talk(misbehaving("stdout"), requests(30, 300000), {.most_under_way = 100});
  BOOST_TEST(t.summary() == "30 answered");
  BOOST_TEST(t.chatter.count == 90000);
  BOOST_TEST(t.starts == 1);
}

BOOST_AUTO_TEST_SUITE_END()
