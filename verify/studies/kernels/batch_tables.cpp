#include "reference/record/effort.hpp"
#include "verify/once.hpp"
#include "verify/oracle/poles.hpp"
#include "verify/studies/kernels/batch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfway::verify {
namespace {

using batch::Columns, batch::LawForm, batch::Output;

/// 0, the decades from 1e-3, both sides of every third of a turn, and toward pi.
std::vector<double> angles(bool single) {
  std::vector<double> out{0, 0};
  for (int i = 0; i < 26; ++i) out.push_back(1e-3 * std::pow(3.1e3, i / 25.0));
  for (int decade = -1; decade >= -12; --decade) {
    out.push_back(std::numbers::pi - std::max(std::pow(10.0, decade), single ? 1e-4 : 0.0));
  }
  return out;
}

reference::LawSpec law_of(const reference::LawSpec& linear, LawForm law, reference::Generator& g) {
  if (law == LawForm::linear) return linear;
  const auto n = std::get<reference::LinearSpec>(linear).matrix.rows();
  const auto numbers = [&] {
    Eigen::VectorXd v(n);
    for (double& x : v) x = g.uniform(0.5, 3);
    return v;
  };
  reference::PolynomialSpec p;
  p.k1 = numbers(), p.k3 = numbers(), p.k5 = numbers();
  return p;
}

/// |K|: of a polynomial its largest slope up to a strain of 2 pi could be anything; the tangent tells it.
double stiffness(const BatchJoint& j) {
  if (const auto* linear = std::get_if<reference::LinearSpec>(&j.spec.law)) return linear->matrix.norm();
  return double(largest_entry<Real50>(j.exact.tangent));
}

/// The relative quaternion is a difference of products: 4 eps are lost whatever the angle.
constexpr double kPlain = 4 * std::numeric_limits<double>::epsilon() / 5e-15;

/// The same for all kinds that turn, and for any law.
const std::vector<double>& steepnesses(const Entry& entry, const std::vector<BatchJoint>& joints, bool ends,
                                       bool single) {
  static Once<std::vector<double>, bool, bool> known;
  return known(entry, ends, single, [&] {
    std::vector<double> out;
    for (const BatchJoint& j : joints) {
      JointSpec angular = j.spec;
      angular.kind = Kind::angular;
      out.push_back(steepness(entry, angular, reference::exact_pose(j.a), reference::exact_pose(j.b)));
    }
    return out;
  });
}

template <class T>
void round_to(reference::QuaternionPose<double>& p) {
  p.x = p.x.cast<T>().template cast<double>();
  p.q = p.q.cast<T>().template cast<double>();
}

template <class T>
void fill_law(batch::Table<T>& table, long i, const reference::LawSpec& spec) {
  int row = 0;
  if (const auto* linear = std::get_if<reference::LinearSpec>(&spec)) {
    for (int r = 0; r < linear->matrix.rows(); ++r) {
      for (int c = r; c < linear->matrix.cols(); ++c) table(row++, i) = T(linear->matrix(r, c));
    }
    return;
  }
  const auto& p = std::get<reference::PolynomialSpec>(spec);
  for (const auto* k : {&p.k1, &p.k3, &p.k5}) {
    for (const double x : *k) table(row++, i) = T(x);
  }
}

template <class T>
batch::BatchEnd<T> end_of(const JointEnd<double>& e) {
  const auto q = so3::quaternion<double>(e.H);
  return {{T(e.o[0]), T(e.o[1]), T(e.o[2])}, {T(q.w), T(q.v[0]), T(q.v[1]), T(q.v[2])}};
}

/// Nothing solved yet. Laws have a generator of their own, so that all kinds and laws are in the same poses.
std::vector<BatchJoint> posed(const Entry& entry, Kind kind, LawForm law, bool ends, bool single) {
  reference::Generator g(512), of_law(513);
  const auto laws = probes(entry, kind, 8, 1);
  std::vector<BatchJoint> out;
  for (const double phi : angles(single)) {
    BatchJoint j{laws[out.size() % laws.size()].spec, {}, {}, phi};
    j.spec.law = law_of(j.spec.law, law, of_law);
    j.spec.a = j.spec.b = {};
    if (ends) {
      j.spec.a = {{0.3, -0.2, 0.1}, reference::third_of_turn(1)};
      j.spec.b = {{-0.1, 0.4, 0.2}, reference::third_of_turn(-1)};
    }
    const auto pair = reference::turned_pair(g, phi, ends);
    const Vec3<double> x = g.vector(1);
    j.a = {x, pair.a};
    j.b = {x + g.vector(0.5), pair.b};
    if (single) round_to<float>(j.a), round_to<float>(j.b);
    if (single) {
      for (JointEnd<double>* e : {&j.spec.a, &j.spec.b}) e->o = e->o.cast<float>().cast<double>();
    }
    out.push_back(j);
  }
  return out;
}

}  // namespace

void solve(const Entry& entry, BatchJoint& j) {
  const auto a = reference::exact_pose(j.a), b = reference::exact_pose(j.b);
  j.exact = reference::node_loads<Real50>(entry, j.spec, a, b, true);
  const double strain = double(Real50(entry.in_real50.strain(j.spec, a, b).norm()));
  const double loads = double(largest_entry<Real50>(j.exact.q));
  j.scale = larger(stiffness(j) * larger(strain, kPlain), loads);
}

std::vector<BatchJoint> batch_joints(const Entry& entry, Kind kind, LawForm law, bool ends, bool single) {
  std::vector<BatchJoint> out = sampled(posed(entry, kind, law, ends, single), 6);
  for (BatchJoint& j : out) solve(entry, j);
  if (kind == Kind::linear) return out;
  const std::vector<double>& steep = steepnesses(entry, out, ends, single);
  for (std::size_t i = 0; i < out.size(); ++i) out[i].steepness = steep[i];
  return out;
}

std::vector<BatchJoint> uncoupled(const Entry& entry, std::vector<BatchJoint> joints) {
  for (BatchJoint& j : joints) {
    auto& K = std::get<reference::LinearSpec>(j.spec.law).matrix;
    K.topRightCorner(3, 3).setZero(), K.bottomLeftCorner(3, 3).setZero();
    solve(entry, j);
  }
  return joints;
}

template <class T>
BatchTables<T>::BatchTables(const Entry& entry, const std::vector<BatchJoint>& joints, LawForm law_,
                            bool ends_, int rows)
    : model{std::string(entry.name), joints[0].spec.kind,   law_,
            joints[0].spec.xi,       joints[0].spec.length, joints[0].spec.axis},
      q_a(4, long(joints.size())),
      q_b(4, long(joints.size())),
      x_a(3, long(joints.size())),
      x_b(3, long(joints.size())),
      law(batch::law_rows(model.kind, law_), long(joints.size())),
      direction(batch::direction_rows(model.kind), long(joints.size())),
      loads(batch::load_rows(model.kind), long(joints.size())),
      tangent(rows, long(joints.size())),
      end_a(end_of<T>(joints[0].spec.a)),
      end_b(end_of<T>(joints[0].spec.b)),
      ends(ends_),
      count(long(joints.size())) {
  reference::Generator g(7);
  for (long i = 0; i < count; ++i) {
    const BatchJoint& j = joints[i];
    for (int c = 0; c < 4; ++c) q_a(c, i) = T(j.a.q[c]), q_b(c, i) = T(j.b.q[c]);
    for (int c = 0; c < 3; ++c) x_a(c, i) = T(j.a.x[c]), x_b(c, i) = T(j.b.x[c]);
    fill_law(law, i, j.spec.law);
    for (int c = 0; c < direction.rows(); ++c) direction(c, i) = T(g.uniform(-1, 1));
  }
}

template <class T>
batch::Joints<T> BatchTables<T>::joints() const {
  batch::Joints<T> j;
  j.count = count;
  j.q_a = q_a.columns(), j.q_b = q_b.columns(), j.x_a = x_a.columns(), j.x_b = x_b.columns();
  j.law = law.columns(), j.law_per_joint = true;
  j.direction = direction.columns();
  if (ends) j.a = &end_a, j.b = &end_b;
  return j;
}

template <class T>
NodeLoads<T> BatchTables<T>::at(long i, Output output) const {
  NodeLoads<T> out;
  out.tangent.setZero();
  const auto vector = [&](int row) { return Vec3<T>(loads(row, i), loads(row + 1, i), loads(row + 2, i)); };
  const auto matrix = [&](int row) {
    Mat3<T> m;
    for (int k = 0; k < 9; ++k) m(k / 3, k % 3) = tangent(row + k, i);
    return m;
  };
  const auto block = [&](int r, int c) { return out.tangent.template block<3, 3>(3 * r, 3 * c); };
  if (model.kind == Kind::angular) {
    out.q << Vec3<T>::Zero(), -vector(0), Vec3<T>::Zero(), vector(0);
    if (output != Output::tangent) return out;
    block(3, 1) = matrix(0), block(3, 3) = matrix(9);
    block(1, 1) = -matrix(0), block(1, 3) = -matrix(9);
    return out;
  }
  out.q << -vector(0), vector(3), vector(0), vector(6);
  if (output == Output::tangent_144) {
    for (int k = 0; k < 144; ++k) out.tangent(k / 12, k % 12) = tangent(k, i);
  } else if (output == Output::tangent) {
    const int rows[] = {2, 1, 3};  // f_b, m_a, m_b
    for (int l = 0; l < 3; ++l) {
      block(rows[l], 0) = -matrix(27 * l), block(rows[l], 2) = matrix(27 * l);
      block(rows[l], 1) = matrix(27 * l + 9), block(rows[l], 3) = matrix(27 * l + 18);
    }
    out.tangent.template topRows<3>() = -out.tangent.template middleRows<3>(6);
  }
  return out;
}

template struct BatchTables<double>;
template struct BatchTables<float>;

Finding counted(const std::string& name, double wrong, const std::string& reason) {
  return finding("batch/" + name)
      .about(name)
      .measured(wrong)
      .in("numbers")
      .at_most(0, reason)
      .by(Oracle::independent);
}

const Entry& invariant() { return *reference::find_formulation("invariant"); }

std::vector<BatchJoint> repeated(Kind kind, int count) {
  const auto some = posed(invariant(), kind, batch::LawForm::linear, true, false);
  std::vector<BatchJoint> out;
  for (int i = 0; i < count; ++i) out.push_back(some[i % some.size()]);
  return out;
}

BatchTables<double> tables_of(const std::vector<BatchJoint>& joints, batch::Output output) {
  return BatchTables<double>(invariant(), joints, batch::LawForm::linear, true,
                             std::max(1, batch::tangent_rows(joints[0].spec.kind, output)));
}

}  // namespace halfway::verify
