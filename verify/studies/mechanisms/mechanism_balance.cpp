// A loop of three joints under loads of all sorts: balance of each body, of each joint's reactions, of work;
// its place in space and the order of its nodes.
#include "verify/oracle/property.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/worst.hpp"
#include "verify/studies/mechanisms/generic.hpp"

#include <cmath>
#include <memory>

namespace halfway::verify {
namespace {

using reference::BodyLoad;
using reference::LoadType;
using reference::MechanismScene;
namespace mechanism = reference::mechanism;

template <class T>
struct Solved {
  Solved(const MechanismScene& of, const Entry& entry, const T& factor)
      : scene(std::make_unique<MechanismScene>(of)),
        model(std::make_unique<mechanism::Model<T>>(*scene, entry, entry.probe_xi)),
        path(*model) {
    path.advance(factor);
  }
  bool converged() const { return path.held_reached() == T(1) && path.reached().status == Status::converged; }
  Pose<T> node(int body) const {
    return mechanism::node_of(*model, path.reached().state.at, std::size_t(body));
  }

  std::unique_ptr<MechanismScene> scene;
  std::unique_ptr<mechanism::Model<T>> model;
  mechanism::Follower<T> path;
};

using Loads6 = Eigen::Matrix<double, 6, 1>;

/// Force and moment about the node, global axes, of a load where the body stands.
Loads6 wrench(const BodyLoad& load, const Pose<double>& node) {
  const Vec3<double> value = follows(load.type) ? Vec3<double>(node.R * load.value) : load.value;
  Loads6 out;
  if (is_force(load.type))
    out << value, (node.R * load.point).cross(value);
  else
    out << Vec3<double>::Zero(), value;
  return out;
}

/// What the nodes' loads, from their poses in space, and the loads leave on the free bodies; and how far the
/// reactions are from them. Over the largest load.
double left_over(const Entry& entry, const Solved<double>& s) {
  if (!s.converged()) return std::nan("");
  const MechanismScene& scene = *s.scene;
  std::vector<Loads6> left(scene.bodies.size(), Loads6::Zero());
  double largest = 0, worst = 0;
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const auto& joint = scene.joints[j];
    const auto q =
        reference::node_loads<double>(entry, joint.spec, s.node(joint.a), s.node(joint.b), false).q;
    const auto& at = s.path.reached().state.at;
    const Loads6 on_a = tapped(mechanism::reaction(*s.model, at, j, true));
    const Loads6 on_b = tapped(mechanism::reaction(*s.model, at, j, false));
    left[std::size_t(joint.a)] += on_a;
    left[std::size_t(joint.b)] += on_b;
    reference::keep_largest(worst, reference::largest_entry<double>((q.head<6>() + on_a).eval()));
    reference::keep_largest(worst, reference::largest_entry<double>((q.tail<6>() + on_b).eval()));
  }
  for (const BodyLoad& load : scene.loads) {
    left[std::size_t(load.body)] += wrench(load, s.node(load.body));
    reference::keep_largest(largest, load.value.norm());
  }
  for (const int body : {1, 2})
    reference::keep_largest(worst, reference::largest_entry<double>(left[std::size_t(body)]));
  return worst / largest;
}

Finding balanced(const Entry& entry, Kind, Draft f) {
  Measurement worst;
  worst.include(left_over(entry, Solved<double>(generic_loop(entry, false), entry, 1)), "all sorts of loads");
  return f.measured(worst)
      .in("of the largest load")
      .at_most(1e-11,
               "the loop is strained by 0.02 rad and m where the loads strain by 0.05: some hundreds of "
               "roundings of stiffness, lever and strain")
      .by(Oracle::independent);
}

/// Largest difference of the bodies' motions, in the axes of the first.
double moved_apart(const Solved<double>& one, const Solved<double>& other, const Vec3<double>& turn,
                   const Vec3<double>& shift) {
  if (!one.converged() || !other.converged()) return std::nan("");
  double worst = 0;
  const Mat3<double> R = so3::exp<double>(turn);
  for (const int body : {1, 2}) {
    const Pose<double> a = one.node(body), b = other.node(body);
    reference::keep_largest(worst, reference::largest_entry<double>((R * a.R - tapped(b.R)).eval()));
    reference::keep_largest(worst, reference::largest_entry<double>((R * a.x + shift - tapped(b.x)).eval()));
  }
  return worst;
}

Finding carried_along(const Entry& entry, Kind, Draft f) {
  const Vec3<double> turn(0.7, -1.1, 0.4), shift(3, -2, 5);
  const MechanismScene scene = generic_loop(entry, false);
  const Solved<double> here(scene, entry, 1), there(carried(scene, turn, shift), entry, 1);
  return f.measured(moved_apart(here, there, turn, shift))
      .in("m, 1")
      .at_most(1e-13, "positions of 6 m, some tens of roundings of them through stiffnesses 1e3 apart")
      .by(Oracle::closed_form);
}

/// A joint that knows no order of its nodes, listed the other way round.
std::vector<Finding> exchanged(const Entry& entry) {
  MechanismScene scene = generic_loop(entry, false), other = scene;
  for (auto& joint : other.joints) exchange_nodes(joint);
  const Solved<double> one(scene, entry, 1), two(other, entry, 1);
  return {finding(std::string(entry.name) + "/mechanism_node_order")
              .of(std::string(entry.name))
              .about("mechanisms")
              .measured(moved_apart(one, two, Vec3<double>::Zero(), Vec3<double>::Zero()))
              .in("m, 1")
              .at_most(1e-13, "some tens of roundings of positions, through stiffnesses 1e3 apart")
              .by(Oracle::closed_form)};
}

/// Work of dead forces and energy that is stored, from just before a load factor to just after it, at 50
/// digits: relative.
std::vector<Finding> energy(const Entry& entry) {
  const MechanismScene scene = generic_loop(entry, true);
  const Real50 h("1e-12"), middle(0.7);
  const Solved<Real50> before(scene, entry, middle - h), now(scene, entry, middle),
      after(scene, entry, middle + h);
  Real50 work(0);
  for (const BodyLoad& load : scene.loads) {
    const auto where = [&](const Solved<Real50>& s) -> Vec3<Real50> {
      const Pose<Real50> node = s.node(load.body);
      return node.x + node.R * load.point.cast<Real50>();
    };
    const Real50 factor = load.held ? Real50(1) : middle;
    work += factor * load.value.cast<Real50>().dot(Vec3<Real50>(where(after) - where(before)));
  }
  const auto stored = [](const Solved<Real50>& s) { return mechanism::output(s.path, "energy"); };
  const bool all = before.converged() && now.converged() && after.converged();
  const Real50 gained = tapped(stored(after)) - tapped(stored(before));
  return {finding(std::string(entry.name) + "/mechanism_energy")
              .of(std::string(entry.name))
              .about("mechanisms")
              .measured(all ? double(Real50(abs((work - gained) / work))) : std::nan(""))
              .in("of the work")
              .at_most(1e-20, "differences over 2e-12 of the load: its square, some thousands of times")
              .by(Oracle::closed_form)};
}

/// Of the loop, by the unknowns, against central differences at 50 digits: of its largest entry.
std::vector<Finding> tangent(const Entry& entry) {
  const Solved<Real50> s(generic_loop(entry, false), entry, Real50(1));
  const mechanism::Model<Real50>& model = *s.model;
  const auto& at = s.path.reached().state.at;
  const std::vector<Real50> full(s.scene->loads.size(), Real50(1));
  const int n = model.unknowns();
  const mechanism::Matrix<Real50> K = s.path.equations().tangent();
  const Real50 h("1e-17");
  Measurement worst;
  double largest = 0;
  mechanism::Matrix<Real50> off(n, n);
  for (int i = 0; i < n; ++i) {
    const mechanism::Vector<Real50> step = h * mechanism::Vector<Real50>::Unit(n, i);
    const auto load = [&](const mechanism::Vector<Real50>& by) -> mechanism::Vector<Real50> {
      const auto moved = model.moved(at, by);
      return mechanism::internal(model, moved).load - mechanism::external(model, moved, full).load;
    };
    const mechanism::Vector<Real50> difference = (load(step) - load(-step)) / (Real50(2) * h);
    for (int j = 0; j < n; ++j) {
      worst.include(double(Real50(abs(K(j, i) - tapped(difference[j])))), "");
      reference::keep_largest(largest, std::abs(double(K(j, i))));
    }
  }
  return {finding(std::string(entry.name) + "/mechanism_tangent")
              .of(std::string(entry.name))
              .about("mechanisms")
              .measured(s.converged() ? worst.value() / largest : std::nan(""))
              .in("of the largest entry")
              .at_most(1e-30, "central differences over 1e-17, some thousands of their squares")
              .by(Oracle::independent)};
}

}  // namespace

void mechanism_balance(Checks& checks) {
  add_property(checks, "mechanism_balance", {Kind::linear_angular}, balanced);
  add_property(checks, "mechanism_carried", {Kind::linear_angular}, carried_along);
  for (const char* name : {"invariant", "conformal", "fasse", "helicoidal"}) {
    const Entry* entry = reference::find_formulation(name);
    if (!entry) continue;
    const std::string of = name;
    checks.push_back({of + "/mechanism_node_order", "mechanisms", [entry] { return exchanged(*entry); }});
    if (of != "invariant")
      checks.push_back({of + "/mechanism_energy", "mechanisms", [entry] { return energy(*entry); }});
  }
  for (const char* name : {"invariant", "attached_a", "chrono_body"}) {
    if (const Entry* entry = reference::find_formulation(name))
      checks.push_back(
          {std::string(name) + "/mechanism_tangent", "mechanisms", [entry] { return tangent(*entry); }});
  }
}

}  // namespace halfway::verify
