// Real programs that die, hang or will not go, one way each.
#include "reports/check/tests/child_talk.hpp"

using namespace halfway;
using namespace halfway::check;
using namespace halfway::check::test;
using namespace std::string_literals;

BOOST_AUTO_TEST_SUITE(child)

BOOST_AUTO_TEST_CASE(echo) {
  const Talk t = talk(misbehaving("echo"), requests(1000));
  BOOST_TEST(t.summary() == "1000 answered");
  BOOST_TEST(t.outcomes[999].line["n"] == 1000);
  BOOST_TEST(t.starts == 1);
  BOOST_TEST(t.chatter.count == 0);
  BOOST_TEST(t.remarks.empty());
}

BOOST_AUTO_TEST_CASE(ids_that_are_numbers_and_several_rounds) {
  Child child(misbehaving("echo"));
  for (int round = 0; round < 3; ++round) {
    const auto outcomes = child.ask({R"({"id":1})", R"({"id":-2.5})", R"({"id":1e3})"}, kLong);
    for (const Outcome& o : outcomes) BOOST_TEST((o.sort == Sort::answered));
    BOOST_TEST(outcomes[2].line["n"] == 3 * round + 3);
  }
  BOOST_TEST(child.groups().size() == 1u);
  BOOST_CHECK_THROW(child.ask({R"({"id":1})", R"({"id":1.0})"}, kLong), std::invalid_argument);
  BOOST_CHECK_THROW(child.ask({"{\"id\":\n1}"}, kLong), std::invalid_argument);
  BOOST_CHECK_THROW(child.ask({"{}"}, kLong), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(not_there) {
  try {
    Child child(words_of("/no/such/program -x"));
    BOOST_TEST(false);
  } catch (const reports::BadInput& e) {
    BOOST_TEST(
        e.what() ==
        "cannot start /no/such/program: No such file or directory; no shell is run, the first word is a "
        "program"s);
  }
}

BOOST_AUTO_TEST_CASE(dead_at_its_start) {
  const Talk t = five("dead");
  BOOST_TEST(t.summary() == "3 crashed, 2 not asked");
  const std::string why =
      "crashed: it ended with exit code 127; its last words: error while loading shared libraries: libx.so";
  BOOST_TEST(t.words(1) == why);
  BOOST_TEST(t.words(5) == "not asked: 3 requests in a row had no answer, the last one: " + why);
}

BOOST_AUTO_TEST_CASE(hang) {
  const Talk t = five("hang", "p03", kShort);
  BOOST_TEST(t.summary() == "2 answered, timed out, 2 answered");
  BOOST_TEST(t.words(3) == "timed out: no answer within 0.4 s");
  BOOST_TEST(t.starts == 3);  // the second one shows which request it is
  BOOST_TEST(t.outcomes[4].line["n"] == 2);
  BOOST_TEST(t.remarks.size() == 1u);
  BOOST_TEST(t.remarks[0] ==
             "with 3 requests under way: timed out: no answer within 0.4 s; asked again one at a time");
}

BOOST_AUTO_TEST_CASE(hang_at_all) {
  const double seconds = seconds_of([] {
    const Talk t = talk(misbehaving("hang"), requests(100), {}, kShort);
    BOOST_TEST(t.summary() == "3 timed out, 97 not asked");
    BOOST_TEST(t.starts == 4);
  });
  BOOST_TEST(seconds < 5);
}

BOOST_AUTO_TEST_CASE(abort) {
  const Talk t = five("abort", "p03");
  BOOST_TEST(t.summary() == "2 answered, crashed, 2 answered");
  BOOST_TEST(t.words(3) ==
             "crashed: it ended by SIGABRT (Aborted); its last words: second | third | "
             "assertion failed: x > 0");
  BOOST_TEST(t.starts == 3);
}

BOOST_AUTO_TEST_CASE(segfault) {
  const Talk t = five("segfault", "p05");
  BOOST_TEST(t.summary() == "4 answered, crashed");
  BOOST_TEST(t.words(5) == "crashed: it ended by SIGSEGV (Segmentation fault)");
}

BOOST_AUTO_TEST_CASE(exit_code) {
  const Talk t = five("exit", "p01");
  BOOST_TEST(t.summary() == "crashed, 4 answered");
  BOOST_TEST(t.words(1) == "crashed: it ended with exit code 3");
}

BOOST_AUTO_TEST_CASE(exit_code_zero) {
  const Talk t = five("leave", "p02");
  BOOST_TEST(t.summary() == "answered, crashed, 3 answered");
  BOOST_TEST(t.words(2) == "crashed: it ended with exit code 0");
}

BOOST_AUTO_TEST_CASE(one_answer_for_each_start) {
  const Talk t = five("once");
  BOOST_TEST(t.summary() == "5 answered");
  BOOST_TEST(t.starts >= 5);
}

BOOST_AUTO_TEST_CASE(crash_after_the_answer) {
  const Talk t = five("die_after", "p02");
  BOOST_TEST(t.summary() == "5 answered");
  BOOST_TEST(!t.remarks.empty());
  BOOST_TEST(t.remarks[0].find("SIGABRT") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(crash_of_every_process_at_its_third_request) {
  const Talk t = talk(misbehaving("third"), requests(8));
  BOOST_TEST(t.summary() == "4 answered, crashed, 2 answered, crashed");
  BOOST_TEST(t.starts == 3);
}

BOOST_AUTO_TEST_CASE(silence_about_one) {
  const Talk t = five("drop", "p03", kShort);
  BOOST_TEST(t.summary() == "2 answered, timed out, 2 answered");
  BOOST_TEST(t.words(3) == "no answer, and it ended with exit code 0 at the end of its input");
}

BOOST_AUTO_TEST_CASE(gone_between_rounds) {
  Child child(misbehaving("die_after", "p03"));
  child.ask(requests(3), kLong);
  usleep(50000);
  const auto outcomes = child.ask({R"({"id":"q1"})", R"({"id":"q2"})", R"({"id":"q3"})"}, kLong);
  for (const Outcome& o : outcomes) BOOST_TEST((o.sort == Sort::answered));
  BOOST_TEST(child.groups().size() == 2u);
  BOOST_TEST(child.remarks().size() == 1u);
  BOOST_TEST(child.remarks()[0] ==
             "it ended by SIGABRT (Aborted) after an answer; its last words: double free");
}

BOOST_AUTO_TEST_CASE(ignores_sigterm) {
  const double seconds = seconds_of([] {
    const Talk t = five("stubborn", "p05", kShort);
    BOOST_TEST(t.summary() == "4 answered, timed out");
  });
  BOOST_TEST(seconds > 0.85);  // SIGKILL comes half a second after SIGTERM
  BOOST_TEST(seconds < 5);
}

BOOST_AUTO_TEST_CASE(never_reads) {
  const Talk t = talk(misbehaving("deaf"), requests(5, 300000), {}, kShort);
  BOOST_TEST(t.summary() == "3 timed out, 2 not asked");
  BOOST_TEST(t.words(1) == "timed out: no answer within 0.4 s; it has not read all that it was sent");
  BOOST_TEST(five("deaf", "", kShort).words(1) == t.words(1));
}

BOOST_AUTO_TEST_CASE(reads_everything_first) {
  for (const char* mode : {"slurp", "buffered"}) {
    Child child(misbehaving(mode), {.start_up = duration<double>(0)});
    for (int round = 1; round <= 2; ++round) {
      const auto outcomes = child.ask(requests(200), duration<double>(2));
      BOOST_TEST(std::ranges::all_of(outcomes, [](const Outcome& o) { return o.sort == Sort::answered; }));
      BOOST_TEST(int(child.groups().size()) == round);
    }
    if (mode == "slurp"s) {
      BOOST_TEST(child.remarks().size() == 1u);
      BOOST_TEST(child.remarks()[0] ==
                 "it answers only when its input has ended: it should flush its output after each line");
    }
  }
}

BOOST_AUTO_TEST_CASE(slow_start) {
  Child child(misbehaving("slow_start"));
  const auto outcomes = child.ask(requests(20), kShort);
  BOOST_TEST(std::ranges::all_of(outcomes, [](const Outcome& o) { return o.sort == Sort::answered; }));
  BOOST_TEST(child.groups().size() == 1u);
  BOOST_TEST(child.remarks().empty());
  BOOST_TEST(talk(misbehaving("slow_start"), requests(1), {}, kShort).summary() == "timed out");
}

BOOST_AUTO_TEST_CASE(grandchild_keeps_the_pipe) {
  const Talk t = five("grandchild", "p03");
  BOOST_TEST(t.summary() == "2 answered, crashed, 2 answered");
  BOOST_TEST(t.words(3) == "crashed: it ended with exit code 0");
}

BOOST_AUTO_TEST_CASE(closes_its_output) {
  const Talk t = five("close", "p03");
  BOOST_TEST(t.summary() == "2 answered, closed, 2 answered");
  BOOST_TEST(t.words(3) == "it closed its standard output and went on");
}

BOOST_AUTO_TEST_CASE(skips_and_refuses) {
  const Talk skips = five("skip", "p02");
  BOOST_TEST(skips.summary() == "answered, skipped, 3 answered");
  BOOST_TEST(skips.words(2) == "no offsets");
  const Talk refuses = five("refuse", "p02");
  BOOST_TEST(refuses.summary() == "answered, refused, 3 answered");
  BOOST_TEST(refuses.words(2) == "bad_kind: unknown kind");
}

BOOST_AUTO_TEST_CASE(standard_error_is_kept) {
  std::string name = std::filesystem::temp_directory_path() / "halfway_child_XXXXXX";
  close(mkstemp(name.data()));
  talk(misbehaving("abort", "p02"), requests(3), {.log = name});
  std::ifstream in(name);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::filesystem::remove(name);
  BOOST_TEST(text ==
             "first\nsecond\n\nthird\nassertion failed: x > 0\n"
             "first\nsecond\n\nthird\nassertion failed: x > 0\n");
}

BOOST_AUTO_TEST_CASE(interrupted) {
  for (const int signal : {SIGINT, SIGTERM}) {
    int ends[2];
    BOOST_REQUIRE(pipe(ends) == 0);
    const pid_t asking = fork();
    if (asking == 0) {  // a program that asks, and its caller presses Ctrl-C
      int code = 1;
      try {
        Child child(misbehaving("hang"));
        const pid_t group = child.groups()[0];
        if (::write(ends[1], &group, sizeof group) == sizeof group)
          child.ask(requests(3), duration<double>(60));
      } catch (const reports::FailedRun& e) {
        code = e.what() == "interrupted"s ? 42 : 2;
      }
      _exit(code);
    }
    pid_t group = 0;
    BOOST_REQUIRE(::read(ends[0], &group, sizeof group) == sizeof group);
    usleep(100000);
    BOOST_TEST(is_left(group));
    kill(asking, signal);
    int status = 0;
    waitpid(asking, &status, 0);
    BOOST_TEST((WIFEXITED(status) && WEXITSTATUS(status) == 42));
    BOOST_TEST(!is_left(group));
    close(ends[0]);
    close(ends[1]);
  }
}

BOOST_AUTO_TEST_CASE(descriptors_stay_ours) {
  const auto open_ones = [] {
    return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {});
  };
  const auto before = open_ones();
  five("hang", "p02", kShort);
  BOOST_TEST(open_ones() == before);
  // A second program inherits no end of the first one's pipes: the first one sees the end of its input.
  auto first = std::make_unique<Child>(misbehaving("echo"));
  Child second(misbehaving("echo"));
  const pid_t group = first->groups()[0];
  BOOST_TEST(seconds_of([&] { first.reset(); }) < 0.4);
  BOOST_TEST(!is_left(group));
  BOOST_TEST((second.ask(requests(1), kLong)[0].sort == Sort::answered));
}

BOOST_AUTO_TEST_SUITE_END()
