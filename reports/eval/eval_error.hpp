// What is wrong with a request line.
#pragma once

#include <stdexcept>
#include <string>

namespace halfway::reports {

/// Answered as {"code", "message", "field"}; `field` is a path such as law.K[0], empty for the line.
struct EvalError : std::runtime_error {
  EvalError(std::string code_, const std::string& message, std::string field_)
      : std::runtime_error(message), code(std::move(code_)), field(std::move(field_)) {}
  std::string code;
  std::string field;
};

}  // namespace halfway::reports
