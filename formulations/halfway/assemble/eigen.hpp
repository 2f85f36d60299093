// Eigen's sparse matrices as what an Assembler fills: their pattern is made once, their values are written in
// place.
#pragma once

#include "halfway/assemble/pattern.hpp"

#include <Eigen/SparseCore>

#include <algorithm>
#include <span>
#include <stdexcept>

namespace halfway::assemble {

/// The layout of an Eigen::SparseMatrix: Layout::columns unless it is declared Eigen::RowMajor.
template <int options>
constexpr Layout layout_of() {
  return (options & Eigen::RowMajorBit) != 0 ? Layout::rows : Layout::columns;
}

/// A matrix of zeros with the pattern's entries. Throws std::invalid_argument where the pattern has another
/// layout.
template <int options = Eigen::ColMajor>
Eigen::SparseMatrix<double, options> matrix_of(const Pattern& pattern) {
  if (pattern.form().layout != layout_of<options>()) {
    throw std::invalid_argument(
        "pattern: its layout is not that of the Eigen::SparseMatrix: Layout::columns, or "
        "Layout::rows with Eigen::RowMajor");
  }
  const long n = pattern.unknown_count();
  Eigen::SparseMatrix<double, options> matrix(n, n);
  matrix.resizeNonZeros(pattern.value_count());
  std::copy(pattern.start().begin(), pattern.start().end(), matrix.outerIndexPtr());
  std::copy(pattern.index().begin(), pattern.index().end(), matrix.innerIndexPtr());
  std::fill_n(matrix.valuePtr(), pattern.value_count(), 0.);
  return matrix;
}

/// Joints whose entries are among those of a larger matrix, see Pattern. Throws std::invalid_argument where
/// the matrix is not compressed.
template <int options>
Pattern pattern_within(const Eigen::SparseMatrix<double, options>& matrix, int unknowns,
                       std::span<const int> rows, std::span<const Nodes> joints, Part part = Part::whole) {
  if (!matrix.isCompressed())
    throw std::invalid_argument("pattern: the matrix is not compressed: makeCompressed()");
  const std::span<const int> start(matrix.outerIndexPtr(), std::size_t(matrix.outerSize()) + 1);
  const std::span<const int> index(matrix.innerIndexPtr(), std::size_t(matrix.nonZeros()));
  return Pattern({unknowns, layout_of<options>(), part}, rows, joints, start, index);
}

/// Its values, for Assembler.
template <int options>
std::span<double> values_of(Eigen::SparseMatrix<double, options>& matrix) {
  return {matrix.valuePtr(), std::size_t(matrix.nonZeros())};
}

}  // namespace halfway::assemble
