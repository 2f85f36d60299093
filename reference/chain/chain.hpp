// A rod as a chain of N rigid links with joints of any formulation that has a batch; statics, O(N).
//
// Node i is at arc length i h, h = L/N, joint j between nodes j-1 and j at (j - 1/2) h: half links at both
// ends. A joint is as stiff as the rod over h, and at rest where the stress-free curve puts it, which is an
// exact arc (a helix where the curvature has a component along the tangent). Axis 1 of a node is the tangent.
// SI units, radians, global axes but where an axis of a node is named.
#pragma once

#include "halfway/batch/batch.hpp"
#include "halfway/joint/pose.hpp"
#include "halfway/rotations/scalar.hpp"

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace halfway::reference::chain {

/// Of a rod's section, in its principal axes: m dk_i = EI_i dk_i, f = diag(EA, GA2, GA3) strain.
struct Section {
  double GJ = 1, EI2 = 1, EI3 = 1;        ///< N m^2
  double EA = 1e4, GA2 = 5e3, GA3 = 5e3;  ///< N
};

/// Which node of a joint is its node a.
enum class NodeOrder {
  root_first,  ///< the one nearer to the root
  tip_first
};

struct Chain {
  std::string formulation = "invariant";  ///< a name of the catalog that has a batch
  std::optional<double> xi{};             ///< where the formulation demands one
  long links = 16;                        ///< N, joints as well
  double length = 1;                      ///< L, m
  Section section{};
  Vec3<double> curvature = Vec3<double>::Zero();  ///< kappa0 of the stress-free rod, axes of the section, 1/m
  Pose<double> root{};                            ///< node 0, clamped
  NodeOrder node_order = NodeOrder::root_first;
};

/// On the last node. A follower load is given in the node's axes and turns with it.
struct EndLoads {
  Vec3<double> force = Vec3<double>::Zero();            ///< fixed in space, N
  Vec3<double> follower_force = Vec3<double>::Zero();   ///< N, node axes
  Vec3<double> moment = Vec3<double>::Zero();           ///< fixed in space, N m
  Vec3<double> follower_moment = Vec3<double>::Zero();  ///< N m, node axes
  /// Sum of f r^T over dead forces that add up to nothing, f in global axes, r from the node in its axes, N
  /// m: couples whose moment changes as the node turns, and which have a potential.
  Mat3<double> virial = Mat3<double>::Zero();
};

/// Four dead forces on a cross that is fixed to the node and, where that has the orientation R, square to
/// them: the moment is m there, and half of what turns the node turns it. N m, global axes.
inline Mat3<double> semi_tangential(const Vec3<double>& m, const Mat3<double>& R) { return skew(m) / 2 * R; }
/// One pair of them on an arm, node axes, which has to be across m where the node has the orientation R; its
/// length means nothing.
inline Mat3<double> quasi_tangential(const Vec3<double>& m, const Vec3<double>& arm, const Mat3<double>& R) {
  return m.cross(R * arm) * arm.transpose() / arm.squaredNorm();
}

/// Of the Newton iteration; the residual is the same for all, and so is the equilibrium that is reached.
enum class Tangent {
  exact,
  symmetrised,   ///< (K + K^T)/2
  frozen_first,  ///< of the first iteration of the first load step
  frozen_step,   ///< of each load step's first iteration
  attached       ///< of attached_a at the same poses, which is what MBDyn's invariant joints take
};

struct Settings {
  Tangent tangent = Tangent::exact;
  int load_steps = 1;
  int most_iterations = 60;  ///< in one load step
  /// Largest spin of a node in one iteration, rad: a larger increment is shortened as a whole.
  double spin_cap = 0.5;
  /// Whole increments first; a load step whose increments do not shrink is begun again, capped.
  bool uncapped_first = true;
  /// After each iteration, with the iterations that were done and those that are allowed; false: stop.
  std::function<bool(int done, int most)> progress{};
  std::optional<batch::Isa> isa{};  ///< the widest to be used; none: HALFWAY_ISA or what the machine has
  bool tip_stiffness = false;       ///< whether Solution::tip_stiffness is wanted
};

/// What an iteration did.
struct Iteration {
  double increment = std::numeric_limits<double>::quiet_NaN();  ///< largest of |w| and |dx|/L, before the cap
  double scale = 1;                                             ///< what the cap left of it
};

/// Position (m) and unit quaternion (w, x, y, z), node axes -> global axes.
struct Node {
  double x[3];
  double q[4];
};
Pose<double> pose(const Node& node);

struct Solution {
  std::vector<Node> nodes;  ///< 0 ... N
  bool converged = false;   ///< increments vanish and the imbalance is rounding (below 64)
  std::string outcome{};    ///< in words: "converged", or why not
  int load_steps = 0;       ///< that were completed
  int restarts = 0;         ///< of load steps, capped
  std::vector<Iteration> iterations;
  /// Largest load left on a link: a force over eps (|f| + |m|/L), a moment over eps (EI/h + |m| + L |f|).
  double imbalance = std::numeric_limits<double>::quiet_NaN();
  double tip_error = std::numeric_limits<double>::quiet_NaN();  ///< estimated, of the algebra alone, over L
  /// Norm of the factors X, u_j = y - X u_(j+1), over that of as many unit matrices; SI units.
  double growth = std::numeric_limits<double>::quiet_NaN();
  bool pivoted = false;  ///< did growth call for pivots within blocks?
  /// Where it was asked for and the end is free: what a displacement (m) and a spin of the last node need of
  /// force and moment about it (N, N m) beyond those of the loads, all other nodes in balance. Singular at a
  /// critical load.
  std::optional<Eigen::Matrix<double, 6, 6>> tip_stiffness{};
};

/// Throws std::invalid_argument: a formulation without a batch (by name), one that needs a xi without it,
/// links < 1, a length or stiffness that is not positive, numbers that are not finite, a root
/// that is no rotation.
Solution solve(const Chain& chain, const EndLoads& loads, const Settings& settings = {});

/// The same with the last node held at a pose, reached in load steps along the arc from its place at rest.
/// EndLoads are what the support has to do, f and m about the last node, N and N m.
struct Held {
  Solution solution;
  Vec3<double> force, moment;
};
Held solve_held(const Chain& chain, const Pose<double>& last, const Settings& settings = {});

/// Nodes of the chain at rest.
std::vector<Node> at_rest(const Chain& chain);

}  // namespace halfway::reference::chain
