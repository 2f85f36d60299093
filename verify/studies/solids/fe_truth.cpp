// The kept 3D results: still those of today's code, converged, the same by two elements, and beside the
// print.
#include "reference/truth/data.hpp"
#include "reference/truth/decoupling.hpp"
#include "reference/truth/fe/incompatible.hpp"
#include "verify/oracle/fe_access.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/worst.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace halfway::verify {
namespace {

namespace fe = reference::fe;
using fe::ElementKind;

constexpr const char* kBlocks[] = {"block", "frustum_top", "frustum_base"};

std::string axis_name(int k) { return fmt::format("{}{}", k < 3 ? "u" : "theta", k % 3 + 1); }

fe::Figure compliance(int k) {
  return [k](const fe::SecondOrder& s) { return s.compliance(k, k); };
}

/// The coarsest mesh computed again: the kept file is what today's code gives.
std::vector<Finding> recomputed(const fe::Characterisation& kept) {
  std::vector<Finding> out;
  const fe::Body& body = fe::body_named(kept.body);
  for (const fe::MeshRun& run : kept.runs) {
    if (run.level != kept.runs.front().level) continue;
    const fe::SecondOrder live = characterise(body, kept.joint_point, run.element, run.level).result;
    Measurement worst((live.compliance - run.result.compliance).norm() / live.compliance.norm(),
                      "compliance");
    for (std::size_t law = 0; law < fe::kLaws.size(); ++law) {
      double difference = 0, size = 0;
      for (std::size_t k = 0; k < 6; ++k) {
        difference += (live.couplings[law][k] - run.result.couplings[law][k]).squaredNorm();
        size += live.couplings[law][k].squaredNorm();
      }
      worst.include(std::sqrt(difference / size), std::string("couplings of ") + to_string(fe::kLaws[law]));
    }
    out.push_back(solid_finding(fmt::format("kept/{}/{}", kept.body, to_string(run.element)))
                      .in("relative")
                      .measured(worst)
                      .at_most(1e-9,
                               "the same computation; another BLAS or compiler rounds differently, times the "
                               "condition of the stiffness (1e4)")
                      .by(Oracle::kept));
  }
  return out;
}

/// Error bars of the figures that the report quotes.
std::vector<Finding> converged_figures(const std::string& name) {
  const fe::Characterisation& c = characterisation(name);
  std::vector<Finding> out;
  for (int k = 0; k < 6; ++k) {
    const fe::Estimate e = converged(c, ElementKind::hex20, compliance(k));
    out.push_back(
        solid_finding(fmt::format("error_bar/{}/{}", name, axis_name(k)))
            .in("relative")
            .measured(e.uncertainty / e.value,
                      fmt::format("{:.6g} +- {:.1e}, order {:.2f}", e.value, e.uncertainty, e.order))
            .at_most(1e-4, "the target of the 3D truth: grid convergence index of the finest of four meshes")
            .by(Oracle::independent));
  }
  for (fe::SolidLaw law : fe::kLaws) {
    const fe::Estimate e = converged(c, ElementKind::hex20,
                                     [law](const fe::SecondOrder& s) { return xi_of_moments(s, law, 0, 2); });
    out.push_back(solid_finding(fmt::format("error_bar/{}/xi/{}", name, to_string(law)))
                      .measured(e.uncertainty, fmt::format("xi = {:.6f} +- {:.1e}", e.value, e.uncertainty))
                      .at_most(1e-3, "the target of the 3D truth: grid convergence index")
                      .by(Oracle::independent));
  }
  return out;
}

/// Two elements, one answer: the difference over the sum of the error bars.
std::vector<Finding> elements_agree(const std::string& name, ElementKind other) {
  const fe::Characterisation& c = characterisation(name);
  std::vector<Finding> out;
  const auto hold = [&](const std::string& what, const fe::Figure& figure) {
    const fe::Estimate a = converged(c, ElementKind::hex20, figure), b = converged(c, other, figure);
    out.push_back(solid_finding(fmt::format("elements/{}/{}/{}", name, to_string(other), what))
                      .in("error bars")
                      .measured(std::abs(a.value - b.value) / (a.uncertainty + b.uncertainty),
                                fmt::format("{:.8g} +- {:.1e} and {:.8g} +- {:.1e}", a.value, a.uncertainty,
                                            b.value, b.uncertainty))
                      .at_most(1, "both extrapolate to the same solid: within the sum of their error bars")
                      .by(Oracle::independent));
  };
  for (int k = 0; k < 6; ++k) hold(axis_name(k), compliance(k));
  if (name == "block") return out;  // xi is exact there
  for (fe::SolidLaw law : fe::kLaws)
    hold(std::string("xi_") + to_string(law),
         [law](const fe::SecondOrder& s) { return xi_of_moments(s, law, 0, 2); });
  return out;
}

/// Of the four laws, which one's xi is the printed 0.55 to its two digits?
std::vector<Finding> printed_xi() {
  std::vector<Finding> out;
  const double printed =
      std::stod(reference::read_data("paper/tables.json")["table_3"]["fitted_xi"].get<std::string>());
  for (fe::SolidLaw law : fe::kLaws) {
    const fe::Estimate e = converged(characterisation("frustum_top"), ElementKind::hex20,
                                     [law](const fe::SecondOrder& s) { return xi_of_moments(s, law, 0, 2); });
    Draft f = solid_finding(std::string("frustum/printed_xi/") + to_string(law));
    f.measured(e.value, fmt::format("xi = {:.5f} +- {:.0e}, top clamped", e.value, e.uncertainty))
        .equal(printed, 0.005, "half a unit of the two digits printed")
        .by(Oracle::printed, e.uncertainty);
    if (law != fe::SolidLaw::cauchy_log)
      f.reported("another law than the one that the paper's program documents: reported");
    out.push_back(f);
  }
  return out;
}

/// A printed digit string against a mesh of the paper's kind, and against the converged value.
void compare(std::vector<Finding>& out, const std::string& table, int k, const nlohmann::json& text,
             double paper_mesh, double limit, const std::string& reason, const fe::Characterisation& c) {
  const double printed = std::stod(text.get<std::string>());
  out.push_back(solid_finding(table + "/paper_mesh/" + axis_name(k))
                    .in("relative")
                    .measured(std::abs(paper_mesh / printed - 1))
                    .at_most(limit, reason)
                    .by(Oracle::printed));
  const fe::Estimate e = converged(c, ElementKind::hex20, compliance(k));
  out.push_back(solid_finding(table + "/discretisation/" + axis_name(k))
                    .in("relative")
                    .measured(printed / e.value - 1)
                    .reported("the print's own discretisation error: printed over converged value, reported")
                    .by(Oracle::printed, e.uncertainty / e.value));
}

constexpr const char* kPrintReason =
    "six digits are printed: 5e-6 of the smallest leading digits, met to 3e-6";
constexpr std::array<int, 3> kPaperMesh = {10, 45, 10};

std::vector<Finding> table_two() {
  const fe::TaperedBlock size{5, {30, 5}, {30, 5}};
  const fe::Mesh mesh = tapered_block(ElementKind::hex8i, size, kPaperMesh, 1);
  const fe::Mat6 C = tapped(incompatible_compliance(mesh, {1, 0.3}, {2.5, 0, 0}));
  const auto table = reference::read_data("paper/tables.json")["table_2"];
  std::vector<Finding> out;
  for (int k = 0; k < 3; ++k) {
    const bool third = k == 2;
    compare(out, "table_2", k, table["linear_compliance"][std::size_t(k)], C(k, k), third ? 3e-4 : 3e-6,
            third ? "printed as 0.2159 - 0.035959^2 / 0.014384: a difference of numbers already rounded to "
                    "four and "
                    "five digits, 0.00005 / 0.126"
                  : kPrintReason,
            characterisation("block"));
    compare(out, "table_2", 3 + k, table["angular_compliance"][std::size_t(k)], C(3 + k, 3 + k), 3e-6,
            kPrintReason, characterisation("block"));
  }
  return out;
}

/// The printed height is 10 m; the digits are those of 20 m.
std::vector<Finding> table_three() {
  const auto table = reference::read_data("paper/tables.json")["table_3"];
  const fe::Mesh mesh = tapered_block(ElementKind::hex8i, {20, {10, 5}, {30, 5}}, kPaperMesh, 1);
  const fe::Mat6 C = tapped(incompatible_compliance(mesh, {1, 0.3}, {20, 0, 0}));
  std::vector<Finding> out;
  for (int k = 0; k < 3; ++k) {
    const auto& text = table["angular_compliance"][std::size_t(k)];
    compare(out, "table_3", 3 + k, text, C(3 + k, 3 + k), 3e-6, kPrintReason,
            characterisation("frustum_top"));
    const fe::Estimate wrong =
        converged(characterisation("frustum_printed"), ElementKind::hex20, compliance(3 + k));
    out.push_back(solid_finding("table_3/printed_height/" + axis_name(3 + k))
                      .in("relative")
                      .measured(std::stod(text.get<std::string>()) / wrong.value - 1)
                      .within(0.44, 1.27,
                              "known misprint: with the printed height of 10 m the body is 45 to 126 % too "
                              "stiff (two digits)")
                      .by(Oracle::printed));
  }
  return out;
}

/// (51) entry by entry as printed, at the free face; its decoupling point is the centroid.
std::vector<Finding> matrix_51() {
  const fe::Mesh mesh = tapered_block(ElementKind::hex8i, {5, {30, 5}, {30, 5}}, kPaperMesh, 1);
  const fe::Mat6 C = tapped(incompatible_compliance(mesh, {1, 0.3}, {5, 0, 0}));
  const auto printed = reference::read_data("paper/tables.json")["matrix_51"]["printed"];
  std::vector<Finding> out;
  Measurement worst;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      const std::string text = printed[i][j].get<std::string>();
      const double unit = std::pow(10, std::stoi(text.substr(text.find('e') + 1)) - 3);
      const double off = std::abs(C(Eigen::Index(i), Eigen::Index(j)) - std::stod(text)) / unit;
      worst.include(off, fmt::format("F{}{}", i + 1, j + 1));
    }
  }
  out.push_back(solid_finding("matrix_51/paper_mesh")
                    .in("units of the last digit")
                    .measured(worst)
                    .at_most(0.5, "half a unit of the last printed digit")
                    .by(Oracle::printed));
  const auto d = reference::decouple<double>(C);
  out.push_back(solid_finding("matrix_51/joint_point")
                    .in("m")
                    .measured(d.x[0])
                    .equal(-2.5, 1e-9, "the centroid, by symmetry; rounding")
                    .by(Oracle::closed_form));
  return out;
}

}  // namespace

void fe_truth(Checks& checks) {
  for (const char* name : kBlocks) {
    checks.push_back(
        {std::string("fe/kept/") + name, "fe", [name] { return recomputed(characterisation(name)); }});
    checks.push_back({std::string("fe/error_bar/") + name, "fe", [name] { return converged_figures(name); }});
    for (ElementKind other : {ElementKind::hex20_full, ElementKind::hex27}) {
      checks.push_back({fmt::format("fe/elements/{}/{}", name, to_string(other)), "fe",
                        [name, other] { return elements_agree(name, other); }});
    }
  }
  checks.push_back({"fe/printed_xi", "fe", printed_xi});
  checks.push_back({"fe/table_2", "fe", table_two});
  checks.push_back({"fe/table_3", "fe", table_three});
  checks.push_back({"fe/matrix_51", "fe", matrix_51});
}

}  // namespace halfway::verify
