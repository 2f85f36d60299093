// The solid's assembly: tangent, objectivity, balance, patch test, and perturbation against Newton.
#include "halfway/rotations/so3.hpp"
#include "reference/numbers/random.hpp"
#include "reference/truth/fe/incompatible.hpp"
#include "reference/truth/fe/studies/characterisation.hpp"
#include "verify/oracle/fe_access.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <cmath>

namespace halfway::verify {
namespace {

namespace fe = reference::fe;

fe::Solid small_solid(fe::ElementKind element) {
  const fe::TaperedBlock body{2, {1, 0.7}, {0.6, 0.8}};
  return {tapered_block(element, body, {2, 2, 2}, 2), {1, 0.3}, {2.1, 0.1, -0.2}};
}

/// Interior displacements of some 2 % of the body, face turned by 0.05 rad.
fe::State deformed(const fe::Solid& solid, reference::Generator& g) {
  fe::State state = solid.unloaded();
  Eigen::VectorXd u(solid.interior_unknowns());
  for (double& x : u) x = g.uniform(-0.01, 0.01);
  fe::Vec6 q;
  for (double& x : q) x = g.uniform(-0.03, 0.03);
  solid.move(state, u, q);
  return state;
}

/// Force in all unknowns: interior, then face.
Eigen::VectorXd balance(const fe::Solid& solid, fe::SolidLaw law, const fe::State& state) {
  const fe::Assembly a = solid.assemble(law, state);
  Eigen::VectorXd out(solid.unknowns());
  out << solid.interior(a.force), solid.face_load(state, a.force);
  return tapped(out);
}

/// The assembled tangent times a direction against a fourth-order difference of the assembled forces.
Finding tangent(fe::ElementKind element, fe::SolidLaw law) {
  const fe::Solid solid = small_solid(element);
  reference::Generator g(5);
  const fe::State state = deformed(solid, g);
  Eigen::VectorXd du(solid.interior_unknowns());
  for (double& x : du) x = g.uniform(-1, 1);
  fe::Vec6 dq;
  for (double& x : dq) x = g.uniform(-1, 1);
  const fe::Assembly a = solid.assemble(law, state);
  Eigen::VectorXd analytic(solid.unknowns());
  analytic << a.K.selfadjointView<Eigen::Lower>() * du + a.K_face * dq,
      a.K_face.transpose() * du + a.face * dq;
  constexpr double h = 1e-4;
  const auto at = [&](double s) {
    fe::State moved = state;
    solid.move(moved, s * h * du, s * h * dq);
    return balance(solid, law, moved);
  };
  const Eigen::VectorXd difference = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
  return solid_finding(std::string("solid/tangent/") + to_string(element) + "/" + to_string(law))
      .in("relative")
      .measured((analytic - difference).norm() / difference.norm())
      .at_most(1e-9, "fourth-order difference, step 1e-4 of the body: truncation and rounding near 1e-11")
      .by(Oracle::independent);
}

/// A clamped face that moves with the rest: no strain, no force. The whole body turned by 1.3 rad.
Finding objectivity(fe::SolidLaw law) {
  const fe::Solid solid = small_solid(fe::ElementKind::hex20);
  reference::Generator g(6);
  fe::State state = deformed(solid, g);
  const Eigen::Matrix3Xd before = solid.assemble(law, state).force;
  const Mat3<double> R = so3::exp<double>(1.3 * g.direction());
  state.u = R * (solid.mesh().X + state.u) - solid.mesh().X;
  const Eigen::Matrix3Xd after = tapped(solid.assemble(law, state).force);
  return solid_finding(std::string("solid/objectivity/") + to_string(law))
      .in("relative")
      .measured((after - R * before).norm() / before.norm())
      .at_most(1e-12, "rounding of a displacement of 1 m with strains of 1e-2, over some tens of sums")
      .by(Oracle::independent);
}

/// A uniform gradient on a tapered mesh: P is uniform, so the divergence theorem gives
/// sum over all nodes f_i . G X_i = volume P : G for every G, with the volume of the body in closed form.
Finding patch(fe::ElementKind element) {
  const fe::Solid solid = small_solid(element);
  const fe::Material& material = solid.material();
  reference::Generator g(7);
  Mat3<double> H, G;
  for (double& x : H.reshaped()) x = g.uniform(-1e-2, 1e-2);
  for (double& x : G.reshaped()) x = g.uniform(-1, 1);
  fe::State state = solid.unloaded();
  state.u = H * solid.mesh().X;
  const double work =
      solid.assemble(fe::SolidLaw::st_venant, state).force.cwiseProduct(G * solid.mesh().X).sum();
  const Mat3<double> I = Mat3<double>::Identity(), F = I + H, E = (F.transpose() * F - I) / 2;
  const Mat3<double> P = F * (material.lambda() * E.trace() * I + 2 * material.mu() * E);
  const double volume = 2 * ((1 * 0.7 + 0.6 * 0.8) / 3 + (1 * 0.8 + 0.6 * 0.7) / 6);
  return solid_finding(std::string("solid/patch/") + to_string(element))
      .in("relative")
      .measured(std::abs(work / (volume * P.cwiseProduct(G).sum()) - 1))
      .at_most(1e-12, "exact but for rounding in some thousand sums: the gradient is uniform")
      .by(Oracle::closed_form);
}

/// The 13 incompatible modes leave a uniform strain alone: the stiffness times u = H X gives the forces of
/// the uniform stress, on a distorted element.
Finding patch_incompatible() {
  reference::Generator g(8);
  Eigen::Matrix<double, 3, 8> X;
  const auto& nodes = fe::reference_element(fe::ElementKind::hex8i).nodes;
  for (int a = 0; a < 8; ++a) X.col(a) = nodes[std::size_t(a)].cast<double>() + g.vector(0.25);
  const fe::Material material{1, 0.3};
  Mat3<double> H, G;
  for (double& x : H.reshaped()) x = g.uniform(-1, 1);
  for (double& x : G.reshaped()) x = g.uniform(-1, 1);
  const auto K = fe::incompatible_stiffness(X, material);
  const auto flat = [](const Eigen::Matrix<double, 3, 8>& m) {
    return Eigen::Map<const Eigen::VectorXd>(m.data(), 24).eval();
  };
  const Eigen::VectorXd u = flat(H * X), v = flat(G * X);
  const Mat3<double> E = (H + H.transpose()) / 2;
  const Mat3<double> S = material.lambda() * E.trace() * Mat3<double>::Identity() + 2 * material.mu() * E;
  const fe::ReferenceElement& element = fe::reference_element(fe::ElementKind::hex8i);
  double volume = 0;
  for (std::size_t p = 0; p < element.points.size(); ++p)
    volume += element.weights[p] * Mat3<double>(X * element.dN[p].transpose()).determinant();
  return solid_finding("solid/patch/hex8i")
      .in("relative")
      .measured(std::abs(v.dot(K * u) / (volume * S.cwiseProduct(G).sum()) - 1))
      .at_most(1e-12, "exact but for rounding: the modes are orthogonal to it")
      .by(Oracle::closed_form);
}

}  // namespace

void fe_solid(Checks& checks) {
  checks.push_back(
      {"fe/solid", "fe", [] {
         std::vector<Finding> out = {patch_incompatible()};
         for (auto element : {fe::ElementKind::hex20, fe::ElementKind::hex20_full, fe::ElementKind::hex27})
           out.push_back(patch(element));
         for (fe::SolidLaw law : fe::kLaws) out.push_back(objectivity(law));
         for (fe::SolidLaw law : {fe::SolidLaw::st_venant, fe::SolidLaw::neo_hooke, fe::SolidLaw::hencky}) {
           for (auto element : {fe::ElementKind::hex20, fe::ElementKind::hex20_full, fe::ElementKind::hex27})
             out.push_back(tangent(element, law));
         }
         return out;
       }});
}

}  // namespace halfway::verify
