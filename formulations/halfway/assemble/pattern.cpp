#include "halfway/assemble/pattern.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>

namespace halfway::assemble {
namespace {

using Block = std::pair<int, int>;  // stored row and column

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument("pattern: " + what); }

std::string text(long x) { return std::to_string(x); }

/// What is common to all joints of a pattern while it is built.
class Builder {
 public:
  Builder(const Form& form, std::span<const int> rows, std::span<const Nodes> joints)
      : form_(form), rows_(rows), joints_(joints) {
    if (form.unknowns != 6 && form.unknowns != 3)
      refuse("a node has 6 unknowns, or 3, its rotation, not " + text(form.unknowns));
    check_rows();
    for (std::size_t i = 0; i < joints.size(); ++i) {
      check_node(i, 'a', joints[i].a), check_node(i, 'b', joints[i].b);
    }
  }

  long row_count() const { return row_count_; }

  /// Block k of a joint as it is stored; first < 0: none.
  Block block(const Nodes& joint, int k) const {
    const int i = rows_[k < 2 ? joint.a : joint.b], j = rows_[k % 2 == 0 ? joint.a : joint.b];
    if (i == kFixed || j == kFixed || (form_.part == Part::upper && i > j)) return {-1, -1};
    return form_.layout == Layout::columns ? Block{j, i} : Block{i, j};
  }

  /// All blocks, ascending, each once.
  std::vector<Block> blocks() const {
    std::vector<Block> all;
    all.reserve(4 * joints_.size());
    for (const Nodes& joint : joints_) {
      for (int k = 0; k < 4; ++k) {
        if (const Block b = block(joint, k); b.first >= 0) all.push_back(b);
      }
    }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  /// @tparam Find  (joint, Block) -> first number and stride of a stored block
  template <class Find>
  std::vector<Place> places(const Find& find) const {
    std::vector<Place> out;
    out.reserve(joints_.size());
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const Nodes& joint = joints_[i];
      Place p{int(i), {joint.a, joint.b}, {}, {-1, -1, -1, -1}, {0, 0}};
      for (int n = 0; n < 2; ++n)
        p.row[n] = rows_[p.node[n]] == kFixed ? -1 : form_.unknowns * rows_[p.node[n]];
      for (int k = 0; k < 4; ++k) {
        const Block b = block(joint, k);
        if (b.first < 0) continue;
        const auto [number, stride] = find(i, b);
        p.block[k] = number;
        p.stride[form_.layout == Layout::columns ? k % 2 : k / 2] = stride;
      }
      out.push_back(p);
    }
    return out;
  }

 private:
  void check_rows() {
    std::unordered_map<int, std::size_t> node_of;
    for (std::size_t node = 0; node < rows_.size(); ++node) {
      const int row = rows_[node];
      if (row == kFixed) continue;
      if (row < 0) refuse("node " + text(long(node)) + " has row " + text(row) + ": 0, 1, ..., or -1, fixed");
      const auto [other, is_new] = node_of.emplace(row, node);
      if (!is_new) {
        refuse("nodes " + text(long(other->second)) + " and " + text(long(node)) + " have the same row, " +
               text(row));
      }
      row_count_ = std::max(row_count_, long(row) + 1);
    }
  }

  void check_node(std::size_t joint, char end, int node) const {
    if (node >= 0 && node < long(rows_.size())) return;
    refuse("joint " + text(long(joint)) + ": node " + end + " is " + text(node) + ", of " +
           text(long(rows_.size())) + " nodes");
  }

  const Form& form_;
  std::span<const int> rows_;
  std::span<const Nodes> joints_;
  long row_count_ = 0;
};

void check_count(long numbers) {
  if (numbers > std::numeric_limits<int>::max())
    refuse("the matrix has " + text(numbers) + " numbers, more than 2^31 - 1");
}

/// Row (column) of numbers `row` of a matrix: the place of `column` among its entries, -1: none.
int find_in(std::span<const int> start, std::span<const int> index, int row, int column) {
  const auto begin = index.begin() + start[row], end = index.begin() + start[row + 1];
  const auto it = std::lower_bound(begin, end, column);
  return it != end && *it == column ? int(it - index.begin()) : -1;
}

/// Where blocks of a given matrix are.
class Given {
 public:
  Given(const Form& form, std::span<const int> start, std::span<const int> index, long rows)
      : form_(form), start_(start), index_(index) {
    const long needed = form.layout == Layout::blocks ? rows : rows * form.unknowns;
    if (long(start.size()) <= needed) {
      refuse("the matrix has " + text(std::max(0L, long(start.size()) - 1)) + " rows, the joints need " +
             text(needed));
    }
    for (std::size_t row = 0; row + 1 < start.size(); ++row) check_row(row);
  }

  std::pair<int, int> operator()(std::size_t joint, const Block& b) const {
    const int n = form_.unknowns;
    if (form_.layout == Layout::blocks) {
      const int at = find_in(start_, index_, b.first, b.second);
      if (at < 0) missing(joint, b);
      return {n * n * at, n};
    }
    const int first = find_in(start_, index_, n * b.first, n * b.second);
    if (first < 0) missing(joint, b);
    const int stride = start_[n * b.first + 1] - start_[n * b.first];
    for (int r = 0; r < n; ++r) {
      for (int c = 0; c < n; ++c) {
        if (find_in(start_, index_, n * b.first + r, n * b.second + c) != first + r * stride + c)
          missing(joint, b);
      }
    }
    return {first, stride};
  }

 private:
  void check_row(std::size_t row) const {
    const int begin = start_[row], end = start_[row + 1];
    if (begin < 0 || end < begin || end > long(index_.size()))
      refuse("row " + text(long(row)) + " is from " + text(begin) + " to " + text(end) + " of " +
             text(long(index_.size())) + " entries");
    for (int k = begin + 1; k < end; ++k) {
      if (index_[k] <= index_[k - 1])
        refuse("row " + text(long(row)) + ": its indices do not ascend at entry " + text(k));
    }
  }

  [[noreturn]] void missing(std::size_t joint, Block b) const {
    if (form_.layout == Layout::columns) std::swap(b.first, b.second);
    refuse("joint " + text(long(joint)) + ": the matrix has no block in row " + text(b.first) + ", column " +
           text(b.second) + " of blocks, or not all rows of it have the same entries");
  }

  const Form& form_;
  std::span<const int> start_, index_;
};

/// Index arrays of blocks as those of their numbers.
void expand(int n, std::vector<int>& start, std::vector<int>& index) {
  std::vector<int> starts{0}, indices;
  starts.reserve(n * (start.size() - 1) + 1), indices.reserve(std::size_t(n) * n * index.size());
  for (std::size_t row = 0; row + 1 < start.size(); ++row) {
    for (int r = 0; r < n; ++r) {
      for (int k = start[row]; k < start[row + 1]; ++k) {
        for (int c = 0; c < n; ++c) indices.push_back(n * index[k] + c);
      }
      starts.push_back(int(indices.size()));
    }
  }
  start = std::move(starts), index = std::move(indices);
}

}  // namespace

Pattern::Pattern(const Form& form, std::span<const int> rows, std::span<const Nodes> joints)
    : form_(form), node_count_(long(rows.size())) {
  const Builder builder(form_, rows, joints);
  row_count_ = builder.row_count();
  const std::vector<Block> blocks = builder.blocks();
  const int n = form.unknowns;
  check_count(long(n) * n * long(blocks.size()));
  start_.assign(row_count_ + 1, 0);
  for (const auto& [row, column] : blocks) ++start_[row + 1], index_.push_back(column);
  for (long row = 0; row < row_count_; ++row) start_[row + 1] += start_[row];
  places_ = builder.places([&](std::size_t, const Block& b) {
    const int at = find_in(start_, index_, b.first, b.second);
    if (form_.layout == Layout::blocks) return std::pair(n * n * at, n);
    const int in_row = start_[b.first + 1] - start_[b.first];
    return std::pair(n * n * start_[b.first] + n * (at - start_[b.first]), n * in_row);
  });
  if (form.layout != Layout::blocks) expand(n, start_, index_);
}

Pattern::Pattern(const Form& form, std::span<const int> rows, std::span<const Nodes> joints,
                 std::span<const int> start, std::span<const int> index)
    : form_(form),
      node_count_(long(rows.size())),
      start_(start.begin(), start.end()),
      index_(index.begin(), index.end()) {
  const Builder builder(form_, rows, joints);
  row_count_ = builder.row_count();
  check_count(value_count());
  places_ = builder.places(Given(form_, start_, index_, row_count_));
}

long Pattern::value_count() const {
  const long each = form_.layout == Layout::blocks ? long(form_.unknowns) * form_.unknowns : 1;
  return each * long(index_.size());
}

std::vector<int> rows_of(int node_count, std::span<const int> fixed) {
  std::vector<int> rows(node_count);
  for (const int node : fixed) {
    if (node < 0 || node >= node_count)
      refuse("fixed node " + text(node) + ", of " + text(node_count) + " nodes");
    rows[node] = kFixed;
  }
  int next = 0;
  for (int& row : rows) {
    if (row != kFixed) row = next++;
  }
  return rows;
}

}  // namespace halfway::assemble
