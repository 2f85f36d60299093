// Numbers and texts as a TOML file has them.
#pragma once

#include <Eigen/Core>

#include <span>
#include <string>
#include <string_view>

namespace halfway::reports::toml {

/// What TOML takes: no control characters, and '?' for bytes that are no UTF-8, as of files in Latin-1.
std::string readable(std::string_view text);

/// All digits, and no -0.
std::string digits(double value);

std::string list(std::span<const double> values);

/// Of a vector.
template <class V>
std::string list_of(const V& v) {
  const Eigen::VectorXd values = v;
  return list({values.data(), std::size_t(values.size())});
}

std::string rows(const Eigen::MatrixXd& m);

/// As a TOML text.
std::string quoted(const std::string& text);

}  // namespace halfway::reports::toml
