// The links of a chain as the sweeps want them, and what is read off them.
#pragma once

#include "reference/chain/chain.hpp"
#include "reference/chain/loops/sweep.hpp"

#include <cstdlib>
#include <memory>
#include <vector>

namespace halfway::reference::chain::detail {

using Quat = Eigen::Vector4d;  ///< w, x, y, z

Mat3<double> rotation_matrix(const Quat& q);

/// A rigid motion in the axes it starts from.
struct Arc {
  Vec3<double> x;
  Quat q;
};
/// Along the stress-free curve over the length s, m; negative: towards the root.
Arc arc(const Chain& chain, double s);

/// Memory that is written before it is read, in large pages where the system has them: a first touch of small
/// ones costs as much as half an iteration.
class Pages {
 public:
  explicit Pages(long numbers);
  double* get() const { return first_.get(); }

 private:
  struct Free {
    void operator()(double* p) const { std::free(p); }
  };
  std::unique_ptr<double, Free> first_;
};

/// Memory of a chain: 4 + 3 + 8 + 42 numbers a link, 72 more where inverses are kept. The state is the links'
/// quaternions and each joint's d in its half-way frame: relative, so that nothing cancels however long the
/// chain is; positions follow by a sum.
class State {
 public:
  /// At rest.
  explicit State(const Chain& chain, bool keep_inverses);
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  const Links& links() const { return links_; }
  /// The last link's frame, at its rear end. @param from_first  AtTip::x
  Mat3<double> last_rotation() const;
  /// The first link's rear end, half a link before the root.
  const Vec3<double>& origin() const { return origin_; }
  /// From the last link's rear end to the last node.
  Vec3<double> last_arm() const { return last_rotation() * half_.x; }
  Mat3<double> last_node() const { return last_rotation() * rotation_matrix(half_.q); }

  void save();
  void restore();
  std::vector<Node> nodes() const;

 private:
  Quat link(long j) const;
  void set_link(long j, const Quat& q);
  void rest();

  long count_;
  Arc whole_, half_;
  Vec3<double> origin_;
  std::vector<double> q_, d_, increment_, saved_;
  Pages factors_, kept_;
  Links links_;
};

}  // namespace halfway::reference::chain::detail
