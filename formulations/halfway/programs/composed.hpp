// A program joint put together: frame of the force x rotation measure x moment map x arms.
//
// Beside the family's own (halfway/joint): measures that do not follow the rotation vector, maps that are no
// transposed rate, and forces that act where no virtual work puts them.
#pragma once

#include "halfway/joint/frames.hpp"
#include "halfway/joint/measures.hpp"
#include "halfway/programs/situation.hpp"

namespace halfway::programs {

/// v over its length; zero of nothing.
template <class T>
Vec3<T> unit(const Vec3<T>& v) {
  using std::sqrt;
  const T square = v.squaredNorm();
  return square > T(0) ? Vec3<T>(v / sqrt(square)) : Vec3<T>(Vec3<T>::Zero());
}

// Arms: where the force acts on both bodies, from M, the moment part on b.

/// At p_a + s d on both, s = numerator / denominator: balanced for every s.
template <int numerator, int denominator = 1>
struct At {
  template <class T>
  static ProgramLoads<T> loads(const Vec3<T>& p, const Vec3<T>& f, const Vec3<T>& M) {
    const T s = T(numerator) / T(denominator);
    const Vec3<T> moment = p.cross(f);
    return {f, Vec3<T>(-M - s * moment), Vec3<T>(M + (s - T(1)) * moment)};
  }
};
using AtA = At<0>;
using AtMiddle = At<1, 2>;
using AtB = At<1>;

/// On each body at its own joint point: the moments do not balance, d x f is left over.
struct Own {
  template <class T>
  static ProgramLoads<T> loads(const Vec3<T>&, const Vec3<T>& f, const Vec3<T>& M) {
    return {f, Vec3<T>(-M), M};
  }
};

// Moment maps: the moment on b, axes of P_a, from the relative motion and the stress K e.

template <class Frame>
struct Along {  // the axes of a frame
  template <class T>
  static Vec3<T> moment(const RelativeMotion<T>& m, const Vec3<T>& stress) {
    return Frame::rotation(m) * stress;
  }
};

/// The moment conjugate to the measure.
template <class Measure>
struct ByRate {
  template <class T>
  static Vec3<T> moment(const RelativeMotion<T>& m, const Vec3<T>& stress) {
    const Mat3<T> E = Measure::rate(m);
    return E.transpose() * stress;
  }
};

/// The axes of the three Euler turns I, J, K, in P_a: the first on a, the last on b, the middle one normal to
/// both.
template <class T, int I, int J, int K>
struct GimbalAxes {
  Vec3<T> first, middle, last;
  explicit GimbalAxes(const Mat3<T>& R) : first(Vec3<T>::Unit(I)), last(R.col(K)) {
    const T sign(EulerMeasure<I, J, K>::kParity);
    middle = -sign * unit<T>(first.cross(last));
  }
};

/// Moments along the gimbal axes themselves: not what virtual work asks for.
template <int I, int J, int K>
struct AlongGimbal {
  template <class T>
  static Vec3<T> moment(const RelativeMotion<T>& m, const Vec3<T>& stress) {
    const GimbalAxes<T, I, J, K> g(m.R);
    return stress[I] * g.first + stress[J] * g.middle + stress[K] * g.last;
  }
};

/// Moments along the reciprocal axes, shortened to one: what is left of virtual work without 1/cos(e_J).
template <int I, int J, int K>
struct AlongReciprocal {
  template <class T>
  static Vec3<T> moment(const RelativeMotion<T>& m, const Vec3<T>& stress) {
    const T sign(EulerMeasure<I, J, K>::kParity);
    const GimbalAxes<T, I, J, K> g(m.R);
    const Vec3<T> along_first = sign * g.middle.cross(g.last), along_last = sign * g.first.cross(g.middle);
    return stress[I] * along_first + stress[J] * g.middle + stress[K] * along_last;
  }
};

// Measures, e(R).

/// 2 asin(q_i): each component of the quaternion as if it were alone.
struct AsinMeasure {
  template <class T>
  static Vec3<T> strain(const RelativeMotion<T>& m) {
    using std::atan2, std::sqrt;
    Vec3<T> e;
    for (int i = 0; i < 3; ++i) e[i] = T(2) * atan2(m.q.v[i], T(sqrt(T(T(1) - m.q.v[i] * m.q.v[i]))));
    return e;
  }
};

/// (2 q1, -R31, R21): twist by the quaternion, swing by the shaft's own direction.
struct SwingTwistMeasure {
  template <class T>
  static Vec3<T> strain(const RelativeMotion<T>& m) {
    return {T(2) * m.q.v[0], T(-m.R(2, 0)), m.R(1, 0)};
  }
};

/// (R32, R13, R21): one entry of the matrix for each axis.
struct EntryMeasure {
  template <class T>
  static Vec3<T> strain(const RelativeMotion<T>& m) {
    return {m.R(2, 1), m.R(0, 2), m.R(1, 0)};
  }
};

/// -(R23, R31, R12), the other entries.
struct OtherEntryMeasure {
  template <class T>
  static Vec3<T> strain(const RelativeMotion<T>& m) {
    return {T(-m.R(1, 2)), T(-m.R(2, 0)), T(-m.R(0, 1))};
  }
  /// delta R = [psi] R: delta R23 = psi3 R13 - psi1 R33, and so on.
  template <class T>
  static Mat3<T> rate(const RelativeMotion<T>& m) {
    const Mat3<T>& R = m.R;
    Mat3<T> E;
    E << R(2, 2), T(0), T(-R(0, 2)), T(-R(1, 0)), R(0, 0), T(0), T(0), T(-R(2, 1)), R(1, 1);
    return E;
  }
};

/// Rods: the curvature 2 t_a x t_b/(1 + t_a.t_b) of the two shafts z along the axes x, y of a, and the twist
/// that parallel transport leaves.
struct BinormalMeasure {
  template <class T>
  static Vec3<T> strain(const RelativeMotion<T>& m) {
    using std::atan2;
    const T scale = T(2) / (T(1) + m.R(2, 2));
    return {T(-scale * m.R(1, 2)), T(scale * m.R(0, 2)), T(T(2) * atan2(m.q.v[2], m.q.w))};
  }
  /// t = R z, delta t = psi x t; the twist turns about t_a + t_b.
  template <class T>
  static Mat3<T> rate(const RelativeMotion<T>& m) {
    const Vec3<T> t = m.R.col(2);
    const T sum = T(1) + t[2], scale = T(2) / sum;
    const Mat3<T> t_psi = -skew<T>(t);
    const auto row = [&](int i) { return Vec3<T>(t_psi.row(i).transpose()); };
    const auto curvature = [&](int i, const T& value) {
      return Vec3<T>(scale * row(i) - (scale * value / sum) * row(2));
    };
    Mat3<T> E;
    E.row(0) = -curvature(1, t[1]).transpose();
    E.row(1) = curvature(0, t[0]).transpose();
    E.row(2) = (Vec3<T>(Vec3<T>::Unit(2) + t) / sum).transpose();
    return E;
  }
};

/// A quarter of sin(phi) n.
struct QuarterSineMeasure {
  template <class T>
  static Vec3<T> strain(const RelativeMotion<T>& m) {
    return axial(m.R) / T(4);
  }
};

/// A law whose loads are those of strains and of their stresses, as in the family: so it takes any spring.
/// It has
///   strain(m)                     what the springs see, translation and rotation
///   of_stress(m, force, moment)   loads at the joint points, axes of P_a
template <class Law>
struct BySprings {
  template <class T>
  static ProgramLoads<T> at_points(const RelativeMotion<T>& m, const Mat3<T>& K_f, const Mat3<T>& K_m) {
    const Strain<T, Kind::linear_angular> e = Law::strain(m);
    const Vec3<T> translation = e.template head<3>(), rotation = e.template tail<3>();
    return Law::template of_stress<T>(m, K_f * translation, K_m * rotation);
  }
};

/// @tparam Force  the frame whose axes the translational springs have
template <class Force, class Measure, class Map, class Arms>
struct Composed : BySprings<Composed<Force, Measure, Map, Arms>> {
  template <class T>
  static Strain<T, Kind::linear_angular> strain(const RelativeMotion<T>& m) {
    Strain<T, Kind::linear_angular> e;
    e << Force::rotation(m).transpose() * m.p, Measure::strain(m);
    return e;
  }

  template <class T>
  static ProgramLoads<T> of_stress(const RelativeMotion<T>& m, const Vec3<T>& force, const Vec3<T>& moment) {
    const Vec3<T> f = Force::rotation(m) * force;
    return Arms::template loads<T>(m.p, f, Map::moment(m, moment));
  }
};

}  // namespace halfway::programs
