// `halfway eval` from C++: one request a line into a process, one answer a line out of it.
//   eval PROGRAM   where PROGRAM is build/release/bin/halfway
#include <cstdio>
#include <cstdlib>
#include <string>

int main(int argc, char** argv) {
  if (argc != 2) return std::fputs("usage: eval PROGRAM\n", stderr), 2;
  const std::string request =
      R"({"id": 1, "formulation": "invariant", "kind": "angular", "law": {"type": "linear", "K": [1, 10, 100]},)"
      R"( "a": {"x": [0, 0, 0], "q": [1, 0, 0, 0]}, "b": {"x": [0, 0, 0], "q": [0.8, 0.6, 0, 0]}})";
  const std::string command = "echo '" + request + "' | '" + argv[1] + "' eval";
  std::FILE* const answers = popen(command.c_str(), "r");
  if (answers == nullptr) return 1;
  for (int c = std::fgetc(answers); c != EOF; c = std::fgetc(answers)) std::putchar(c);
  return pclose(answers) == 0 ? 0 : 1;
}
