// What a joint can be asked to tell what it is. Each question is a fixed list of poses, whatever the answers
// are, so that a program can be asked all of them at once, and a file of answers serves as well.
#pragma once

#include "reference/programs/ask.hpp"
#include "reference/record/worst.hpp"

#include <vector>

namespace halfway::reference {

/// The largest relative defect, and the question that has it. NaN until something was measured.
struct Defect {
  Measurement worst;
  Ask at;
};

enum class Springs { isotropic, diagonal, full };

/// Poses without any symmetry, offsets and joint frames on both bodies, relative angles from `least` to
/// `largest`, rad.
/// @param bond  the joint points rest one metre apart along z (halfway/programs/lines.hpp), else together
std::vector<Ask> generic_asks(int count, double least, double largest, Springs springs, bool bond = false);

/// |f_a + f_b| / |f_b|.
Defect force_balance(const Answerer& joint, const std::vector<Ask>& asks);

/// |m_a + m_b + (x_b - x_a) x f_b| / max(|m_a|, |m_b|).
Defect moment_balance(const Answerer& joint, const std::vector<Ask>& asks);

/// Change of the loads when the bodies, with their ends, are exchanged; forces or moments, over their own
/// norm.
Defect body_order(const Answerer& joint, const std::vector<Ask>& asks);

/// Change of the loads, seen from the turned frame, when both bodies move as one.
Defect objectivity(const Answerer& joint, const std::vector<Ask>& asks);

/// Change of the loads when the quaternions of b are the opposite ones: the same rotations.
Defect double_cover(const Answerer& joint, const std::vector<Ask>& asks);

/// Change of the loads when the bodies are taken to end at the joint: their poses those of the joint frames,
/// no offset and no frame on them, the loads there carried back.
Defect ends(const Answerer& joint, const std::vector<Ask>& asks);

/// Change of the loads when the bodies have other masses and inertias.
Defect mass_dependence(const Answerer& joint, const std::vector<Ask>& asks);

/// Loads over the stiffness: change when every spring is four times as stiff.
Defect proportionality(const Answerer& joint, const std::vector<Ask>& asks);

/// Change of the loads when both bodies stand a kilometre further.
Defect far_away(const Answerer& joint, const std::vector<Ask>& asks);

/// |m(Q R Q^T) - Q m(R)| / |m(R)| with K_m = I: a tensorial measure has none [Bauchau].
/// @param k_f  N/m: some programs take one number alone
Defect tensoriality(const Answerer& joint, double k_f = 0);

/// Work round a closed loop of body b over the path of |power|, signed: positive is put in by the loads on
/// the bodies. theta(s) = 0.64 (cos s, sin s, sin(2 s + 0.7)/2); with `moves` p(s) = (0.3 cos s, 0.2 sin(s +
/// 0.4), 0.25 cos 2 s), else 0. @param around  m, where p(s) is counted from
double loop_work(const Answerer& joint, const Vec3<double>& k_f, const Vec3<double>& k_m, bool moves,
                 const Vec3<double>& around = Vec3<double>::Zero());

/// The shaft (axis 0, 1, 2) turns freely, K_m = k but 0 about the shaft, and is bent by 0.2 rad about the
/// next axis: the moment on b stays k 0.2 about it. Largest error over two turns, over k 0.2.
double free_spin(const Answerer& joint, int shaft);

/// Moment on b over k phi, a turn by phi about one axis, k = 1 N m/rad. @param k_f  N/m: some programs take
/// one number alone
double secant_stiffness(const Answerer& joint, int axis, double phi, double k_f = 0);

/// m = K theta + 1/2 theta x K theta + (b1 th2 th3, b2 th3 th1, b3 th1 th2) + O(3), K_m = diag(2, 3, 7).
struct SecondOrder {
  Vec3<double> b = Vec3<double>::Constant(NAN);
  double first_defect = NAN;  ///< of the first-order part from K theta, relative
  double residual = NAN;      ///< of the second-order part from this form, relative to |K|
};
/// @param digits  decimal digits of the answers: they choose the step
SecondOrder second_order(const Answerer& joint, double digits = 15.5);

/// Relative difference of two answers: forces or moments, each over its own norm; NaN of no loads.
double apart(const TwelveLoads& q, const TwelveLoads& other);

}  // namespace halfway::reference
