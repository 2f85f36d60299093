#include "reference/truth/fe/studies/characterisation.hpp"

#include "reference/truth/decoupling.hpp"

#include <cmath>
#include <ctime>

namespace halfway::reference::fe {
namespace {

constexpr int kCoarse = 4;

double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

Statics::Linear linear_at(const Solid& solid) { return Statics(solid).linear(); }

nlohmann::json rows(const Mat6& m) {
  nlohmann::json out = nlohmann::json::array();
  for (int i = 0; i < 6; ++i) {
    nlohmann::json row = nlohmann::json::array();
    for (int j = 0; j < 6; ++j) row.push_back(m(i, j));
    out.push_back(row);
  }
  return out;
}

Mat6 matrix(const nlohmann::json& json) {
  Mat6 m;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) m(i, j) = json.at(std::size_t(i)).at(std::size_t(j)).get<double>();
  }
  return m;
}

/// The axis that is neither i nor j, and +1 if (i, j, k) is an even permutation.
int third(int i, int j) { return 3 - i - j; }
double parity(int i, int j) { return (j - i + 3) % 3 == 1 ? 1 : -1; }

}  // namespace

Vec3<double> joint_point(const Body& body) {
  const Solid solid(body.mesh(ElementKind::hex20, kCoarse), body.material, body.face);
  const Vec3<double> x = decouple<double>(linear_at(solid).compliance).x;
  const double length = solid.mesh().X.row(0).maxCoeff() - solid.mesh().X.row(0).minCoeff();
  const double step = 1e-4 * length;
  return {std::round(x[0] / step) * step, 0, 0};
}

MeshRun characterise(const Body& body, const Vec3<double>& joint_point, ElementKind element, int level) {
  const double begin = cpu_seconds();
  const Solid solid(body.mesh(element, level), body.material, body.face + joint_point);
  const SecondOrder result = second_order(solid, linear_at(solid));
  return {element, level, solid.unknowns(), cpu_seconds() - begin, result};
}

Estimate converged(const Characterisation& c, ElementKind element, const Figure& figure) {
  std::vector<Sample> samples;
  for (const MeshRun& run : c.runs) {
    if (run.element == element) samples.push_back({double(run.level), figure(run.result)});
  }
  return richardson(samples);
}

// With diagonal F: theta_2nd = -xi F (F m x m), whose component k is -parity xi F_k (F_i - F_j) m_i m_j.
double xi_of_moments(const SecondOrder& s, SolidLaw law, int i, int j) {
  const int k = third(i, j);
  const Vec3<double> F = s.compliance.diagonal().tail<3>();
  return -parity(i, j) * 2 * s.couplings[std::size_t(law)][std::size_t(3 + k)](3 + i, 3 + j) /
         (F[k] * (F[i] - F[j]));
}

double xi_of_forces(const SecondOrder& s, SolidLaw law, int i, int j) {
  const int k = third(i, j);
  const Vec3<double> u = s.compliance.diagonal().head<3>(), F = s.compliance.diagonal().tail<3>();
  return parity(i, j) * 2 * s.couplings[std::size_t(law)][std::size_t(3 + k)](i, j) / (F[k] * (u[i] - u[j]));
}

void to_json(nlohmann::json& json, const Characterisation& c) {
  json = {{"body", c.body}, {"joint_point", {c.joint_point[0], c.joint_point[1], c.joint_point[2]}}};
  for (const MeshRun& run : c.runs) {
    nlohmann::json row = {{"element", to_string(run.element)},
                          {"level", run.level},
                          {"unknowns", run.unknowns},
                          {"seconds", run.seconds},
                          {"compliance", rows(run.result.compliance)}};
    for (std::size_t law = 0; law < kLaws.size(); ++law) {
      for (const Mat6& Q : run.result.couplings[law])
        row["couplings"][to_string(kLaws[law])].push_back(rows(Q));
    }
    json["runs"].push_back(row);
  }
}

void from_json(const nlohmann::json& json, Characterisation& c) {
  c.body = json.at("body").get<std::string>();
  for (int i = 0; i < 3; ++i) c.joint_point[i] = json.at("joint_point").at(std::size_t(i)).get<double>();
  for (const auto& row : json.at("runs")) {
    MeshRun run{element_kind(row.at("element").get<std::string>()),
                row.at("level").get<int>(),
                row.at("unknowns").get<int>(),
                row.at("seconds").get<double>(),
                {matrix(row.at("compliance")), {}}};
    for (std::size_t law = 0; law < kLaws.size(); ++law) {
      for (std::size_t k = 0; k < 6; ++k)
        run.result.couplings[law][k] = matrix(row.at("couplings").at(to_string(kLaws[law])).at(k));
    }
    c.runs.push_back(std::move(run));
  }
}

}  // namespace halfway::reference::fe
