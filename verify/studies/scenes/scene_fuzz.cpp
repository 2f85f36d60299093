// Scene files that nobody would write: mutated ones of a fixed seed and deeply nested ones. Each is read, or
// refused with file and what is allowed; nothing else may happen.
#include "verify/check.hpp"
#include "verify/oracle/temporary_scene.hpp"

#include <fmt/format.h>

#include <random>

namespace halfway::verify {
namespace {

constexpr const char* kSeed = R"(title = "seed"
formulations = ["invariant", "intrinsic"]
xis = [0.5]
[joint]
kind = "linear_angular"
offset_a = [0.25, 0, -1e-3]
frame_b = [0.8, 0, 0.6, 0]
[joint.a]
h = [[1, 0, 0], [0, 0, -1], [0, 1, 0]]
[joint.law]
type = "linear"
K = [1e5, "2 kN/cm", 3e5, 100, 200, 300]
offset = [0, "1 mm", 0, "-2 deg", 0, 0]
[[load]]
type = "fixed_force"
value = [0, 0, 1]
point = [0.5, 0, 0]
[path]
factor_end = 10
points = 20
[[reference]]
source = """a "table" of 1999"""
oracle = "printed"
factor = 1
xi = 0.5
tolerance = "digits"
reason = 'r'
[reference.values]
intrinsic = { theta_x = "0.125" }
)";

class Mutator {
 public:
  std::string mutated(std::string text) {
    for (std::size_t i = 0, n = 1 + below(3); i < n && !text.empty(); ++i)
      below(2) ? change(text) : number(text);
    return text;
  }

 private:
  std::size_t below(std::size_t n) { return std::size_t(engine_() % n); }

  void change(std::string& text) {
    static const std::string tokens[] = {"[",       "]",    "{",    "}",     ".",      "=",   "\"",
                                         "\"\"\"",  "'''",  "#",    "\n",    "[[",     "nan", "1979-05-27",
                                         "\\u0000", "\xff", "true", "a.b.c", "\x1b[2J"};
    const std::size_t at = below(text.size()), length = std::min(1 + below(12), text.size() - at);
    switch (below(5)) {
      case 0:
        text[at] = char(engine_());
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(below(text.size()), length));
        break;
      case 3:
        text.insert(at, tokens[below(std::size(tokens))]);
        break;
      default:
        text.resize(at);
    }
  }

  /// Reaches the rules instead of the parser.
  void number(std::string& text) {
    static const char* const edges[] = {"0", "-0.0", "1e308", "5e-324", "-1", "inf", "9223372036854775807"};
    const std::size_t at = text.find_first_of("0123456789", below(text.size()));
    if (at == std::string::npos) return;
    const std::size_t end = text.find_first_not_of("0123456789.e+-", at);
    text.replace(at, end == std::string::npos ? end : end - at, edges[below(std::size(edges))]);
  }

  std::mt19937_64 engine_{20112};
};

Finding judged_count(const std::string& name, int count, const std::string& worst, const std::string& why) {
  return finding(name)
      .about("scenes")
      .measured(count, worst)
      .in("files")
      .at_most(0, why)
      .by(Oracle::closed_form);
}

/// How a file was answered that is neither read nor refused as it should be; empty: well.
std::string trouble(const std::filesystem::path& file, int& accepted) {
  try {
    const std::string message = refusal(file);
    accepted += message.empty();
    const bool is_good = message.empty() || (message.starts_with("scene.toml:") &&
                                             message.find("; allowed: ") != std::string::npos);
    return is_good ? "" : message;
  } catch (const std::exception& e) {
    return fmt::format("threw: {}", e.what());
  }
}

std::vector<Finding> check_mutated() {
  constexpr int kFiles = 200;
  Mutator mutator;
  int bad = 0, accepted = 0;
  std::string worst;
  for (int i = 0; i < kFiles; ++i) {
    const TemporaryScene scene("fuzz", mutator.mutated(kSeed));
    const std::string what = trouble(scene.path(), accepted);
    bad += !what.empty();
    if (!what.empty()) worst = fmt::format("file {}: {}", i, what);
  }
  const bool reaches_both = accepted > kFiles / 20 && accepted < kFiles - kFiles / 20;
  return {
      judged_count("scenes/fuzz/mutated", bad, worst, "each file is read, or refused by name and place"),
      judged_count("scenes/fuzz/reach", !reaches_both, fmt::format("{} of {} read", accepted, kFiles),
                   "a twentieth at least is read and a twentieth refused, or the mutations test less than "
                   "they say")};
}

std::string repeated(const std::string& text, int times) {
  std::string out;
  for (int i = 0; i < times; ++i) out += text;
  return out;
}

/// The file must be refused at its second line, for its depth.
std::vector<Finding> check_deep() {
  const std::string deep[] = {
      repeated("a.", 40) + "b = 1",
      repeated("a.", 12000) + "b = 1",
      repeated("a.", 500000) + "b = 1",
      "[" + repeated("a.", 40) + "b]",
      "a = " + repeated("[", 12000),
      "a = " + repeated("{a = ", 12000),
      "a = {b = \"\"\"c\"\"\"\"\", " + repeated("a.", 12000) + "b = 1}",
      "a = " + repeated("[", 31) + "{" + repeated("a.", 20) + "b = 1}" + repeated("]", 31)};
  int bad = 0, accepted = 0;
  std::string worst;
  for (const std::string& text : deep) {
    const TemporaryScene scene("deep", "title = \"one... two.\" # a.b\n" + text + "\n");
    const std::string what = trouble(scene.path(), accepted);
    const bool is_placed = refusal(scene.path()).starts_with("scene.toml:2: ");
    bad += !what.empty() || !is_placed;
    if (!what.empty() || !is_placed) worst = text.substr(0, 40) + ": " + what + refusal(scene.path());
  }
  return {
      judged_count("scenes/refuses/deep", bad + accepted, worst, "no file is read deeper than 32 levels")};
}

}  // namespace

void scene_fuzz(Checks& checks) {
  checks.push_back({"scenes/fuzz", "scenes", check_mutated});
  checks.push_back({"scenes/refuses/deep", "scenes", check_deep});
}

}  // namespace halfway::verify
