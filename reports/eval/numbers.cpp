#include "reports/eval/numbers.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace halfway::reports {
namespace {

constexpr std::size_t kLongest = 24;  // -2.2250738585072014e-308
constexpr int kOther = 6;             // loads of node b begin there, and derivatives by its motion
constexpr int kMost = 2 * kOther;

/// One number's digits as they were written, without its sign.
using Digits = std::string_view;

/// Writes into a memory of its own, which goes to the text in one piece.
template <int numbers>
class Writer {
 public:
  void put(char c) { *end_++ = c; }

  Digits number(double value) {
    char* const begin = end_;
    end_ = std::to_chars(begin, begin + kLongest, value).ptr;
    const std::size_t sign = *begin == '-';
    return {begin + sign, std::size_t(end_ - begin) - sign};
  }

  /// The same number again, or its opposite.
  Digits again(Digits digits, bool is_negative) {
    if (is_negative) put('-');
    char* const begin = end_;
    end_ = std::copy(digits.begin(), digits.end(), end_);
    return {begin, digits.size()};
  }

  void append_to(std::string& out) const { out.append(text_, std::size_t(end_ - text_)); }

 private:
  static constexpr std::size_t kBrackets = 2 + 2 * kMost;  // and the commas between rows
  char text_[numbers * (kLongest + 1) + kBrackets];
  char* end_ = text_;
};

/// Rows of up to 12 numbers. Loads of the nodes are often opposite, and so are their derivatives by the
/// nodes' positions: nearly half of a tangent need not be turned into digits.
template <int rows>
class Rows {
 public:
  Writer<rows * kMost> writer;

  template <class Values>
  void append(const Values& values, int i) {
    writer.put('[');
    for (int j = 0; j < int(values.cols()); ++j) {
      if (j > 0) writer.put(',');
      digits_[i][j] = entry(values, i, j);
    }
    writer.put(']');
  }

 private:
  template <class Values>
  Digits entry(const Values& values, int i, int j) {
    const double value = values(i, j), size = std::abs(value);
    if (j >= kOther && std::abs(values(i, j - kOther)) == size)
      return writer.again(digits_[i][j - kOther], std::signbit(value));
    if (i >= kOther && std::abs(values(i - kOther, j)) == size)
      return writer.again(digits_[i - kOther][j], std::signbit(value));
    return writer.number(value);
  }

  Digits digits_[rows][kMost];
};

}  // namespace

void append_number(std::string& out, double value) {
  Writer<1> writer;
  writer.number(value);
  writer.append_to(out);
}

void append_row(std::string& out, const Eigen::Ref<const Eigen::VectorXd>& values) {
  Rows<1> rows;
  rows.append(values.transpose(), 0);
  rows.writer.append_to(out);
}

void append_rows(std::string& out, const Eigen::Matrix<double, 12, 12>& values) {
  Rows<12> rows;
  rows.writer.put('[');
  for (int i = 0; i < values.rows(); ++i) {
    if (i > 0) rows.writer.put(',');
    rows.append(values, i);
  }
  rows.writer.put(']');
  rows.writer.append_to(out);
}

}  // namespace halfway::reports
