// The kept nonlinear 3D analyses of the paper's bodies (reference/data/fe).
#include "reference/scene/scene.hpp"
#include "reference/truth/data.hpp"
#include "reports/advise/truth/truth.hpp"
#include "reports/cli/errors.hpp"

#include <fmt/format.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace halfway::advise {
namespace {

using nlohmann::json;
using reference::Scene;

/// A curve that is kept, the linear analyses of its body, and the canonical scene whose load it prolongs.
struct Kept {
  const char *curve, *linear, *scene, *title;
  double reach;  ///< of its load, over the scene's at load factor 1
};
/// The finest first.
constexpr Kept kAll[] = {
    {"fig_3", "linear_block", "c2_parallelepiped_small", "the block of Table 2 under its skewed moment", 1},
    {"fig_6", "linear_frustum_top", "c4_frustum",
     "the frustum of Table 3, top clamped, under its skewed moment", 1},
    {"fig_7", "linear_block", "c6_compression_shear", "the block of Table 2 under compression and shear", 1},
    {"range_block_moment", "linear_block", "c2_parallelepiped_small",
     "the block of Table 2 under its skewed moment", 300},
    {"range_frustum_moment", "linear_frustum_top", "c4_frustum",
     "the frustum of Table 3, top clamped, under its skewed moment", 10},
    {"range_block_force", "linear_block", "c6_compression_shear",
     "the block of Table 2 under compression and shear", 6}};

constexpr const char* kLaw = "cauchy_log";  ///< what the paper's program documents

Eigen::MatrixXd compliance_of(const Scene& scene) {
  const auto& law = std::get<reference::LinearSpec>(scene.joint.law);
  return law.is_compliance ? law.matrix : Eigen::MatrixXd(law.matrix.inverse());
}

/// Is it that body under that load, but for its size? Compliances as printed, in any frames of node a and b
/// alike.
bool is_of(const Scene& scene, const Scene& known) {
  if (scene.joint.kind != known.joint.kind || scene.loads.size() != 1) return false;
  if (!std::holds_alternative<reference::LinearSpec>(scene.joint.law)) return false;
  const auto same_ends = [](const JointEnd<double>& x, const JointEnd<double>& y) {
    return x.o.isApprox(y.o) && x.H.isApprox(y.H);
  };
  if (!same_ends(scene.joint.a, known.joint.a) || !same_ends(scene.joint.b, known.joint.b)) return false;
  const auto &load = scene.loads.front(), &its = known.loads.front();
  constexpr double kPrinted = 1e-4;  // six digits are
  return load.type == its.type && load.point.isApprox(its.point) && !load.held &&
         load.value.normalized().isApprox(its.value.normalized(), kPrinted) &&
         compliance_of(scene).isApprox(compliance_of(known), kPrinted);
}

/// The first that reaches the end of the scene; where none does the one that comes farthest.
const Kept* kept_of(const Scene& scene) {
  const Kept* last = nullptr;
  for (const Kept& kept : kAll) {
    const auto file = reference::scenes_folder() / (std::string(kept.scene) + ".toml");
    if (!std::filesystem::is_regular_file(file)) continue;
    const Scene known = reference::read_scene(file);
    if (!is_of(scene, known)) continue;
    const double asked =
        scene.factor_end * scene.loads.front().value.norm() / known.loads.front().value.norm();
    if (asked <= kept.reach * (1 + 1e-9)) return &kept;
    if (!last || kept.reach > last->reach) last = &kept;
  }
  return last;
}

json read_kept(const char* name) {
  return reference::read_data(fmt::format("fe/{}.json", name)).at("result");
}

Vec3<double> vector_of(const json& v) {
  return {v.at(0).get<double>(), v.at(1).get<double>(), v.at(2).get<double>()};
}

/// The mesh's own compliance, so that its discretisation is in neither side; what is rounding is made zero.
Eigen::MatrixXd mesh_compliance(const Kept& kept, const json& curve, Kind kind) {
  const json linear = read_kept(kept.linear);
  for (const json& run : linear.at("runs")) {
    if (run.at("element") != curve.at("element") || run.at("level") != curve.at("level")) continue;
    Eigen::MatrixXd C(6, 6);
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        C(i, j) = run.at("compliance").at(std::size_t(i)).at(std::size_t(j)).get<double>();
    C = (C + C.transpose()).eval() / 2;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        if (std::abs(C(i, j)) < 1e-9 * std::sqrt(C(i, i) * C(j, j))) C(i, j) = 0;
    return kind == Kind::angular ? Eigen::MatrixXd(C.bottomRightCorner(3, 3)) : C;
  }
  throw reference::DataError(fmt::format("fe/{}.json: no mesh of fe/{}.json", kept.linear, kept.curve));
}

Answers rows_of(const Scene& scene, const json& curve, double scale) {
  Answers out{scene.outputs, {}, {}};
  for (const json& point : curve.at("points")) {
    const Vec3<double> theta = vector_of(point.at("theta")), d = vector_of(point.at("d"));
    out.factor.push_back(scale * point.at("factor").get<double>());
    std::vector<double> row;
    for (const std::string& output : scene.outputs)
      row.push_back(output.starts_with("theta_") ? theta[output.back() - 'x'] : d[output.back() - 'x']);
    out.value.push_back(std::move(row));
  }
  return out;
}

/// Between the rows and rest by the polynomial through the six nearest: a solid's curve is smooth, its rows a
/// twentieth of it apart. A cubic is not enough: a coupling begins with the square of the load, its next term
/// is the fourth power.
std::vector<double> interpolated(const Answers& rows, double factor) {
  const auto count = rows.factor.size();
  const auto x = [&](std::size_t i) { return i == 0 ? 0 : rows.factor[i - 1]; };
  const auto y = [&](std::size_t i, std::size_t output) { return i == 0 ? 0 : rows.value[i - 1][output]; };
  const auto above = std::size_t(std::ranges::lower_bound(rows.factor, factor) - rows.factor.begin()) + 1;
  const std::size_t points = std::min<std::size_t>(6, count + 1);
  const std::size_t first = std::min(above < 3 ? 0 : above - 3, count + 1 - points);
  std::vector<double> out(rows.outputs.size(), 0);
  for (std::size_t i = first; i < first + points; ++i) {
    double weight = 1;
    for (std::size_t j = first; j < first + points; ++j)
      if (j != i) weight *= (factor - x(j)) / (x(i) - x(j));
    for (std::size_t output = 0; output < out.size(); ++output) out[output] += weight * y(i, output);
  }
  return out;
}

Answers answers_at(const Answers& rows, const std::vector<double>& factors) {
  Answers out{rows.outputs, factors, {}};
  for (const double factor : factors) {
    if (factor > rows.factor.back() * (1 + 1e-12)) {
      out.ended = "the kept curve ends";
      break;
    }
    out.value.push_back(interpolated(rows, factor));
  }
  return out;
}

}  // namespace

bool has_body(const Scene& scene) { return kept_of(scene) != nullptr; }

Truth body_truth(const Scene& scene) {
  const Kept* kept = kept_of(scene);
  if (!kept) {
    std::string allowed;
    for (const Kept& k : kAll)
      if (k.reach > 1) allowed += fmt::format("{}{} ({})", allowed.empty() ? "" : ", ", k.title, k.scene);
    throw reports::BadInput(fmt::format(
        "--truth body: scene {} is of no body whose 3D analysis is kept; allowed: {}; of another body "
        "give its own analysis, NAME.csv",
        scene.name, allowed));
  }
  const json file = reference::read_data(fmt::format("fe/{}.json", kept->curve));
  const auto& curves = file.at("result").at("curves");
  const auto curve = std::ranges::find_if(curves, [](const json& c) { return c.at("law") == kLaw; });
  if (curve == curves.end())
    throw reference::DataError(fmt::format("fe/{}.json: no curve of {}", kept->curve, kLaw));
  Truth out;
  out.kind = TruthKind::body;
  out.measure = Measure::each;
  out.described = fmt::format(
      "a nonlinear 3D analysis of {} (Cauchy stress = D : ln V), and its mesh's own compliance", kept->title);
  out.scene = scene;
  out.scene.joint.law = reference::LinearSpec{mesh_compliance(*kept, *curve, scene.joint.kind), true};
  const Vec3<double> full =
      vector_of(file.at("inputs").at(scene.joint.kind == Kind::angular ? "moment" : "force"));
  const Answers rows = rows_of(scene, *curve, full.norm() / scene.loads.front().value.norm());
  out.rows = rows.factor;
  out.at = [rows](const std::vector<double>& factors) { return answers_at(rows, factors); };
  return out;
}

}  // namespace halfway::advise
