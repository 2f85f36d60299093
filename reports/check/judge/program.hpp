// Who answers: a running program, or a file of answers.
#pragma once

#include "reports/check/judge/questions.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace halfway::check {

/// What a program says of itself; what it does not say is not assumed against it.
struct Hello {
  std::string name = "a program without a name", version{};
  bool angular = true, linear_angular = true;  ///< kinds of questions that it takes
  enum class Springs { isotropic, diagonal, full } springs = Springs::full;
  double digits = 15.5;  ///< decimal, of its numbers
  bool ends = true;      ///< joint points and frames on a body that are not its own
  bool frames = true;    ///< on b, too
  bool path = false;     ///< its joint has a memory: it goes a question's `path` first
  bool tangent = false;  ///< it gives the derivative of its loads by (dx_a, w_a, dx_b, w_b)
};

/// What became of a question.
struct Said {
  std::optional<TwelveLoads> loads{};
  std::optional<Eigen::Matrix<double, 12, 12>> tangent{};  ///< where it was asked for
  bool skipped = false;                                    ///< it said that it cannot
  std::string why{};                                       ///< no loads: its reason, or what it did instead
};

class Program {
 public:
  virtual ~Program() = default;
  virtual Hello hello() = 0;
  /// @param tangent  ask for the tangent as well
  virtual std::vector<Said> ask(const std::vector<std::string>& ids, const std::vector<Ask>& asks,
                                bool tangent = false) = 0;
  /// What a report should say of it beside: chatter, restarts.
  virtual std::vector<std::string> remarks() const { return {}; }
  /// Can it be asked what no list has? A file cannot.
  virtual bool is_live() const { return true; }
  /// How a person asks it once more: a shell line, "..." for the request.
  virtual std::string repeat(const std::string& request) const = 0;
};

/// @param command  split into words, no shell    @param seconds  for each answer
/// @param fields   JSON object, merged into every request: {"formulation": "invariant"} for `halfway eval`
std::unique_ptr<Program> running_program(const std::string& command, double seconds,
                                         const std::string& fields);

/// @param file  JSON lines as a program would have answered, a hello among them or none
std::unique_ptr<Program> answered_program(const std::string& file);

/// The line that is sent. @param angular  the program takes moments alone
std::string request_line(const std::string& id, const Ask& ask, bool angular, const std::string& fields,
                         bool tangent = false);

}  // namespace halfway::check
