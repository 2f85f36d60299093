// What adapters of `halfway check` share: JSON lines in, one answer a line out. An adapter brings a function
// from a question to its loads.
#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace check {

/// SI units, radians; quaternions w, x, y, z.
struct Body {
  std::array<double, 3> x{};            ///< position, global axes
  std::array<double, 4> q{1, 0, 0, 0};  ///< body axes -> global axes
  std::array<double, 3> o{};            ///< joint point, body axes
  std::array<double, 4> h{1, 0, 0, 0};  ///< joint axes -> body axes
};

struct Question {
  std::string kind;
  std::vector<std::vector<double>> K;  ///< along the joint axes, translation first
  Body a, b;
};

/// What the program cannot do; the question is a good one.
struct Skipped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline Body body(const nlohmann::json& node) {
  const Body none;
  return {node.value("x", none.x), node.value("q", none.q), node.value("o", none.o), node.value("h", none.h)};
}

inline Question question(const nlohmann::json& r) {
  return {r.at("kind"), r.at("law").at("K"), body(r.at("a")), body(r.at("b"))};
}

/// Answers until the input ends. @param hello  what the program says of itself (README.md)
/// @param loads  from a Question to f_a, m_a, f_b, m_b about the bodies, global axes; may throw Skipped
template <class Loads>
void serve(const nlohmann::json& hello, const Loads& loads) {
  for (std::string line; std::getline(std::cin, line);) {
    const auto r = nlohmann::json::parse(line);
    nlohmann::json out;
    try {
      out = r.contains("hello") ? hello : nlohmann::json{{"loads", loads(question(r))}};
    } catch (const Skipped& reason) {
      out = {{"skipped", reason.what()}};
    }
    out["id"] = r.at("id");
    std::cout << out << std::endl;  // flushed
  }
}

}  // namespace check
