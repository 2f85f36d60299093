// MBDyn's input as statements of words between commas, and its vectors, orientations and matrices.
#pragma once

#include "reports/import/readers/expression.hpp"
#include "reports/import/record/frames.hpp"

namespace halfway::imports {

/// The text of a word has single blanks inside; its key is the statement's.
using Statement = std::vector<Source>;

/// Without comments; "keyword: rest" stays together in the first word.
std::vector<Statement> statements_of(std::string_view text);

/// Reads the words of a statement from left to right.
class Words {
 public:
  Words(const Statement& statement, const Variables& variables)
      : statement_(&statement), variables_(&variables) {}

  bool at_end() const { return next_ == statement_->size(); }
  /// The next word, which stays; refused at the end.
  const Source& look(std::string_view wanted) const;
  const Source& take(std::string_view wanted);
  /// Takes the next word where it is this.
  bool takes(std::string_view word);

  double number();
  Vec3<double> vector();          ///< null, or three; of the node
  Mat3<double> orientation();     ///< of the node
  Eigen::MatrixXd matrix(int n);  ///< eye, null, diag, sym or rows
  Eigen::VectorXd numbers(int n);
  const Source& last() const { return (*statement_)[next_ - 1]; }

 private:
  void take_reference();
  double scale();
  Mat3<double> from_two_vectors();

  const Statement* statement_;
  const Variables* variables_;
  std::size_t next_ = 0;
};

}  // namespace halfway::imports
