// Laws with a memory: frame and strain are carried along the path by the spins of the nodes, so that the
// loads depend on how a pose was reached.
//
// An object is a state: copy it to try a step, assign it to take the step back.
#pragma once

#include "halfway/programs/composed.hpp"

namespace halfway::programs {

/// Whose spin carries the frame, whether its first axis is kept on the line between the joint points, and
/// where the force acts.
enum class Scoor {
  with_a_balanced = -3,
  with_a_on_line = -2,
  with_a = -1,
  mean = 0,
  with_b = 1,
  with_b_on_line = 2,
  with_b_balanced = 3
};

/// LS-DYNA's discrete beam: translation by the total stretch (assumed: the manual does not say), rotation by
/// accumulated increments. SCOOR 0 and +-1 put each force on its own node and leave d x f; +-2 and +-3 put
/// both half-way. +-2 are known by a sentence alone: the first axis is turned onto the line between the
/// points on the shortest way, when there is a line; that points of a metre coincide is told to 1e-16 m, far
/// below 1e-9.
template <Scoor scoor>
class LsdynaScoor {
  static constexpr bool kOnLine = scoor == Scoor::with_a_on_line || scoor == Scoor::with_b_on_line;

 public:
  static constexpr ProgramFacts facts{.known = kOnLine ? Known::reconstructed : Known::manual,
                                      .source = "LS-DYNA: keyword manual, FAQ on discrete beams",
                                      .balanced = int(scoor) <= -2 || int(scoor) >= 2,
                                      .order_free = scoor == Scoor::mean};

  template <class T>
  struct State {
    Mat3<T> E = Mat3<T>::Identity();   ///< the carried frame, global axes
    Vec3<T> strain = Vec3<T>::Zero();  ///< accumulated rotation, axes of E, rad
    Vec3<T> rest = Vec3<T>::Zero();    ///< the stretch that bears no load, axes of E, m

    /// Where a path starts: unloaded, the frame that of a.
    void reset(const Situation<T>& s) {
      E = frame_a(s);
      align(s);
      strain = Vec3<T>::Zero();
      rest = E.transpose() * reach(s);
    }

    /// One step. @param s         its end
    /// @param w_a, w_b  the nodes' rotation vectors over it, global axes, rad
    void advance(const Situation<T>& s, const Vec3<T>& w_a, const Vec3<T>& w_b) {
      const Vec3<T> w = spin(w_a, w_b);
      const Mat3<T> middle = so3::exp<T>(w / T(2)) * E;
      strain += middle.transpose() * (w_b - w_a);
      E = so3::exp<T>(w) * E;
      align(s);
    }

    TwelveLoads<T> loads(const Situation<T>& s) const {
      const Vec3<T> d = reach(s);
      const Vec3<T> force = s.K_f * Vec3<T>(E.transpose() * d - rest), moment = s.K_m * strain;
      const Vec3<T> f = E * force, M = E * moment;
      using Arms = std::conditional_t<facts.balanced, AtMiddle, Own>;
      const ProgramLoads<T> at = Arms::template loads<T>(d, f, M);
      return carried<T>(s, at.f, at.m_a, at.m_b);
    }

   private:
    /// The first axis onto the line, the others along: the turn by the angle between them, about the normal
    /// of both. Points that coincide have no line.
    void align(const Situation<T>& s) {
      if constexpr (kOnLine) {
        using std::atan2, std::sqrt;
        const Vec3<T> d = reach(s);
        if (!(d.squaredNorm() > T(1e-18))) return;
        const Vec3<T> line = unit<T>(d), axis = E.col(0), normal = axis.cross(line);
        const T sine = sqrt(normal.squaredNorm());
        if (sine > T(0)) E = so3::exp<T>(Vec3<T>(normal * T(atan2(sine, T(axis.dot(line))) / sine))) * E;
      }
    }

    static Vec3<T> spin(const Vec3<T>& w_a, const Vec3<T>& w_b) {
      if constexpr (scoor == Scoor::mean) return (w_a + w_b) / T(2);
      return int(scoor) < 0 ? w_a : w_b;
    }
  };
};

}  // namespace halfway::programs
