#include "verify/studies/scenes/hinge_mutants.hpp"

#include "halfway/equilibrium.hpp"
#include "halfway/systems/attached.hpp"

#include <cmath>
#include <limits>

namespace halfway::verify {
namespace {

using Hinge = Joint<Kind::linear_angular, double, AttachedA, LinearLaw<double, 6>>;
using Internal = decltype(internal_of(std::declval<const Hinge&>()));
using System = LoadedJoint<Kind::linear_angular, double, Internal>;

// N6: what a temporary leaves behind is not followed.
template <class J>
concept Followed = requires(J&& joint) {
  internal_of(std::forward<J>(joint));
};
static_assert(Followed<const Hinge&> && !Followed<Hinge> && !Followed<const Hinge>);

Hinge hinge_of(const reference::Scene& scene) {
  Hinge joint{{}, {std::get<reference::LinearSpec>(scene.joint.law).matrix}, {}, {}};
  joint.b.o = scene.joint.b.o;
  return joint;
}

NodeLoad<double> load_of(const reference::Scene& scene) {
  NodeLoad<double> load;
  load.force = scene.loads[0].value;
  load.moment = scene.loads[1].value;
  return load;
}

double theta_x(const Pose<double>& joint) { return so3::log<double>(joint.R)[0]; }

/// Newton in one load step, ended by another rule than the library's.
template <class Ends>
class EndedBy {
 public:
  explicit EndedBy(System& system) : system_(system) {}
  NewtonLook<double> look() {
    NewtonLook<double> look = system_.look();
    look.is_rounding = Ends::here(look.size);
    return look;
  }
  void move() { system_.move(); }

 private:
  System& system_;
};

template <class Ends>
double ended_by(const reference::Scene& scene) {
  const Hinge joint = hinge_of(scene);
  const Internal internal = internal_of(joint);
  const JointLoad<double> load =
      joint_load<double>(Kind::linear_angular, load_of(scene), Mat3<double>::Identity(), joint.b);
  System system(internal, load, 1.0, {});
  EndedBy<Ends> mutant(system);
  newton<double>(mutant, 12);
  return theta_x(system.joint());
}

/// size^2 = work of the correction; a radian against the stiffest direction would do 1e9 N m or more.
struct StiffestEntry {
  static bool here(double size) { return size * size < 100 * std::numeric_limits<double>::epsilon() * 1e9; }
};
struct SmallStep {
  static bool here(double size) { return size < 3e-5; }
};

}  // namespace

double hinge_by_solver(const reference::Scene& scene) {
  const Hinge joint = hinge_of(scene);
  return theta_x(follow(joint, Pose<double>{}, load_of(scene), Outcome<double>{}, 1.0).joint);
}

double hinge_by_stiffest_entry(const reference::Scene& scene) { return ended_by<StiffestEntry>(scene); }
double hinge_by_small_step(const reference::Scene& scene) { return ended_by<SmallStep>(scene); }

double hinge_by_positions(const reference::Scene& scene) {
  const Hinge joint = hinge_of(scene);
  const auto at_node = [&](const Pose<double>& b) {
    const NodeLoads<double> q = loads<true>(joint, Pose<double>{}, b);
    return Balance<double, 6>{q.q.tail<6>(), q.tangent.bottomRightCorner<6, 6>()};
  };
  const JointEnd<double> none;
  const JointLoad<double> load =
      joint_load<double>(Kind::linear_angular, load_of(scene), Mat3<double>::Identity(), none);
  const SolverOptions<double> options;
  Outcome<double> from;
  from.joint = unstrained(joint.a, joint.b, Pose<double>{});
  from.last.joint = from.before.joint = from.joint;
  PathFollower<Kind::linear_angular, double, decltype(at_node)> follower(at_node, load, options, from);
  return theta_x(follower.to(1.0).joint);
}

}  // namespace halfway::verify
