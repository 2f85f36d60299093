// The formulations that have a batch, and the code that serves each.
#pragma once

#include "halfway/batch/isa.hpp"
#include "halfway/batch/loops/job.hpp"
#include "halfway/joint/pose.hpp"

#include <iterator>
#include <span>
#include <string_view>

namespace halfway::batch::detail {

struct Entry {
  std::string_view name;
  const void* kernel;                   ///< identity of its own kernel
  const void* served[3];                ///< identity of the kernel that serves it, by kind
  const Unit* units[std::size(kIsas)];  ///< by instruction set; nullptr: not built
  bool needs_xi, needs_length;
  int compressed[3];      ///< Batch::compressed_rows(), by kind
  bool has_potential[3];  ///< by kind
};

template <class T>
constexpr Place<T> blocks(T* first, int rows) {
  return {first, 8, rows, 8};
}

/// By instruction set; nullptr: not built.
const Spreadings* spreadings(Isa isa);

/// In the order of catalog.def.
std::span<const Entry> entries();

}  // namespace halfway::batch::detail
