// Is the advice right? Random scenes with a truth that is no spread of laws, answered and answered again by
// other roads.
#pragma once

#include "reports/advise/core/advice.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace halfway::advise {

/// A question that nobody chose: a rod (angular, or with forces), a chain or a 3D body, any stiffness ratio,
/// frames, load, rotation and tolerance; the same for the same number.
Question random_question(int number);

/// What became of one.
struct Tried {
  int number = 0;
  std::string truth;  ///< its kind
  double tolerance = 0, degrees = 0, ratio = 0;
  std::string advised;  ///< by name; "" for none
  double error = 0;     ///< of the advice, by the other road
  std::string cheaper;  ///< who would have sufficed for less than nine tenths of the cost, or where there is
                        ///< none at all
  bool is_right() const;
};

/// The advice of a question, and the same judged by another road: the truth by another integration (of a
/// chain by iteration), each candidate by its kernel in a turned frame, none left out by second-order theory.
/// @param spoil  an advice that is wrong on purpose
Tried tried(int number, const std::map<std::string, Cost>& costs,
            const std::function<void(Advice&)>& spoil = {});

/// Costs of all candidates that random questions have, counted.
std::map<std::string, Cost> trial_costs();

nlohmann::ordered_json trial_json(const std::vector<Tried>& all);

}  // namespace halfway::advise
