// A program under check that does one thing wrong: misbehaving MODE [ID]
// It answers {"id":ID,"n":NUMBER OF THE LINE SINCE ITS START}; with ID it misbehaves at that request alone.
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace {

std::string mode, wrong_id;
int number = 0;

/// Everything between "id": and the next comma or brace.
std::string id_of(const std::string& line) {
  const std::size_t begin = line.find("\"id\":") + 5;
  return line.substr(begin, line.find_first_of(",}", begin) - begin);
}

void print(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

void say(const std::string& text) {
  print(text);
  std::fflush(stdout);
}

std::string answer_to(const std::string& id) {
  return "{\"id\":" + id + ",\"n\":" + std::to_string(number) + "}\n";
}

void answer(const std::string& id) { say(answer_to(id)); }

void complain(const char* text) {
  std::fputs(text, stderr);
  std::fflush(stderr);
}

void die_of(int signal) {
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

[[noreturn]] void hang() {
  for (;;) pause();
}

bool read_line(std::string& line) {
  line.clear();
  for (int c; (c = std::getchar()) != EOF;) {
    if (c == '\n') return true;
    line += char(c);
  }
  return !line.empty();
}

/// Leaves a process behind that keeps standard output open.
void leave_a_child() {
  if (fork() == 0) hang();
  std::exit(0);
}

void answer_in_reverse(const std::string& id) {
  static std::vector<std::string> kept;
  kept.push_back(answer_to(id));
  if (kept.size() < 4) return;
  for (; !kept.empty(); kept.pop_back()) say(kept.back());
}

/// At the end of the input.
void answer_all(const std::string& first) {
  std::string all = answer_to(first), line;
  while (read_line(line)) {
    ++number;
    all += answer_to(id_of(line));
  }
  say(all);
}

using Doing = std::function<void(const std::string& id)>;

/// What each mode does at a request.
const std::map<std::string, Doing> kModes = {
    {"echo", answer},
    {"hang", [](const std::string&) { hang(); }},
    {"abort",
     [](const std::string&) {
       complain("first\nsecond\n\nthird\nassertion failed: x > 0\n");
       die_of(SIGABRT);
     }},
    {"segfault", [](const std::string&) { die_of(SIGSEGV); }},
    {"exit", [](const std::string&) { std::exit(3); }},
    {"leave", [](const std::string&) { std::exit(0); }},
    {"once",
     [](const std::string& id) {
       answer(id);
       std::exit(0);
     }},
    {"die_after",
     [](const std::string& id) {
       answer(id);
       complain("double free\n");
       die_of(SIGABRT);
     }},
    {"third",  // of each process, whichever it is
     [](const std::string& id) {
       if (number == 3) std::exit(4);
       answer(id);
     }},
    {"drop", [](const std::string&) {}},
    {"chatter",
     [](const std::string& id) {
       say("\n  \nLoading model " + id + " ...\n[1, 2]\n{\"level\": \"info\"}\n");
       answer(id);
     }},
    {"partial",
     [](const std::string& id) {
       say("{\"id\":" + id + ",\"loads\":[1,2");
       std::exit(0);
     }},
    {"partial_hang",
     [](const std::string& id) {
       say("{\"id\":" + id + ",\"loads\":[1,2]}");
       hang();
     }},
    {"no_line_end",
     [](const std::string& id) {
       say("{\"id\":" + id + ",\"n\":0}");
       std::exit(0);
     }},
    {"wrong_id", [](const std::string& id) { answer("\"x" + id.substr(1)); }},
    {"null_id",
     [](const std::string&) {
       say("{\"id\":null,\"error\":{\"code\":\"bad\",\"message\":\"cannot read this\"}}\n");
     }},
    {"buffered_wrong_id", [](const std::string& id) { print(answer_to("\"x" + id.substr(1))); }},
    {"no_id", [](const std::string&) { say("{\"error\":\"what is hello?\"}\n"); }},
    {"spam",
     [](const std::string&) {
       for (;;) say("{\"id\":\"zzz\"}\n");
     }},
    {"twice",
     [](const std::string& id) {
       answer(id);
       number += 100;
       answer(id);
       number -= 100;
     }},
    {"reverse", answer_in_reverse},
    {"huge",
     [](const std::string& id) { say("{\"id\":" + id + ",\"x\":\"" + std::string(2000000, 'x') + "\"}\n"); }},
    {"nul", [](const std::string& id) { say("{\"id\":" + id + ",\"x\":" + std::string(1, '\0') + "1}\n"); }},
    {"nan", [](const std::string& id) { say("{\"id\":" + id + ",\"loads\":[1,NaN]}\n"); }},
    {"garbled", [](const std::string&) { say("{'id': 5}\n"); }},
    {"stderr",
     [](const std::string& id) {
       const std::string line = std::string(99, 'e') + "\n";
       for (int i = 0; i < 100000; ++i) std::fwrite(line.data(), 1, line.size(), stderr);
       answer(id);
     }},
    {"stdout",  // more than any pipe holds, before each answer
     [](const std::string& id) {
       for (int i = 0; i < 3000; ++i) print(std::string(99, 'o') + "\n");
       answer(id);
     }},
    {"stubborn",
     [](const std::string&) {
       std::signal(SIGTERM, SIG_IGN);
       hang();
     }},
    {"slurp", answer_all},
    {"buffered", [](const std::string& id) { print(answer_to(id)); }},
    {"grandchild", [](const std::string&) { leave_a_child(); }},
    {"close",
     [](const std::string&) {
       close(STDOUT_FILENO);
       hang();
     }},
    {"skip", [](const std::string& id) { say("{\"id\":" + id + ",\"skipped\":\"no offsets\"}\n"); }},
    {"refuse",
     [](const std::string& id) {
       say("{\"id\":" + id + ",\"error\":{\"code\":\"bad_kind\",\"message\":\"unknown kind\"}}\n");
     }},
};

}  // namespace

int main(int argc, char** argv) {
  const rlimit none = {0, 0};
  setrlimit(RLIMIT_CORE, &none);
  mode = argc > 1 ? argv[1] : "echo";
  if (argc > 2) wrong_id = "\"" + std::string(argv[2]) + "\"";
  if (mode == "deaf") hang();
  if (mode == "dead") return complain("error while loading shared libraries: libx.so\n"), 127;
  if (mode == "slow_start") {
    usleep(700000);
    mode = "echo";
  }
  const auto doing = kModes.find(mode);
  if (doing == kModes.end()) return complain("no such mode\n"), 2;
  for (std::string line; read_line(line);) {
    ++number;
    const std::string id = id_of(line);
    (wrong_id.empty() || id == wrong_id ? doing->second : kModes.at("echo"))(id);
  }
}
