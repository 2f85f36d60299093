#include "bench/questions/batch/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace halfway::bench {
namespace {

using batch::Output;

batch::Model model_of(const BatchProblem& p) {
  return {p.formulation, p.in->spec.kind,   batch::LawForm::linear,
          p.in->spec.xi, p.in->spec.length, p.in->spec.axis};
}

template <class T>
batch::BatchEnd<T> end_of(const JointEnd<double>& e) {
  const auto q = so3::quaternion<double>(e.H);
  return {{T(e.o[0]), T(e.o[1]), T(e.o[2])}, {T(q.w), T(q.v[0]), T(q.v[1]), T(q.v[2])}};
}

template <class T>
const batch::Table<T>& constant(const batch::Table<T>& t) {
  return t;
}

/// Number k of the direction of joint i: anything but zero or symmetric.
double direction(int row, long i) { return std::sin(1.0 + 7.0 * row + double(i % kPoses)); }

const char* what(Output output) {
  switch (output) {
    case Output::residual:
      return "residual";
    case Output::tangent:
      return "residual_tangent";
    case Output::tangent_144:
      return "residual_tangent_144";
    case Output::compressed:
      return "residual_compressed";
    default:
      return "product";
  }
}

/// Every fourth pose: half a second of 50 digits a case is too long for so many cases.
constexpr int kChecked = 4;

Inputs some_of(const Inputs& in, long joints) {
  Inputs out{in.spec, {}, {}, {}, {}};
  for (long i = 0; i < std::min<long>(joints, kPoses); i += kChecked) {
    out.qa.push_back(in.qa[i]), out.qb.push_back(in.qb[i]);
    out.a.push_back(in.a[i]), out.b.push_back(in.b[i]);
  }
  return out;
}

template <class T>
Checked check(const BatchProblem& p) {
  const BatchData<T> data(p);
  data.evaluate();
  if (p.output == Output::compressed) data.expand();
  std::vector<Evaluated> values;
  for (long i = 0; i < std::min<long>(p.joints, kPoses); i += kChecked) values.push_back(data.at(i));
  const Tolerance tolerance{.eps = double(std::numeric_limits<T>::epsilon())};
  Checked out = compare(p.formulation, some_of(*p.in, p.joints), values, Given::quaternions, tolerance);
  for (long i = kPoses; i < p.joints && out.message.empty(); ++i) {
    if (!data.same(i, i % kPoses))
      out.message = fmt::format("joint {} differs from {}, its equal", i, i % kPoses);
  }
  if (p.output != Output::product || !out.message.empty()) return out;
  // The tangent is checked at 50 digits, the product against it.
  BatchProblem with_tangent = p;
  with_tangent.output = Output::tangent;
  out = check<T>(with_tangent);
  const BatchData<T> tangent(with_tangent);
  tangent.evaluate();
  const double error = data.product_error(tangent, std::min<long>(p.joints, kPoses));
  reference::keep_largest(out.error, error);
  if (!(error < 64 * tolerance.eps)) out.message = fmt::format("J v is off by {:.1e} of the tangent", error);
  return out;
}

}  // namespace

template <class T>
BatchData<T>::BatchData(const BatchProblem& p)
    : batch_(model_of(p), p.isa),
      output_(p.output),
      options_(p.options),
      q_a_(4, p.joints),
      q_b_(4, p.joints),
      x_a_(3, p.joints),
      x_b_(3, p.joints),
      law_(batch::law_rows(p.in->spec.kind, batch::LawForm::linear), 1),
      direction_(p.output == Output::product ? batch::direction_rows(p.in->spec.kind) : 1, p.joints),
      loads_(batch::load_rows(p.in->spec.kind), p.joints),
      tangent_(std::max(1, batch::tangent_rows(p.in->spec.kind, p.output)), p.joints),
      expanded_(p.output == Output::compressed ? batch::tangent_rows(p.in->spec.kind, Output::tangent) : 1,
                p.output == Output::compressed ? p.joints : 1),
      a_(end_of<T>(p.in->spec.a)),
      b_(end_of<T>(p.in->spec.b)) {
  for (long i = 0; i < p.joints; ++i) {
    const auto &a = p.in->qa[i % kPoses], &b = p.in->qb[i % kPoses];
    for (int c = 0; c < 4; ++c) q_a_(c, i) = T(a.q[c]), q_b_(c, i) = T(b.q[c]);
    for (int c = 0; c < 3; ++c) x_a_(c, i) = T(a.x[c]), x_b_(c, i) = T(b.x[c]);
    if (p.output != Output::product) continue;
    for (int c = 0; c < direction_.rows(); ++c) direction_(c, i) = T(direction(c, i));
  }
  const Eigen::MatrixXd& K = std::get<reference::LinearSpec>(p.in->spec.law).matrix;
  int row = 0;
  for (int r = 0; r < K.rows(); ++r) {
    for (int c = r; c < K.cols(); ++c) law_(row++, 0) = T(K(r, c));
  }
  joints_.count = p.joints;
  joints_.q_a = constant(q_a_).columns(), joints_.q_b = constant(q_b_).columns();
  joints_.x_a = constant(x_a_).columns(), joints_.x_b = constant(x_b_).columns();
  joints_.law = constant(law_).columns(), joints_.direction = constant(direction_).columns();
  if (p.ends) joints_.a = &a_, joints_.b = &b_;
  results_ = {loads_.columns(), tangent_.columns()};
}

template <class T>
void BatchData<T>::expand() const {
  if constexpr (std::is_same_v<T, double>)
    batch_.expand(joints_, results_, expanded_.columns(), Output::tangent);
}

template <class T>
Evaluated BatchData<T>::at(long i) const {
  const auto loads = [&](int row) {
    return Eigen::Vector3d(loads_(row, i), loads_(row + 1, i), loads_(row + 2, i));
  };
  const auto matrix = [&](int row) {
    Eigen::Matrix3d m;
    const auto& from = output_ == Output::compressed ? expanded_ : tangent_;
    for (int k = 0; k < 9; ++k) m(k / 3, k % 3) = double(from(row + k, i));
    return m;
  };
  Evaluated out;
  const bool with_tangent = output_ != Output::residual && output_ != Output::product;
  if (batch_.model().kind == Kind::angular) {
    out.loads = loads(0);
    if (with_tangent) {
      out.tangent.resize(3, 6);
      out.tangent << matrix(0), matrix(9);
    }
    return out;
  }
  out.loads.resize(12);
  out.loads << -loads(0), loads(3), loads(0), loads(6);
  if (!with_tangent) return out;
  out.tangent.resize(12, 12);
  if (output_ == Output::tangent_144) {
    for (int k = 0; k < 144; ++k) out.tangent(k / 12, k % 12) = double(tangent_(k, i));
    return out;
  }
  for (const auto& [row, first] : {std::pair{6, 0}, {3, 27}, {9, 54}}) {
    out.tangent.middleRows<3>(row) << -matrix(first), matrix(first + 9), matrix(first), matrix(first + 18);
  }
  out.tangent.topRows<3>() = -out.tangent.middleRows<3>(6);
  return out;
}

template <class T>
double BatchData<T>::product_error(const BatchData& with_tangent, long joints) const {
  const bool angular = batch_.model().kind == Kind::angular;
  reference::Measurement worst;
  for (long i = 0; i < joints; ++i) {
    const Eigen::MatrixXd J = with_tangent.at(i).tangent;
    Eigen::VectorXd v(J.cols());
    for (int c = 0; c < v.size(); ++c) v[c] = double(direction_(c, i));
    const Eigen::VectorXd Jv = J * v;
    const int rows[] = {angular ? 0 : 6, 3, 9};
    for (int k = 0; k < loads_.rows(); ++k) {
      worst.include(
          std::abs(Jv[rows[k / 3] + k % 3] - double(tangent_(k, i))) / reference::largest_entry<double>(J),
          {});
    }
  }
  return worst.value();
}

template <class T>
bool BatchData<T>::same(long i, long j) const {
  for (const batch::Table<T>* t : {&loads_, output_ == Output::compressed ? &expanded_ : &tangent_}) {
    for (int row = 0; row < t->rows(); ++row) {
      if ((*t)(row, i) != (*t)(row, j)) return false;
    }
  }
  return true;
}

template <class T>
bool can_run(const BatchProblem& p) {
  if (!batch::available(p.isa)) return false;
  const batch::Batch batch(model_of(p), p.isa);
  return batch.has<T>(p.output) && batch.isa<T>(p.output) == p.isa;
}

template <class T>
Case batch_case(const BatchProblem& p) {
  Case c;
  c.formulation = p.formulation;
  c.kind = to_string(p.in->spec.kind);
  c.what = what(p.output);
  c.implementation = "batch";
  c.precision = sizeof(T) == 4 ? "float" : "double";
  c.isa = batch::to_string(p.isa);
  c.variant = p.block_diagonal ? "block_diagonal" : p.ends ? "" : "no_ends";
  c.method = p.output == Output::product ? "dual" : "";
  c.joints = int(p.joints), c.threads = p.options.threads;
  c.name = fmt::format("{}/{}/{}/batch/{}{}{}{}/{}{}", c.formulation, c.kind, c.what, c.isa,
                       sizeof(T) == 4 ? "/float" : "", c.variant.empty() ? "" : "/", c.variant, p.joints,
                       c.threads > 1 ? fmt::format("/threads_{}", c.threads) : "");
  c.evaluations = int(p.joints);
  c.wall_time = c.threads > 1;
  const Kind kind = p.in->spec.kind;
  const int read =
      2 * (kind == Kind::angular ? 4 : 7) + (p.output == Output::product ? batch::direction_rows(kind) : 0);
  const int rows = p.output == Output::compressed ? batch::Batch::compressed_rows(model_of(p))
                                                  : batch::tangent_rows(kind, p.output);
  c.bytes = (read + batch::load_rows(kind) + rows) * double(sizeof(T));
  c.check = [p] { return check<T>(p); };
  // Tables live for the run alone: a million joints are a gigabyte.
  c.timed = [p](benchmark::State& state) {
    const BatchData<T> data(p);
    for (auto _ : state) data.evaluate();
  };
  c.evaluate = [p, data = std::make_shared<std::optional<BatchData<T>>>()](int iterations) {
    if (!*data) data->emplace(p);
    for (int i = 0; i < iterations; ++i) (*data)->evaluate();
  };
  return c;
}

template class BatchData<double>;
template class BatchData<float>;
template bool can_run<double>(const BatchProblem&);
template bool can_run<float>(const BatchProblem&);
template Case batch_case<double>(const BatchProblem&);
template Case batch_case<float>(const BatchProblem&);

}  // namespace halfway::bench
