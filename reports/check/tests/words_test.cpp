// A command line as words: what `sh` makes of the same text.
#include "reports/check/child/words.hpp"
#include "reports/cli/errors.hpp"

#include <boost/test/unit_test.hpp>

#include <cstdio>

using namespace halfway;
using check::words_of;

namespace {

using Words = std::vector<std::string>;

std::string complaint(const std::string& command) {
  try {
    words_of(command);
  } catch (const reports::BadInput& e) {
    return e.what();
  }
  return "none";
}

/// What sh passes on, a word a line.
Words words_of_shell(const std::string& command) {
  std::FILE* const out = popen(("printf '%s\\n' " + command).c_str(), "r");
  Words words(1);
  for (int c; (c = std::fgetc(out)) != EOF;) {
    if (c == '\n')
      words.emplace_back();
    else
      words.back() += char(c);
  }
  pclose(out);
  words.pop_back();
  return words;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(words)

BOOST_AUTO_TEST_CASE(as_a_shell) {
  for (const char* command :
       {"a b", "  a \t b  ", "a 'b c' d", "a \"b c\" d", "a'b'\"c\"d", "a '' \"\" b", R"(a b\ c \' \" \\ \x)",
        R"('a\b' "a\b" "a\\b" "a\"b" "a\$b" "a\`b" 'a"b' "a'b")", "a\\\nb \"c\\\nd\"",
        "\xc3\xa4 '\xe2\x82\xac'"})
    BOOST_TEST(words_of(command) == words_of_shell(command), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(nothing_is_expanded) {
  BOOST_TEST(words_of("a $HOME `b` * ~ | > c; $(d) #e") ==
                 (Words{"a", "$HOME", "`b`", "*", "~", "|", ">", "c;", "$(d)", "#e"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(refused) {
  BOOST_TEST(complaint("python3 'a b") ==
             "the quote ' at character 9 of the command is never closed: python3 'a b");
  BOOST_TEST(complaint("\"a\\\"") == "the quote \" at character 1 of the command is never closed: \"a\\\"");
  BOOST_TEST(complaint("a \\") == "the command ends with a lone backslash: a \\");
  const std::string empty =
      "the command is empty; it names a program and its arguments, \"python3 adapter.py\"";
  for (const char* command : {"", " \t\n", "''", "\\\n"}) BOOST_TEST(complaint(command) == empty);
}

BOOST_AUTO_TEST_SUITE_END()
