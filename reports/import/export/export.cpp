#include "reports/import/export/export.hpp"

#include "reports/import/readers/readers.hpp"

#include <fmt/format.h>

namespace halfway::imports {
namespace {

/// Angles and their functions turn a rotation by some roundings of 1e-16.
constexpr double kFrames = 4e-15;

void demand_same_end(const char* node, const JointEnd<double>& written, const JointEnd<double>& back) {
  if (written.o != back.o) throw std::runtime_error(fmt::format("offset_{} came back otherwise", node));
  const double off = (written.H - back.H).cwiseAbs().maxCoeff();
  if (!(off <= kFrames))
    throw std::runtime_error(fmt::format("frame_{} came back otherwise, by {:.1g}", node, off));
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> all = {
      {"bus", ".bus", bus_of}, {"osim", ".osim", osim_of}, {"mbdyn", ".mbd", mbdyn_of}};
  return all;
}

const Eigen::MatrixXd& stiffness_of_scene(const reference::Scene& scene, const char* target) {
  const auto* linear = std::get_if<reference::LinearSpec>(&scene.joint.law);
  if (!linear)
    throw CannotSay(fmt::format(
        "{}: joint.law: is not linear, which {} cannot say here; allowed: type = \"linear\", stiffness",
        scene.name, target));
  if (linear->is_compliance)
    throw CannotSay(fmt::format("{}: joint.law.compliance: its inverse would lose digits; allowed: stiffness",
                                scene.name));
  return linear->matrix;
}

void demand_diagonal(const Eigen::MatrixXd& K, const char* target) {
  for (Eigen::Index i = 0; i < K.rows(); ++i) {
    for (Eigen::Index j = 0; j < K.cols(); ++j) {
      if (i != j && K(i, j) != 0)
        throw CannotSay(
            fmt::format("joint.law.stiffness: couples strains {} and {} ({}), which {} cannot say; allowed: "
                        "a diagonal stiffness",
                        i + 1, j + 1, K(i, j), target));
    }
  }
}

void demand_kind(const reference::Scene& scene, Kind kind, const char* target) {
  if (scene.joint.kind != kind)
    throw CannotSay(fmt::format(
        "{}: joint.kind: {} knows joints of six strains alone; allowed: linear_angular", scene.name, target));
}

std::string digits_of(double value) { return fmt::format("{}", value + 0.0); }

std::string words_of(const Eigen::VectorXd& values, const char* between) {
  std::string out;
  for (double value : values) out += (out.empty() ? "" : between) + digits_of(value);
  return out;
}

void demand_same(const ExportRequest& request, const Exported& exported) {
  const auto back = read_joints(exported.text, {});
  const auto& joint = request.scene.joint;
  if (back.size() != 1) throw std::runtime_error(fmt::format("{} joints came back", back.size()));
  if (back[0].kind != joint.kind || back[0].K != std::get<reference::LinearSpec>(joint.law).matrix)
    throw std::runtime_error("the stiffness came back otherwise");
  if (request.law_only) return;
  if (back[0].formulation != request.formulation)
    throw std::runtime_error("the formulation came back otherwise");
  JointEnd<double> a = joint.a, b = joint.b;
  if (joint.kind == Kind::angular) a.o.setZero(), b.o.setZero();  // of no effect, and left out
  demand_same_end("a", a, back[0].a);
  demand_same_end("b", b, back[0].b);
}

}  // namespace halfway::imports
