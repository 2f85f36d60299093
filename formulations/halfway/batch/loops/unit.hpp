// The loops of one formulation over packs of joints; included only by the generated units.
#pragma once

#include "halfway/batch/loops/law.hpp"
#include "halfway/batch/loops/results.hpp"
#include "halfway/batch/loops/same.hpp"
#include "halfway/kernels/dual.hpp"
#include "halfway/kernels/joint.hpp"

namespace halfway::batch::detail {

using kernel::ExactAngle, kernel::Quat, kernel::V3;

/// Rows of joints i .. i + lanes of a table.
template <class P, class Number>
HALFWAY_INLINE V3<P> vector_at(const Columns<const Number>& c, int row, long i) {
  const Number* const p = c.first + row * c.stride + i;
  return {P::load(p), P::load(p + c.stride), P::load(p + 2 * c.stride)};
}
template <class P, class Number>
HALFWAY_INLINE Quat<P> quaternion_at(const Columns<const Number>& c, long i) {
  return {P::load(c.first + i), vector_at<P>(c, 1, i)};
}
template <class P, class Number>
HALFWAY_INLINE V3<P> same_for_all(const Number* x) {
  return {P(double(x[0])), P(double(x[1])), P(double(x[2]))};
}
template <class T, class P, class Number>
HALFWAY_INLINE V3<T> constant(const Number* x) {
  const V3<P> v = same_for_all<P>(x);
  return {T(v.x), T(v.y), T(v.z)};
}

/// One node as the kernel wants it: frame of the joint, and where the joint point is.
template <class T>
struct PlacedNode {
  Quat<T> joint;
  V3<T> arm;  ///< from the node to the joint point, global axes
};

/// R(q) o.
template <class T>
HALFWAY_INLINE V3<T> rotated(const Quat<T>& q, const V3<T>& o) {
  const V3<T> t = T(2.0) * cross(q.v, o);
  return o + q.w * t + cross(q.v, t);
}

template <Kind kind, class P, class T, class Number>
HALFWAY_INLINE PlacedNode<T> node(const Quat<T>& q, const BatchEnd<Number>& end) {
  PlacedNode<T> n{q * Quat<T>{T(P(double(end.H[0]))), constant<T, P>(end.H + 1)}, {}};
  if constexpr (kind != Kind::angular) n.arm = rotated(q, constant<T, P>(end.o));
  return n;
}

/// A pose's quaternion moved by the spin w: dq = (0, w) q / 2.
template <class P>
HALFWAY_INLINE Quat<kernel::Dual<P>> moved(const Quat<P>& q, const V3<P>& spin) {
  const Quat<P> half = Quat<P>{P(0.0), P(0.5) * spin} * q;
  return {{q.w, half.w}, kernel::dual(q.v, half.v)};
}

/// Which joints a loop is for: any; those without ends and with a linear law; of those, the ones whose law
/// does not couple translation and rotation. A loop chooses nothing within: what would be chosen once a pack,
/// however well predicted, has a pack's numbers pass through memory (measured with g++ 12: residuals take 1.5
/// to 1.7 times as long, tangents 1.2 to 1.3).
enum class Loop { any, lean, block_diagonal };

template <Kind kind, class P, class Number, Loop loop>
HALFWAY_INLINE auto law_at(const Job<Number>& job, long i) {
  const Numbers<P, Number> numbers{job.law.first + job.law_step * i, job.law.stride};
  if constexpr (loop == Loop::block_diagonal)
    return block_diagonal(numbers);
  else if constexpr (loop == Loop::lean && kind == Kind::linear_angular)
    return LinearLaw6<P, Number>{numbers};
  else if constexpr (loop == Loop::lean)
    return LinearLaw3<P, Number>{numbers};
  else if constexpr (kind == Kind::linear_angular)
    return AnyLaw6<P, Number>{numbers, job.polynomial};
  else
    return AnyLaw3<P, Number>{numbers, job.polynomial};
}

template <class K, class Number>
HALFWAY_INLINE K kernel_of(const Job<Number>& job) {
  K k{};
  if constexpr (requires { k.translation.xi; }) k.translation.xi = job.parameters.xi;
  if constexpr (requires { k.rod.parameters; }) k.rod.parameters = job.parameters;
  return k;
}

/// Does the kernel do less where translation and rotation are not coupled?
template <class K>
inline constexpr bool kSparesCoupling = requires {
  requires K::kSparesCoupling;
};

/// Loads of a pack's joints between nodes of the orientations q.
/// @param D  from node a to b, m; read if not angular
/// @param out  MomentLoads or PointLoads, or what takes its parts as soon as they are known
template <class K, Kind kind, class Angle, bool with_tangent, bool ends, class P, class T, class L,
          class Number, class Out>
HALFWAY_INLINE void loads_between(const K& k, const L& law, const Quat<T>& q_a, const Quat<T>& q_b,
                                  const V3<T>& D, const Job<Number>& job, Out& out) {
  if constexpr (ends) {
    const PlacedNode<T> a = node<kind, P>(q_a, *job.a), b = node<kind, P>(q_b, *job.b);
    const auto r = kernel::relative_for<K, kind>(a.joint, b.joint);
    if constexpr (kind == Kind::angular)
      kernel::assign<with_tangent>(k.template angular<Angle, with_tangent>(r, law), out);
    else
      kernel::assign<with_tangent>(kernel::node_loads<Angle, kind, with_tangent>(k, law, r, D, a.arm, b.arm),
                                   out);
  } else {
    const auto r = kernel::relative_for<K, kind>(q_a, q_b);
    if constexpr (kind == Kind::angular)
      kernel::assign<with_tangent>(k.template angular<Angle, with_tangent>(r, law), out);
    else
      kernel::put_node_loads<Angle, kind, with_tangent>(k, law, r, D, out);
  }
}

template <Kind kind, class P, class Number>
HALFWAY_INLINE V3<P> distance_at(const Columns<const Number>& x_a, const Columns<const Number>& x_b, long i) {
  if constexpr (kind == Kind::angular)
    return {};
  else
    return vector_at<P>(x_b, 0, i) - vector_at<P>(x_a, 0, i);
}

/// Loads of joints i .. i + lanes, in registers: out as for loads_between().
template <class K, Kind kind, bool with_tangent, Loop loop, class P, class Number, class Out>
HALFWAY_INLINE void loads_at(const K& k, const Job<Number>& job, long i, Out& out) {
  loads_between<K, kind, ExactAngle, with_tangent, loop == Loop::any, P>(
      k, law_at<kind, P, Number, loop>(job, i), quaternion_at<P>(job.q_a, i), quaternion_at<P>(job.q_b, i),
      distance_at<kind, P>(job.x_a, job.x_b, i), job, out);
}

/// Residual, with or without its tangent.
template <class K, Kind kind, bool with_tangent, Kept kept, Loop loop, class P, class Number>
void evaluate(const Job<Number>& call) {
  if constexpr (loop == Loop::lean && kind == Kind::linear_angular && with_tangent && kSparesCoupling<K>) {
    if (uncoupled(call)) return evaluate<K, kind, with_tangent, kept, Loop::block_diagonal, P>(call);
  }
  const Job<Number> job = call;  // what is stored to a table cannot change it
  const K k = kernel_of<K>(job);
  for (long i = 0; i < job.count; i += P::kLanes) {
    auto out = rows_at<kind, kept>(writer(job.loads, i), writer(job.tangent, i));
    loads_at<K, kind, with_tangent, loop, P>(k, job, i, out);
  }
}

/// Residual and its derivative along job.direction.
template <class K, Kind kind, class P, class Number>
void evaluate_product(const Job<Number>& call) {
  using T = kernel::Dual<P>;
  const Job<Number> job = call;
  const K k = kernel_of<K>(job);
  constexpr bool kAngular = kind == Kind::angular;
  for (long i = 0; i < job.count; i += P::kLanes) {
    const auto law = law_at<kind, P, Number, Loop::any>(job, i);
    const kernel::LawAlong<decltype(law)> along{law};
    const V3<P> w_a = vector_at<P>(job.direction, kAngular ? 0 : 3, i);
    const V3<P> w_b = vector_at<P>(job.direction, kAngular ? 3 : 9, i);
    V3<T> D{};
    if constexpr (!kAngular) {
      D = kernel::dual(distance_at<kind, P>(job.x_a, job.x_b, i),
                       vector_at<P>(job.direction, 6, i) - vector_at<P>(job.direction, 0, i));
    }
    auto out = product_rows_at<kind>(writer(job.loads, i), writer(job.tangent, i));
    loads_between<K, kind, kernel::Along<ExactAngle>, false, true, P>(
        k, along, moved(quaternion_at<P>(job.q_a, i), w_a), moved(quaternion_at<P>(job.q_b, i), w_b), D, job,
        out);
  }
}

/// @tparam lean  are there loops besides for joints without ends and with a linear law?
template <class F, Kind kind, bool lean, class P, class Number>
constexpr void set_functions(Functions<Number>& f) {
  using K = KernelType<F>;
  if constexpr (std::is_same_v<K, typename Served<K, kind>::By>) {
    f.residual = evaluate<K, kind, false, Kept::all, Loop::any, P, Number>;
    f.tangent = evaluate<K, kind, true, Kept::all, Loop::any, P, Number>;
    if constexpr (lean) {
      f.lean_residual = evaluate<K, kind, false, Kept::all, Loop::lean, P, Number>;
      f.lean_tangent = evaluate<K, kind, true, Kept::all, Loop::lean, P, Number>;
    }
    if constexpr (lean && std::is_same_v<Number, double> && kPacked<K, kind> != Kept::all)
      f.lean_compressed = evaluate<K, kind, true, kPacked<K, kind>, Loop::lean, P, Number>;
    if constexpr (std::is_same_v<Number, double>) f.product = evaluate_product<K, kind, P, Number>;
  }
}

template <class F, bool lean, class Number, class Isa>
constexpr void set_kinds(Functions<Number> (&f)[3]) {
  using P = Pack<Number, Isa>;
  set_functions<F, Kind::angular, lean, P>(f[0]);
  set_functions<F, Kind::linear, lean, P>(f[1]);
  set_functions<F, Kind::linear_angular, lean, P>(f[2]);
}

/// @tparam in_float  are there loops in float?
template <class F, class Isa, bool lean, bool in_float>
constexpr Unit make_unit() {
  Unit unit{};
  set_kinds<F, lean, double, Isa>(unit.in_double);
  if constexpr (in_float) set_kinds<F, lean, float, Isa>(unit.in_float);
  return unit;
}

}  // namespace halfway::batch::detail
