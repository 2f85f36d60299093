// Every formulation of the catalog behind one run-time face, in double, 50 digits and duals.
#pragma once

#include "reference/face/joint_spec.hpp"
#include "reference/face/kernel_entry.hpp"
#include "reference/numbers/dual.hpp"
#include "reference/numbers/precision.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace halfway::reference {

/// One formulation in scalar T. `angular` serves Kind::angular, `point` the two others. Nobody times this
/// face, so that a wrapper (a kernel, a saboteur) is a copy of an Entry with other functions.
template <class T>
struct Evaluators {
  template <class Result>
  using At = std::function<Result(const JointSpec&, const Pose<T>& a, const Pose<T>& b)>;
  template <class Loads>
  using LoadsAt =
      std::function<Loads(const JointSpec&, const Pose<T>& a, const Pose<T>& b, bool with_tangent)>;

  At<Eigen::Matrix<T, Eigen::Dynamic, 1>> strain;
  LoadsAt<AngularLoads<T>> angular;
  LoadsAt<NodeLoads<T>> point;
  At<std::optional<T>> energy;  ///< the potential, where the formulation has one for this kind
};

struct Entry {
  std::string_view name;
  std::string_view stands_for;
  std::string_view type;    ///< in C++, below namespace halfway
  std::string_view header;  ///< to be included for it
  Facts facts;
  bool needs_xi;                 ///< true for the form with a free xi
  double probe_xi;               ///< the xi at which verify and bench probe it
  bool wide;                     ///< the catalog's mark: AVX-512 and float batches, transcription timed
  bool block_diagonal_law_only;  ///< refuses translation-rotation coupling
  bool (*has_potential)(Kind);
  Evaluators<double> in_double;
  Evaluators<Real50> in_real50;
  Evaluators<Dual<Real50>> in_dual50;  ///< empty before complete_catalog()
  KernelEntry kernel;                  ///< the same
  bool needs_length = false;           ///< true for the rod with a length and an axis
  Parameters probe{};                  ///< at which verify and bench probe it, probe_xi among them
  /// |theta|, rad, below which the energy is convex for a law of that stiffness; nullptr: no limit.
  double (*convex_radius)(const Eigen::MatrixXd& K) = nullptr;

  template <class T>
  const Evaluators<T>& in() const {
    if constexpr (std::is_same_v<T, double>)
      return in_double;
    else if constexpr (std::is_same_v<T, Real50>)
      return in_real50;
    else
      return in_dual50;
  }
};

/// The catalog's entries in the order of catalog.def.
std::span<Entry> catalogued();

/// Adds duals and kernels to the catalog's entries: what the suite asks of them and `halfway` does not, in a
/// library of its own (reference_deep). First in a program that verifies or reports.
void complete_catalog();

/// The entries in use: the catalog's, or those of a ScopedRegistry.
std::span<const Entry> formulations();

/// The entry in use of that name, or nullptr.
const Entry* find_formulation(std::string_view name);

/// What the joint stores, J: its potential; of one without, the law's energy at its strain.
double stored_energy(const Entry& entry, const JointSpec& spec, const Pose<double>& a, const Pose<double>& b);

/// Other entries in use while it lives, for one thread of control: how wrong twins take the place of
/// formulations.
class ScopedRegistry {
 public:
  explicit ScopedRegistry(std::vector<Entry> entries);
  ~ScopedRegistry();
  ScopedRegistry(const ScopedRegistry&) = delete;
  ScopedRegistry& operator=(const ScopedRegistry&) = delete;

 private:
  std::vector<Entry> entries_;
  std::span<const Entry> before_;
};

/// An angular joint's loads and tangent in the 12 coordinates of the two nodes.
template <class T>
NodeLoads<T> node_loads(const AngularLoads<T>& angular, bool with_tangent) {
  NodeLoads<T> out;
  out.q << Vec3<T>::Zero(), -angular.m_b, Vec3<T>::Zero(), angular.m_b;
  if (with_tangent) {
    out.tangent.setZero();
    out.tangent.template block<3, 3>(3, 3) = -angular.m_b_wa;
    out.tangent.template block<3, 3>(3, 9) = -angular.m_b_wb;
    out.tangent.template block<3, 3>(9, 3) = angular.m_b_wa;
    out.tangent.template block<3, 3>(9, 9) = angular.m_b_wb;
  }
  return out;
}

/// Loads (f_a, m_a, f_b, m_b) and tangent of any kind in the 12 coordinates of the two nodes.
template <class T>
NodeLoads<T> node_loads(const Entry& entry, const JointSpec& spec, const Pose<T>& a, const Pose<T>& b,
                        bool with_tangent) {
  if (spec.kind != Kind::angular) return entry.in<T>().point(spec, a, b, with_tangent);
  return node_loads(entry.in<T>().angular(spec, a, b, with_tangent), with_tangent);
}

/// Poses and ends in another scalar.
template <class T, class S>
Pose<T> cast(const Pose<S>& p) {
  return {p.x.template cast<T>(), p.R.template cast<T>()};
}

}  // namespace halfway::reference
