// Decimals that are kept as text, because their digits say how good they are.
#pragma once

#include <cmath>
#include <string>

namespace halfway::reference {

/// A unit of the last digit of a decimal text such as -1.25e-3: 1e-5.
inline double last_digit(const std::string& text) {
  const auto e = text.find_first_of("eE");
  const std::string mantissa = text.substr(0, e);
  const int exponent = e == std::string::npos ? 0 : std::stoi(text.substr(e + 1));
  const auto point = mantissa.find('.');
  const int decimals = point == std::string::npos ? 0 : int(mantissa.size() - point - 1);
  return std::pow(10., exponent - decimals);
}

}  // namespace halfway::reference
