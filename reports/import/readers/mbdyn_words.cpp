#include "reports/import/readers/mbdyn_words.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halfway::imports {
namespace {

constexpr double kUnit = 1e-3;  // how far from one a length or R R^T may be, as in scenes

/// Comments become blanks, so that lines stay what they are. Texts in quotes stay.
std::string without_comments(std::string_view text) {
  std::string out(text);
  bool quoted = false;
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (out[i] == '"') quoted = !quoted;
    if (quoted) continue;
    const std::string_view two(out.data() + i, std::min<std::size_t>(2, out.size() - i));
    const bool is_block = two == "/*";
    if (out[i] != '#' && two != "//" && !is_block) continue;
    const std::size_t found = out.find(is_block ? "*/" : "\n", i + (is_block ? 2 : 0));
    const std::size_t end = found == std::string::npos ? out.size() : found + (is_block ? 2 : 0);
    for (; i < end; ++i) {
      if (out[i] != '\n') out[i] = ' ';
    }
    --i;
  }
  return out;
}

/// A word as it grows.
struct Growing {
  std::string text;
  int line = 0;

  void add(char c, int at) {
    const bool is_blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (is_blank && (text.empty() || text.back() == ' ')) return;
    if (text.empty()) line = at;
    text += is_blank ? ' ' : c;
  }
  Source done(const std::string& key, int at) {
    Source out{text.empty() ? at : line, key, std::string(trimmed(text))};
    text.clear();
    return out;
  }
};

Mat3<double> rotation(const Source& at, const Mat3<double>& R) {
  if (!((R * R.transpose() - Mat3<double>::Identity()).cwiseAbs().maxCoeff() < kUnit) || R.determinant() < 0)
    refuse(at, "ends a matrix that is no rotation", "rows of a rotation matrix");
  return R;
}

}  // namespace

std::vector<Statement> statements_of(std::string_view text) {
  const std::string clean = without_comments(text);
  std::vector<Statement> out;
  Statement statement;
  Growing word;
  int line = 1;
  bool quoted = false;
  for (const char c : clean) {
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == ',' || c == ';')) {
      const std::string key =
          statement.empty() ? word.text.substr(0, word.text.find(':')) : statement.front().key;
      statement.push_back(word.done(std::string(trimmed(key)), line));
    } else {
      word.add(c, line);
    }
    if (!quoted && c == ';') out.push_back(std::exchange(statement, {}));
    if (c == '\n') ++line;
  }
  if (statement.empty() && !trimmed(word.text).empty()) statement.push_back(word.done("a statement", line));
  if (!statement.empty())
    refuse({statement.front().line, statement.front().key, statement.front().text}, "has no end",
           "a statement that ends with ;");
  return out;
}

const Source& Words::look(std::string_view wanted) const {
  if (!at_end()) return (*statement_)[next_];
  const Source& last = statement_->back();
  refuse({last.line, last.key, last.text}, fmt::format("ends the statement where {} is missing", wanted),
         wanted);
}

const Source& Words::take(std::string_view wanted) {
  const Source& out = look(wanted);
  ++next_;
  return out;
}

bool Words::takes(std::string_view word) {
  if (at_end() || (*statement_)[next_].text != word) return false;
  ++next_;
  return true;
}

double Words::number() { return value_of(take("a number"), *variables_); }

Eigen::VectorXd Words::numbers(int n) {
  Eigen::VectorXd out(n);
  for (int i = 0; i < n; ++i) out[i] = number();
  return out;
}

double Words::scale() { return takes("scale") ? number() : 1; }

/// A place is given on the node itself unless it says otherwise, which would need the node's own.
void Words::take_reference() {
  if (!takes("reference")) return;
  const Source& frame = take("node");
  if (frame.text != "node")
    refuse({frame.line, "reference", frame.text}, "is another frame than the node's",
           "reference, node, or none");
}

Vec3<double> Words::vector() {
  take_reference();
  if (takes("null")) return Vec3<double>::Zero();
  const Vec3<double> v = numbers(3);
  return scale() * v;
}

/// "1, X, 2, Y": the first axis is exact, the second made normal to it.
Mat3<double> Words::from_two_vectors() {
  int axes[2];
  Vec3<double> v[2];
  for (int i = 0; i < 2; ++i) {
    const Source& at = take("1, 2 or 3");
    axes[i] = at.text == "1" ? 0 : at.text == "2" ? 1 : at.text == "3" ? 2 : -1;
    if (axes[i] < 0 || (i == 1 && axes[1] == axes[0]))
      refuse(at, "is no axis, or the first one again", "1, 2 or 3; eye, matr, euler123, vector");
    v[i] = vector();
    if (!(v[i].norm() > 0) || !std::isfinite(v[i].norm()))
      refuse(last(), "ends a vector of no direction", "a vector that is not zero");
  }
  const int third = 3 - axes[0] - axes[1];
  const bool is_right = (axes[0] + 1) % 3 == axes[1];
  const Vec3<double> normal = v[0].normalized().cross(v[1].normalized());
  if (!(normal.norm() > 1e-9)) refuse(last(), "ends a vector parallel to the first", "another direction");
  Mat3<double> R;
  R.col(axes[0]) = v[0].normalized();
  R.col(third) = (is_right ? 1 : -1) * normal.normalized();
  R.col(axes[1]) = (is_right ? 1 : -1) * R.col(third).cross(R.col(axes[0]));
  return R;
}

Mat3<double> Words::orientation() {
  take_reference();
  if (takes("eye")) return Mat3<double>::Identity();
  if (takes("matr")) {
    Mat3<double> R;
    for (int i = 0; i < 3; ++i) R.row(i) = numbers(3).transpose();
    return rotation(last(), R);
  }
  if (takes("vector")) return so3::exp<double>(Vec3<double>(numbers(3)));
  if (takes("euler") || takes("euler123")) return turns({0, 1, 2}, numbers(3));
  if (takes("euler313")) return turns({2, 0, 2}, numbers(3));
  if (takes("euler321")) return turns({2, 1, 0}, numbers(3));
  return from_two_vectors();
}

Eigen::MatrixXd Words::matrix(int n) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(n, n);
  if (takes("null")) return out;
  if (takes("eye")) {
    out.setIdentity();
  } else if (takes("diag")) {
    out.diagonal() = numbers(n);
  } else if (takes("sym")) {
    for (int i = 0; i < n; ++i) {
      for (int j = i; j < n; ++j) out(i, j) = out(j, i) = number();
    }
  } else {
    takes("matr");
    for (int i = 0; i < n; ++i) out.row(i) = numbers(n).transpose();
  }
  return scale() * out;
}

}  // namespace halfway::imports
