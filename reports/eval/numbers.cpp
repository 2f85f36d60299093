#include "reports/eval/numbers.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace halfway::reports {
namespace {

constexpr std::size_t kLongest = 24;   // -2.2250738585072014e-308
constexpr std::size_t kBrackets = 40;  // and commas between rows, at most
constexpr int kOther = 6;              // loads of node b begin there, and derivatives by its motion

/// Where one number's digits are in the text, without its sign.
struct Digits {
  std::size_t begin = 0, length = 0;
};

/// Writes into room that was made for all numbers at once.
class Writer {
 public:
  Writer(std::string& out, std::size_t numbers) : out_(&out), size_(out.size()) {
    out.resize(size_ + numbers * (kLongest + 1) + kBrackets);
  }
  ~Writer() { out_->resize(size_); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  void put(char c) { (*out_)[size_++] = c; }

  Digits number(double value) {
    char* const begin = out_->data() + size_;
    char* const end = std::to_chars(begin, begin + kLongest, value).ptr;
    const std::size_t sign = *begin == '-';
    const Digits digits{size_ + sign, std::size_t(end - begin) - sign};
    size_ = std::size_t(end - out_->data());
    return digits;
  }

  /// The same number again, or its opposite.
  Digits again(const Digits& digits, bool is_negative) {
    if (is_negative) put('-');
    const char* const from = out_->data() + digits.begin;
    std::copy(from, from + digits.length, out_->data() + size_);
    size_ += digits.length;
    return {size_ - digits.length, digits.length};
  }

 private:
  std::string* out_;
  std::size_t size_;
};

/// Rows of up to 12 numbers. Loads of the nodes are often opposite, and so are their derivatives by the
/// nodes' positions: nearly half of a tangent need not be turned into digits.
template <int rows>
class Rows {
 public:
  explicit Rows(Writer& writer) : writer_(&writer) {}

  template <class Values>
  void append(const Values& values, int i) {
    writer_->put('[');
    for (int j = 0; j < int(values.cols()); ++j) {
      if (j > 0) writer_->put(',');
      digits_[i][j] = entry(values, i, j);
    }
    writer_->put(']');
  }

 private:
  template <class Values>
  Digits entry(const Values& values, int i, int j) {
    const double value = values(i, j), size = std::abs(value);
    if (j >= kOther && std::abs(values(i, j - kOther)) == size)
      return writer_->again(digits_[i][j - kOther], std::signbit(value));
    if (i >= kOther && std::abs(values(i - kOther, j)) == size)
      return writer_->again(digits_[i - kOther][j], std::signbit(value));
    return writer_->number(value);
  }

  Writer* writer_;
  Digits digits_[rows][2 * kOther];
};

}  // namespace

void append_number(std::string& out, double value) { Writer(out, 1).number(value); }

void append_row(std::string& out, const Eigen::Ref<const Eigen::VectorXd>& values) {
  Writer writer(out, std::size_t(values.size()));
  Rows<1>(writer).append(values.transpose(), 0);
}

void append_rows(std::string& out, const Eigen::Matrix<double, 12, 12>& values) {
  Writer writer(out, std::size_t(values.size()));
  Rows<12> rows(writer);
  writer.put('[');
  for (int i = 0; i < values.rows(); ++i) {
    if (i > 0) writer.put(',');
    rows.append(values, i);
  }
  writer.put(']');
}

}  // namespace halfway::reports
