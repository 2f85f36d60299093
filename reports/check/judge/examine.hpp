// What a joint is, and what it does and does not do: independent findings in four levels.
#pragma once

#include "reference/programs/family_fit.hpp"
#include "reference/programs/identify.hpp"
#include "reference/programs/properties.hpp"
#include "reports/check/judge/program.hpp"

#include <functional>
#include <string>
#include <vector>

namespace halfway::check {

enum class Status { pass, fail, expected_fail, unexpected_pass, left_out };

struct Result {
  std::string id;     ///< never changes
  std::string title;  ///< what is held, in words
  std::string law;    ///< the equation
  Status status = Status::left_out;
  double value = NAN, limit = NAN;  ///< relative, unless the title says
  std::string where{};              ///< pose, axis; or why it was left out
  std::optional<Ask> at{};          ///< the worst question, in our convention
};

/// A property of single questions: its defect at one of them.
struct Single {
  const char* id;
  const char* title;
  const char* law;
  reference::Defect (*defect)(const Answerer&, const std::vector<Ask>&);
};
const std::vector<Single>& singles();

/// The questions that tell who it is; those of a joint of springs along the axes as the program takes them.
std::vector<Ask> identity_asks(const Hello& hello);
/// Questions with springs of one sort alone, for who is nobody known.
std::vector<Ask> family_asks(const Hello& hello);

/// What a relative defect may be: a hundred roundings of the program's digits.
double tolerance(const Hello& hello);

/// The joint as a program of this hello is asked: one with a memory along a road.
Answerer along_road(const Hello& hello, const Answerer& joint);

/// Generic poses with ends on both bodies, as the program can be asked.
std::vector<Ask> generic_poses(const Hello& hello, int count, double least, double largest,
                               reference::Springs springs, bool bond = false);

/// A result of this value, left out where it is NaN.
Result held(Result result, double value, double limit, const std::string& where = "");

/// Every property, asked through `joint`, which is in our convention. @param as_bond  the joint points rest
/// apart
std::vector<Result> examine(const Answerer& joint, const Hello& hello, bool as_bond);

}  // namespace halfway::check
