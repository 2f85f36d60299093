#include "verify/studies/limits/random_scene_text.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>
#include <vector>

namespace halfway::reference {
namespace {

constexpr std::array kValues = {
    "nan",     "inf",      "-inf",       "-1",    "0",  "1e400", "1e-320", "99999999999999999999",
    "\"0.1\"", "\"\"",     "[]",         "[[1]]", "{}", "true",  "0x7",    "1_000",
    "+1.5",    "\"none\"", "1979-05-27", "-0.0",  "'",  "\"\"\""};

std::size_t below(Generator& random, std::size_t count) {
  return std::size_t(random.uniform(0, double(count)));
}

std::string triple(Generator& random) {
  const Vec3<double> v = random.vector(10);
  return fmt::format("[{}, {}, {}]", v[0], v[1], v[2]);
}

std::vector<std::string> good(Generator& random) {
  const bool linear = random.uniform(0, 1) < 0.5;
  const auto positive = [&] { return random.uniform(0.1, 100); };
  const double k1 = positive(), k2 = positive(), k3 = positive();
  return {"title = \"t\"",
          "outputs = [\"theta_x\", \"theta_y\"]",
          "xis = [0.5]",
          "formulations = [\"invariant\", \"intrinsic\", \"linearized\"]",
          "[joint]",
          "kind = \"angular\"",
          "offset_a = " + triple(random),
          "frame_b = [1, 0, 0, 0]",
          "[joint.law]",
          linear ? "type = \"linear\"" : "type = \"polynomial\"",
          fmt::format("{} = [{}, {}, {}]", linear ? "compliance" : "k1", k1, k2, k3),
          "[[load]]",
          "type = \"fixed_moment\"",
          "value = " + triple(random),
          "[[load]]",
          "type = \"fixed_force\"",
          "value = " + triple(random),
          "point = " + triple(random),
          "[path]",
          fmt::format("factor_end = {}", positive()),
          "points = 3",
          "critical_axis = 2",
          "[[reference]]",
          "source = \"s\"",
          "oracle = \"printed\"",
          "factor = 0.05",
          "tolerance = 1e-6",
          "reason = \"r\"",
          "xi = 0.5",
          "[reference.values]",
          "intrinsic = { theta_x = \"0.1\" }"};
}

using Lines = std::vector<std::string>;

void lose(Generator& random, Lines& lines) { lines.erase(lines.begin() + long(below(random, lines.size()))); }
void repeat(Generator& random, Lines& lines) { lines.push_back(lines[below(random, lines.size())]); }
void exchange(Generator& random, Lines& lines) {
  const std::size_t i = below(random, lines.size()), j = below(random, lines.size());
  if (i != j) std::swap(lines[i], lines[j]);
}

/// Another value behind the '=', or instead of the first number of a list.
void revalue(Generator& random, Lines& lines) {
  std::string& line = lines[below(random, lines.size())];
  const std::string value = kValues[below(random, kValues.size())];
  const auto equals = line.find(" = "), bracket = line.find(" = [");
  if (equals == std::string::npos) return;
  const auto comma = line.find(',', equals);
  if (bracket != std::string::npos && comma != std::string::npos && random.uniform(0, 1) < 0.5)
    line.replace(bracket + 4, comma - bracket - 4, value);
  else
    line.replace(equals + 3, std::string::npos, value);
}

void scramble(Generator& random, Lines& lines) {
  std::string& line = lines[below(random, lines.size())];
  line[below(random, line.size())] = char(below(random, 256));
}

void insert(Generator& random, Lines& lines) {
  std::string& line = lines[below(random, lines.size())];
  const std::size_t at = below(random, line.size() + 1);
  line.insert(at, 1, char(32 + below(random, 95)));
}

void break_off(Generator& random, Lines& lines) {
  const std::size_t last = below(random, lines.size());
  lines.resize(last + 1);
  lines.back().resize(1 + below(random, lines.back().size()));
}

}  // namespace

std::string random_scene_text(Generator& random) {
  constexpr std::array mistakes = {lose,    repeat,   exchange, revalue,  revalue,
                                   revalue, scramble, insert,   break_off};
  Lines lines = good(random);
  const std::size_t count = 1 + below(random, 3);
  for (std::size_t i = 0; i < count; ++i) mistakes[below(random, mistakes.size())](random, lines);
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

}  // namespace halfway::reference
