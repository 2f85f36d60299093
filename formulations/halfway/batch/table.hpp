// A table of numbers that a batch likes: rows on cache lines, that do not collide in the cache.
#pragma once

#include "halfway/batch/batch.hpp"

#include <memory>
#include <new>

namespace halfway::batch {

template <class T>
class Table {
 public:
  /// Zeros.
  Table(int rows, long count)
      : rows_(rows),
        stride_(padded_stride<T>(count)),
        numbers_(new (kLine) T[std::size_t(rows * stride_)]()) {}

  T& operator()(int row, long i) { return numbers_[row * stride_ + i]; }
  const T& operator()(int row, long i) const { return numbers_[row * stride_ + i]; }
  int rows() const { return rows_; }
  Columns<T> columns() { return {numbers_.get(), stride_, rows_ * stride_}; }
  Columns<const T> columns() const { return {numbers_.get(), stride_, rows_ * stride_}; }

 private:
  static constexpr std::align_val_t kLine{64};
  struct Delete {
    void operator()(T* p) const { ::operator delete[](p, kLine); }
  };
  int rows_;
  long stride_;
  std::unique_ptr<T[], Delete> numbers_;
};

}  // namespace halfway::batch
