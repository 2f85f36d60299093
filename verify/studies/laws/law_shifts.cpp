// Preloads, offsets, principal axes and measured matrices: where a law's zero is, and along what it lies.
#include "reference/numbers/random.hpp"
#include "reference/scene/names.hpp"
#include "reference/solve/path.hpp"
#include "verify/oracle/findings.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/laws/read_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

using reference::AnyLaw;
using reference::largest_entry;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

constexpr const char* kEnds =
    "offset_a = [0.1, -0.2, 0.3]\noffset_b = [-0.3, 0.1, 0.2]\nframe_a = [0.5, 0.5, -0.5, 0.5]\n"
    "frame_b = [0.8, 0, 0.6, 0]";
constexpr const char* kCoupled =
    "type = \"linear\"\nK = [[30, 2, 1, 0.5, 0, 3], [2, 40, 0, 1, 2, 0], [1, 0, 50, 0, 1, 0.25], [0.5, 1, 0, "
    "7, 1, 0], "
    "[0, 2, 1, 1, 9, 0.5], [3, 0, 0.25, 0, 0.5, 8]]\n";

/// The law in sums of its entries.
std::vector<Finding> sums() {
  const auto joint = scene_of_law(Kind::linear_angular, std::string(kCoupled) +
                                                            "preload = [1, -2, 3, 0.5, 0.25, -4]\n"
                                                            "offset = [0.1, 0, -0.2, 0.3, 0.05, 0]\n")
                         .joint;
  const auto plain = scene_of_law(Kind::linear_angular, kCoupled).joint;
  const Mat6 K = std::get<reference::LinearSpec>(plain.law).matrix;
  const Vec6 p = (Vec6() << 1, -2, 3, 0.5, 0.25, -4).finished(),
             o = (Vec6() << 0.1, 0, -0.2, 0.3, 0.05, 0).finished();
  const AnyLaw<double, 6> law(joint.law);
  Measurement stress, energy;
  for (const double s : {0.0, 1.0, -0.6}) {
    const Vec6 e = s * (Vec6() << 0.2, -0.1, 0.4, 0.3, -0.5, 0.6).finished();
    Vec6 expected = p;
    double work = 0;
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        expected[i] += K(i, j) * (e[j] - o[j]);
        work += K(i, j) * e[i] * (e[j] / 2 - o[j]);
      }
      work += p[i] * e[i];
    }
    stress.include(largest_entry<double>((tapped(law(e).stress) - expected).eval()) / 50,
                   fmt::format("{} e", s));
    energy.include(std::abs(tapped(law.energy(e)) - work) / 10, fmt::format("{} e", s));
  }
  return {at_most("laws/shift/stress", "laws", stress, 1e-15, "of 50 N", Oracle::closed_form,
                  "roundings of six products"),
          at_most("laws/shift/energy", "laws", energy, 2e-15, "of 10 J", Oracle::closed_form,
                  "roundings of 36 products")};
}

/// Loads of a formulation at the pose where its strain is `e`: nodes apart, frames on both.
NodeLoads<double> loads_at_strain(const Entry& entry, const JointSpec& spec, const Vec6& e, Pose<double>& a) {
  a = {{0.4, -1, 2}, so3::exp<double>({0.3, -0.8, 0.5})};
  const Mat3<double> P_a = a.R * spec.a.H;
  Pose<double> b;
  b.R = P_a * so3::exp<double>(e.tail<3>()) * spec.b.H.transpose();
  b.x = a.x + a.R * spec.a.o + P_a * e.head<3>() - b.R * spec.b.o;
  return reference::node_loads<double>(entry, spec, a, b, false);
}

/// Of measures that see a turn about one axis as its angle.
constexpr const char* kSeesAngle[] = {"attached_a", "attached_b", "invariant", "potential"};

/// Where nothing is strained the joint bears its preload, along its axes on whatever bodies.
std::vector<Finding> preload_at_rest() {
  Measurement worst;
  const JointSpec joint = scene_of_law(Kind::linear_angular,
                                       std::string(kCoupled) + "preload = [1, -2, 3, 0.5, 0.25, -4]\n", kEnds)
                              .joint;
  for (const Entry& entry : reference::formulations()) {
    if (!reference::accepts_law(entry, joint)) continue;
    if (!entry.facts.moment_balance.linear_angular.holds()) continue;  // a force without its arm
    JointSpec spec = joint;
    spec.xi = entry.probe_xi;
    Pose<double> a;
    const NodeLoads<double> found = loads_at_strain(entry, spec, Vec6::Zero(), a);
    const Mat3<double> P_a = a.R * spec.a.H;
    const Vec3<double> f = P_a * Vec3<double>(1, -2, 3), m = P_a * Vec3<double>(0.5, 0.25, -4);
    const Vec3<double> arm = P_a * spec.b.H.transpose() * spec.b.o;  // from node b to the joint point
    const Vec3<double> m_b = m + arm.cross(f);
    worst.include(largest_entry<double>((tapped(found.q.segment<3>(6)) - f).eval()), std::string(entry.name));
    worst.include(largest_entry<double>((tapped(found.q.segment<3>(9)) - m_b).eval()),
                  std::string(entry.name));
  }
  return {at_most("laws/preload/at_rest", "laws", worst, 2e-14, "N, N m", Oracle::closed_form,
                  "loads of 10 N m through three turns and arms")};
}

/// At a strain that is the offset it bears nothing.
std::vector<Finding> offset_zero() {
  Measurement worst;
  const JointSpec joint =
      scene_of_law(Kind::linear_angular, std::string(kCoupled) + "offset = [0, 0, 0, 0.3, 0, 0]\n", kEnds)
          .joint;
  for (const char* name : kSeesAngle) {
    Pose<double> a;
    const auto q = loads_at_strain(*reference::find_formulation(name), joint,
                                   (Vec6() << 0, 0, 0, 0.3, 0, 0).finished(), a)
                       .q;
    worst.include(largest_entry<double>(tapped(q)), name);
  }
  return {at_most("laws/offset/at_its_zero", "laws", worst, 1e-14, "N, N m", Oracle::closed_form,
                  "stiffnesses of 50 at strains of rounding")};
}

constexpr const char* kTurn = "[0.5, -0.5, 0.5, 0.5]";

/// Principal axes of the law and the same joint with its frames turned to them: one joint, in all loads.
std::vector<Finding> turned_frames() {
  Measurement worst;
  const Mat3<double> A = so3::matrix<double>({0.5, {-0.5, 0.5, 0.5}});
  for (const Kind kind : kKinds) {
    const std::string law = kind == Kind::linear_angular
                                ? kCoupled
                                : "type = \"linear\"\nK = [[30, 2, 1], [2, 40, 0], [1, 0, 50]]\n";
    for (const char* name : kSeesAngle) {
      const Entry& entry = *reference::find_formulation(name);
      const JointSpec given = scene_of_law(kind, law + "axes = " + kTurn + "\n").joint,
                      plain = scene_of_law(kind, law).joint;
      for (const Probe& probe : probes(entry, kind, 4, 2.5)) {
        JointSpec turned = probe.spec, straight = probe.spec;
        straight.law = given.law;
        turned.law = plain.law;
        turned.a.H = turned.a.H * A;
        turned.b.H = turned.b.H * A;
        const auto q = reference::node_loads<double>(entry, straight, probe.a, probe.b, true);
        const auto other = reference::node_loads<double>(entry, turned, probe.a, probe.b, true);
        const double size = 1 + largest_entry<double>(other.tangent);
        worst.include(largest_entry<double>((tapped(q.q) - other.q).eval()) / size, name);
        worst.include(largest_entry<double>((tapped(q.tangent) - other.tangent).eval()) / size, name);
      }
    }
  }
  return {at_most("laws/axes/turned_frames", "laws", worst, 1e-13, "of the largest stiffness",
                  Oracle::independent,
                  "objectivity: loads through two more turns of matrices, and products with arms")};
}

/// A diagonal along axes of its own is a sum of dyads, k a a^T of each; its compliance likewise.
std::vector<Finding> dyads() {
  Measurement worst;
  const Mat3<double> A = so3::matrix<double>({0.8, {0, 0.6, 0}}),
                     B = so3::matrix<double>({0.5, {0.5, 0.5, 0.5}});
  const Vec6 k = (Vec6() << 1e3, 2e3, 5e3, 7, 30, 100).finished();
  for (const char* word : {"stiffness", "compliance"}) {
    const auto law =
        scene_of_law(Kind::linear_angular,
                     fmt::format("type = \"linear\"\n{} = [1e3, 2e3, 5e3, 7, 30, 100]\naxes_translation = "
                                 "[0.8, 0, 0.6, 0]\naxes_rotation = [0.5, 0.5, 0.5, 0.5]\n",
                                 word))
            .joint.law;
    const Mat6 found = tapped(std::get<reference::LinearSpec>(law).matrix);
    Mat6 expected = Mat6::Zero();
    for (int i = 0; i < 3; ++i) {
      expected.topLeftCorner<3, 3>() += k[i] * A.col(i) * A.col(i).transpose();
      expected.bottomRightCorner<3, 3>() += k[3 + i] * B.col(i) * B.col(i).transpose();
    }
    worst.include(largest_entry<double>((found - expected).topLeftCorner<3, 3>().eval()) / 5e3, word);
    worst.include(largest_entry<double>((found - expected).bottomRightCorner<3, 3>().eval()) / 100, word);
    worst.include(largest_entry<double>((found - expected).topRightCorner<3, 3>().eval()), word);
  }
  return {at_most("laws/axes/dyads", "laws", worst, 1e-15, "relative", Oracle::closed_form,
                  "three products for an entry")};
}

/// A measured matrix is used by its symmetric part, and the note says what that changes.
std::vector<Finding> measured_matrix() {
  const auto scene = scene_of_law(
      Kind::angular, "type = \"linear\"\nK = [[10, 1.25, 0], [0.75, 20, 0], [0, 0, 5]]\ntolerance = 0.05\n");
  const Mat3<double> K = std::get<reference::LinearSpec>(scene.joint.law).matrix;
  const std::string note =
      tapped(scene.notes.size() == 1 ? scene.notes[0] : std::string("notes are missing"));
  const bool says =
      note == "joint.law.K is symmetric to 0.03 only; its symmetric part is used: (1, 2) changes by 0.25" ||
      note == "joint.law.K is symmetric to 0.02 only; its symmetric part is used: (1, 2) changes by 0.25";
  return {finding("laws/tolerance/mean")
              .about("laws")
              .measured(tapped(K(0, 1)) + K(1, 0))
              .in("N m/rad")
              .equal(2, 0, "halves of binary fractions")
              .by(Oracle::closed_form),
          finding("laws/tolerance/note")
              .about("laws")
              .measured(!says, note)
              .at_most(0, "how unsymmetric it was, and where")
              .by(Oracle::closed_form)};
}

/// A polygon's strain at a stress, by hand.
double polygon_strain(const std::vector<double>& x, const std::vector<double>& y, double stress) {
  std::size_t i = 1;
  while (i + 1 < y.size() && stress > y[i]) ++i;
  return x[i - 1] + (stress - y[i - 1]) * (x[i] - x[i - 1]) / (y[i] - y[i - 1]);
}

struct Polygon {
  const char* name;
  std::vector<double> x, y;
};

/// Stiffening a hundredfold and giving way again; a gap that closes; slopes 1e4 apart.
const Polygon kPolygons[] = {
    {"stiff_soft_stiff", {-1, -0.4, -0.1, 0, 0.1, 0.4, 1}, {-90, -30, -25, 0, 25, 30, 90}},
    {"stop", {-1, 0, 0.3, 0.302, 1}, {-10, 0, 3, 5, 705}},
    {"gives_way", {-1, 0, 0.01, 2}, {-1e4, 0, 100, 150}}};

/// Equilibria on points of the curve, where the stiffness jumps, and past them in one load step; up and down.
std::vector<Finding> equilibria(const Polygon& polygon) {
  const std::string law = fmt::format(
      "type = \"per_axis\"\n[[joint.law.axis]]\nx = {}\ny = {}\n[[joint.law.axis]]\nstiffness = "
      "500\n[[joint.law.axis]]\nstiffness = 900\n",
      list_text(polygon.x), list_text(polygon.y));
  reference::Scene scene = scene_of_law(Kind::angular, law, kEnds);
  const Vec3<double> axis = scene.joint.a.H.col(0);
  scene.loads = {{reference::LoadType::fixed_moment, axis}};
  std::vector<double> moments = polygon.y;
  for (std::size_t i = 1; i < polygon.y.size(); ++i)
    moments.push_back(0.3 * polygon.y[i - 1] + 0.7 * polygon.y[i]);
  moments.insert(moments.end(), {polygon.y.front() * 1.05, polygon.y.back() * 1.05});
  Measurement error, iterations;
  for (const char* name : kSeesAngle) {
    for (const double moment : moments) {
      reference::Path<double> path(scene, *reference::find_formulation(name), 0.5);
      const bool converged = path.advance(moment).status == Status::converged;
      const std::string where = fmt::format("{} at {:g} N m", name, moment);
      double along = 0;
      for (int i = 0; i < 3; ++i) along += axis[i] * path.output(std::string("theta_") + char('x' + i));
      const double off = std::abs(tapped(along) - polygon_strain(polygon.x, polygon.y, moment));
      error.include(converged ? off : std::nan(""), where);
      iterations.include(tapped(double(path.state().iterations)), where);
    }
  }
  const auto of = [&](const char* what) { return fmt::format("laws/equilibrium/{}/{}", polygon.name, what); };
  return {at_most(of("error"), "laws", error, 1e-13, "rad", Oracle::closed_form,
                  "roundings of the moment over slopes down to 1 of 1e4 N m/rad"),
          at_most(of("iterations"), "laws", iterations, 60, "Newton corrections", Oracle::closed_form,
                  "one more a jump that a load step crosses, and steps halved to turns below 0.35 rad")};
}

/// A joint with play and one without a linear part: no path leaves rest, and the equilibria are those of
/// their curves.
std::vector<Finding> play() {
  struct Curve {
    const char* axis;
    double (*strain)(double moment);
  };
  const Curve kPlays[] = {{"x = [-1, -0.1, 0.1, 1]\ny = [-90, 0, 0, 90]",
                           [](double m) { return std::copysign(0.1, m) + m / 100; }},
                          {"k1 = 0\nk3 = 5", [](double m) { return std::cbrt(m / 5); }}};
  Measurement error;
  for (const Curve& curve : kPlays) {
    reference::Scene scene =
        scene_of_law(Kind::angular,
                     fmt::format("type = \"per_axis\"\n[[joint.law.axis]]\nstiffness = "
                                 "500\n[[joint.law.axis]]\n{}\n[[joint.law.axis]]\nstiffness = 900\n",
                                 curve.axis),
                     kEnds);
    const Vec3<double> axis = scene.joint.a.H.col(1);
    scene.loads = {{reference::LoadType::fixed_moment, axis}};
    for (const char* name : kSeesAngle) {
      for (const double moment : {1e-6, 0.02, 3.0, -8.0}) {
        reference::Path<double> path(scene, *reference::find_formulation(name), 0.5);
        const bool converged = path.advance(moment).status == Status::converged;
        double along = 0;
        for (int i = 0; i < 3; ++i) along += axis[i] * path.output(std::string("theta_") + char('x' + i));
        const double expected = curve.strain(moment);
        error.include(converged ? std::abs(tapped(along) / expected - 1) : std::nan(""),
                      fmt::format("{} at {:g} N m", name, moment));
      }
    }
  }
  return {at_most("laws/play/error", "laws", error, 1e-11, "relative", Oracle::closed_form,
                  "roundings of stiffnesses of 500 beside slopes down to 1e-3 of 1e-6 N m")};
}

}  // namespace

void law_shifts(Checks& checks) {
  checks.push_back({"laws/shift", "laws", sums});
  checks.push_back({"laws/preload", "laws", preload_at_rest});
  checks.push_back({"laws/offset", "laws", offset_zero});
  checks.push_back({"laws/axes_frames", "laws", turned_frames});
  checks.push_back({"laws/axes_dyads", "laws", dyads});
  checks.push_back({"laws/tolerance", "laws", measured_matrix});
  checks.push_back({"laws/play", "laws", play});
  for (const Polygon& polygon : kPolygons)
    checks.push_back({fmt::format("laws/equilibrium/{}", polygon.name), "laws",
                      [&polygon] { return equilibria(polygon); }});
}

}  // namespace halfway::verify
