// Up to which load each formulation stays within 1 % and 5 % of the 3D body: theta_2, the coupling that the
// joint exists for, along the paper's load paths prolonged.
#include "reference/solve/solve.hpp"
#include "verify/oracle/fe_access.hpp"
#include "verify/oracle/kept.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/scene_access.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string_view>
#include <utility>

namespace halfway::verify {
namespace {

namespace fe = reference::fe;

struct Range {
  const char* study;
  const char* scene;
  const char* body;
  Kind kind;
  double reach;  ///< load at the curve's end over the scene's
  const char* unit;
};

const Range kRanges[] = {
    {"range_block_moment", "c2_parallelepiped_small", "block", Kind::angular, 300, "N m"},
    {"range_frustum_moment", "c4_frustum", "frustum_top", Kind::angular, 10, "N m"},
    {"range_block_force", "c6_compression_shear", "block", Kind::linear_angular, 6, "N in each direction"}};

const fe::SolidCurve& truth(const Range& range) {
  static std::map<std::string, fe::SolidCurve> curves;
  const auto found = curves.find(range.study);
  if (found != curves.end()) return found->second;
  for (const auto& curve : solid_curves(range.study)) {
    if (curve.law == kPaperLaw) return curves.emplace(range.study, curve).first->second;
  }
  throw std::runtime_error(std::string("no 3D curve of ") + range.study);
}

/// Compliance and couplings of the very mesh of the curve, so that its discretisation error is in neither
/// side.
const fe::SecondOrder& mesh(const Range& range) {
  static std::map<std::string, fe::SecondOrder> all;
  const auto found = all.find(range.study);
  if (found != all.end()) return found->second;
  const fe::Body& body = fe::body_named(range.body);
  const fe::SolidCurve& curve = truth(range);
  return all.emplace(range.study, characterise(body, joint_point(body), curve.element, curve.level).result)
      .first->second;
}

/// A free xi is taken from the body itself: the second-order coupling that theta_2 begins with.
double xi_for(const Entry& entry, const Range& range) {
  if (!entry.needs_xi) return entry.probe_xi;
  return range.kind == Kind::angular ? xi_of_moments(mesh(range), kPaperLaw, 0, 2)
                                     : xi_of_forces(mesh(range), kPaperLaw, 0, 2);
}

/// The scene with the body's own compliance, up to the 3D curve's last point.
reference::Scene prolonged(const Range& range) {
  reference::Scene s = scene(range.scene);
  const fe::Mat6& C = mesh(range).compliance;
  if (range.kind == Kind::angular)
    s.joint.law = reference::LinearSpec{Eigen::MatrixXd(C.bottomRightCorner<3, 3>()), true};
  else
    s.joint.law = reference::LinearSpec{Eigen::MatrixXd(without_rounding(C)), true};
  s.outputs = {"theta_x", "theta_y", "theta_z"};
  s.points = int(truth(range).points.size());
  s.factor_end = range.reach * truth(range).points.back().factor;
  return s;
}

/// The load at which the relative error of theta_2 first exceeds `limit`, by linear interpolation between the
/// points; the last load where it never does; 0 where it does from the start; NaN without a point, or where a
/// rotation is none.
double reached(const reference::Curve& lumped, const Range& range, double limit) {
  double last_load = 0, last_error = 0;
  const auto& points = truth(range).points;
  std::size_t i = 0;
  for (const auto& row : lumped.rows) {
    if (row[0] <= 0) continue;
    if (i == points.size()) break;
    const double error = std::abs(row[2] / points[i].theta[1] - 1);
    if (!(error <= limit))
      return i == 0 && error > limit
                 ? 0
                 : last_load + (row[0] - last_load) * (limit - last_error) / (error - last_error);
    last_load = row[0];
    last_error = error;
    ++i;
  }
  return i == 0 ? std::nan("") : last_load;
}

/// Rotation of the body (degrees) up to which each component of the rotation vector is within `limit` of the
/// body's own, by linear interpolation between the points of the curve. NaN without a point, or where a
/// rotation is none.
double degrees_within(const reference::Curve& lumped, const Range& range, double limit) {
  double last_phi = std::nan(""), last_error = 0;
  const auto& points = truth(range).points;
  for (std::size_t i = 0; i < points.size() && i + 1 < lumped.rows.size(); ++i) {
    const auto& row = lumped.rows[i + 1];  // the first is the unloaded joint's
    const double phi = points[i].theta.norm();
    const Vec3<double> off = Vec3<double>(row[1], row[2], row[3]) - points[i].theta;
    const auto error = reference::largest_entry<double>(off.cwiseQuotient(points[i].theta).eval());
    if (!(error <= limit)) {
      const double share = i == 0 && error > limit ? 0 : (limit - last_error) / (error - last_error);
      return (i == 0 ? share * phi : last_phi + share * (phi - last_phi)) * 180 / std::numbers::pi;
    }
    last_phi = phi, last_error = error;
  }
  return last_phi * 180 / std::numbers::pi;
}

/// Degrees within 1 % and within 5 %, kept from this code: a formulation that is not here is only reported.
struct KeptDegrees {
  std::string_view name;
  double one, five;
};

constexpr KeptDegrees kDegrees[] = {{"attached_a", 0, 0},
                                    {"attached_b", 0, 0},
                                    {"invariant", 3.399, 7.694},
                                    {"intrinsic", 3.399, 7.694},
                                    {"jointc", 3.71, 8.099},
                                    {"field_a", 0, 0},
                                    {"field_b", 0, 0},
                                    {"conformal", 3.348, 7.584},
                                    {"potential", 3.381, 7.668},
                                    {"helicoidal", 3.381, 7.668},
                                    {"quaternion", 3.452, 7.852},
                                    {"cayley", 2.872, 6.592},
                                    {"rod4", 3.722, 8.639},
                                    {"rod34", 3.722, 8.639},
                                    {"simbody_xyz", 0, 0},
                                    {"drake_rpy", 0, 0},
                                    {"chrono_body", 0, 0},
                                    {"exudyn_intrinsic", 3.399, 7.694},
                                    {"mbdyn_joint_inv", 0, 0}};

Draft held(Draft f, const Entry& entry, double limit) {
  const auto* kept = kept_of(kDegrees, entry);
  if (kept == nullptr) return f.reported("no kept value of this formulation");
  const double degrees = limit == 0.01 ? kept->one : kept->five;
  return f
      .equal(degrees, 1e-3 * degrees, "kept to four digits: the curves are data, the mesh is solved again")
      .by(Oracle::kept);
}

Finding degrees_of(const Entry& entry, Draft f, const Range& range, double limit) {
  const reference::Curve lumped = solve_scene(prolonged(range), {&entry, xi_for(entry, range)});
  f.measured(degrees_within(lumped, range, limit),
             fmt::format("each component of the rotation vector; the curve ends at {:.1f} deg",
                         truth(range).points.back().theta.norm() * 180 / std::numbers::pi))
      .in("deg");
  return held(std::move(f), entry, limit);
}

Finding of_formulation(const Entry& entry, Draft f, const Range& range) {
  const reference::Scene s = prolonged(range);
  if (!reference::accepts_law(entry, s.joint))
    return f.left_out("refuses a law that couples translation and rotation");
  const reference::Curve lumped = solve_scene(s, {&entry, xi_for(entry, range)});
  const double end = s.factor_end;
  const double one = reached(lumped, range, 0.01), five = reached(lumped, range, 0.05);
  const auto text = [&](double load) {
    return load >= end * (1 - 1e-12) ? fmt::format("{:g}, the end of the 3D curve", load)
                                     : fmt::format("{:.3g}", load);
  };
  std::string where =
      fmt::format("theta_2 within 1 % up to {}, within 5 % up to {}; phi = {:.2f} rad at {:g}", text(one),
                  text(five), truth(range).points.back().theta.norm(), end);
  if (entry.needs_xi) where += fmt::format("; xi = {:.4f}, the body's", xi_for(entry, range));
  return f.measured(one, where)
      .in(range.unit)
      .reported(
          lumped.converged
              ? "load up to which the coupling theta_2 is within 1 % of the 3D body (cauchy_log): reported"
              : "the lumped path itself ends early: " + lumped.outcome)
      .by(Oracle::independent);
}

}  // namespace

void fe_ranges(Checks& checks) {
  for (const Range& range : kRanges) {
    add_property(
        checks, std::string("fe_") + range.study, {range.kind},
        [&range](const Entry& entry, Kind, Draft f) { return of_formulation(entry, std::move(f), range); });
  }
  const Range& block = kRanges[0];
  for (const auto& [name, limit] :
       {std::pair{"fe_degrees_1_percent", 0.01}, {"fe_degrees_5_percent", 0.05}}) {
    add_property(checks, name, {block.kind}, [limit = limit](const Entry& entry, Kind, Draft f) {
      return degrees_of(entry, std::move(f), block, limit);
    });
  }
}

}  // namespace halfway::verify
