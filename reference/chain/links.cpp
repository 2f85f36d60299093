#include "reference/chain/links.hpp"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <algorithm>
#include <new>
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

/// Of unit quaternions, of unit length: what rounding leaves of it is taken back to first order.
Quat product(const Quat& a, const Quat& b) {
  Quat q;
  q << a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
      a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
      a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
      a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1];
  return (1.5 - 0.5 * q.squaredNorm()) * q;
}

/// R(q) v, |q|^2 = 2/n.
Vec3<double> rotated(const Quat& q, double n, const Vec3<double>& v) {
  const Vec3<double> u = q.tail<3>(), t = n * u.cross(v);
  return v + q[0] * t + u.cross(t);
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

Mat3<double> rotation_matrix(const Quat& q) {
  return so3::matrix(so3::Quaternion<double>{q[0], q.tail<3>()});
}

Pages::Pages(long numbers) {
  if (numbers == 0) return;
  constexpr std::size_t kPage = std::size_t(2) << 20;
  const std::size_t bytes = numbers * sizeof(double);
  const bool large = bytes > 2 * kPage;
  const std::size_t line = large ? kPage : 64;
  first_.reset(static_cast<double*>(std::aligned_alloc(line, (bytes + line - 1) / line * line)));
  if (!first_) throw std::bad_alloc();
#ifdef __linux__
  if (large) madvise(first_.get(), bytes, MADV_HUGEPAGE);  // advice: without it nothing but time is lost
#endif
}

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
      factors_(kFactors * (count_ + 1) + 8),
      kept_(keep_inverses ? kKept * (count_ + 1) : 0) {
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
  Quat front;
  for (long j = 0; j <= count_; ++j) {
    const Quat q = link(j);
    if (j > 0) {
      const Quat between = front + (front.dot(q) < 0 ? Quat(-q) : q);
      const double* const d = d_.data() + j;
      const long s = links_.d.stride;
      x.add(rotated(link(j - 1), 2, whole_.x));
      x.add(rotated(between, 2 / between.squaredNorm(), {d[0], d[s], d[2 * s]}));
    }
    front = product(q, whole_.q);
    Sum at = x;
    at.add(rotated(q, 2, half_.x));
    const Quat turn = product(q, half_.q);
    out[j] = {{at.value()[0], at.value()[1], at.value()[2]}, {turn[0], turn[1], turn[2], turn[3]}};
  }
  return out;
}

}  // namespace halfway::reference::chain::detail
