#include "reference/chain/links.hpp"

#include <algorithm>
#include <utility>

namespace halfway::reference::chain::detail {
namespace {

/// A sum that does not lose what its addends are too small for (Kahan).
class Sum {
 public:
  explicit Sum(const Vec3<double>& x) : sum_(x) {}
  void add(const Vec3<double>& x) {
    for (int c = 0; c < 3; ++c) {
      const double y = x[c] - lost_[c], next = sum_[c] + y;
      lost_[c] = (next - sum_[c]) - y;
      sum_[c] = next;
    }
  }
  const Vec3<double>& value() const { return sum_; }

 private:
  Vec3<double> sum_, lost_ = Vec3<double>::Zero();
};

Quat product(const Quat& a, const Quat& b) {
  Quat q;
  q << a[0] * b[0] - a.tail<3>().dot(b.tail<3>()),
      a[0] * b.tail<3>() + b[0] * a.tail<3>() + a.tail<3>().cross(b.tail<3>());
  return q / q.norm();
}

Quat rotation(const Vec3<double>& theta) {
  const double half = theta.norm() / 2;
  Quat q;
  q << std::cos(half), (half == 0 ? 0.5 : std::sin(half) / (2 * half)) * theta;
  return q;
}

/// Numbers a link that is past the last chunk's end may be read at.
long padded(long links) { return (links + kChunk - 1) / kChunk * kChunk + 2; }

}  // namespace

Arc arc(const Chain& chain, double s) {
  const Vec3<double> theta = s * chain.curvature;
  return {s * so3::gamma(theta).col(0), rotation(theta)};
}

State::State(const Chain& chain, bool keep_inverses)
    : count_(chain.links),
      whole_(arc(chain, chain.length / double(chain.links))),
      half_(arc(chain, chain.length / double(chain.links) / 2)),
      q_(4 * padded(count_)),
      d_(3 * padded(count_)),
      increment_(kIncrement * padded(count_)),
      factors_(new double[kFactors * (count_ + 1) + 8]),
      kept_(keep_inverses ? new double[kKept * (count_ + 1)] : nullptr) {
  const Arc back = arc(chain, -chain.length / double(chain.links) / 2);
  const auto turn = so3::quaternion(chain.root.R);
  Quat root;
  root << turn.w, turn.v;
  origin_ = chain.root.x + chain.root.R * back.x;
  links_.count = count_;
  for (int c = 0; c < 3; ++c) links_.arm[c] = whole_.x[c];
  for (int c = 0; c < 4; ++c) links_.turn[c] = whole_.q[c];
  links_.q = {q_.data(), padded(count_), long(q_.size())};
  links_.d = {d_.data(), padded(count_), long(d_.size())};
  links_.increment = increment_.data();
  links_.factors = factors_.get(), links_.kept = kept_.get();
  set_link(0, product(root, back.q));
  rest();
}

void State::rest() {
  for (long j = 1; j <= count_; ++j) set_link(j, product(link(j - 1), whole_.q));
}

Quat State::link(long j) const {
  const double* const q = q_.data() + j;
  const long s = links_.q.stride;
  return {q[0], q[s], q[2 * s], q[3 * s]};
}
void State::set_link(long j, const Quat& q) {
  for (int c = 0; c < 4; ++c) q_[c * links_.q.stride + j] = q[c];
}

Mat3<double> State::last_rotation() const { return rotation_matrix(link(count_)); }

void State::save() {
  saved_.assign(q_.begin(), q_.end());
  saved_.insert(saved_.end(), d_.begin(), d_.end());
}
void State::restore() {
  const auto middle = saved_.begin() + long(q_.size());
  std::copy(saved_.begin(), middle, q_.begin());
  std::copy(middle, saved_.end(), d_.begin());
}

std::vector<Node> State::nodes() const {
  std::vector<Node> out(count_ + 1);
  Sum x(origin_);
  for (long j = 0; j <= count_; ++j) {
    const Quat q = link(j);
    if (j > 0) {
      const Quat front = product(link(j - 1), whole_.q);
      const Quat between = front + (front.dot(q) < 0 ? Quat(-q) : q);
      const double* const d = d_.data() + j;
      x.add(rotation_matrix(link(j - 1)) * whole_.x);
      x.add(rotation_matrix(between / between.norm()) *
            Vec3<double>(d[0], d[links_.d.stride], d[2 * links_.d.stride]));
    }
    Sum at = x;
    at.add(rotation_matrix(q) * half_.x);
    const Quat turn = product(q, half_.q);
    out[j] = {{at.value()[0], at.value()[1], at.value()[2]}, {turn[0], turn[1], turn[2], turn[3]}};
  }
  return out;
}

}  // namespace halfway::reference::chain::detail
