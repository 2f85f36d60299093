#include "reference/truth/fe/second_order.hpp"

namespace halfway::reference::fe {
namespace {

// Let u = e u_1 + e^2 u_2 and let U_k be the first-order field of the unit load k, w_k its face's rotation
// and r_k its nodal forces. On the face u_2 = linear motion by q_2 + psi x (psi x X) / 2. Tested with U_k,
// the virtual work of second order reads, because U_k is in equilibrium with the unit load,
//   q_2k = - sum_face r_k . psi x (psi x X) / 2                    the face turns by a finite angle
//          - integral S_k : H^T H / 2 + S : H^T H_k + S_2(E) : E_k     stress quadratic in the gradient H
//          - sum_face r . w_k x (psi x X)                          the arms of the moments turn.
// No second solve is needed, and S_2 is linear in four constants of the law.

/// One trilinear form per constant, and one for what every law shares.
using Forms = std::array<Couplings, 5>;

Mat3<double> second_piola(const Material& material, const Mat3<double>& E) {
  return material.lambda() * E.trace() * Mat3<double>::Identity() + 2 * material.mu() * E;
}

double contract(const Mat3<double>& a, const Mat3<double>& b) { return a.cwiseProduct(b).sum(); }

struct PointFields {
  std::array<Mat3<double>, 6> H, E, S;
};

/// The volume's share of one integration point of weight w.
void add_point(const PointFields& p, double w, Forms& forms) {
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) {
      const Mat3<double>&Hi = p.H[i], &Hj = p.H[j], &Ei = p.E[i], &Ej = p.E[j];
      const Mat3<double> HH = Hi.transpose() * Hj, EE = (Ei * Ej + Ej * Ei) / 2;
      const Mat3<double> HS = (Hi * p.S[j] + Hj * p.S[i]) / 2,
                         mixed = (Ei.trace() * Ej + Ej.trace() * Ei) / 2;
      const double traces = Ei.trace() * Ej.trace(), trace_of_product = EE.trace();
      for (int k = 0; k < 6; ++k) {
        const double tr = p.E[k].trace();
        const std::array<double, 5> value = {contract(p.S[k], HH) / 2 + contract(HS, p.H[k]), traces * tr,
                                             trace_of_product * tr, contract(mixed, p.E[k]),
                                             contract(EE, p.E[k])};
        for (std::size_t c = 0; c < 5; ++c) forms[c][std::size_t(k)](i, j) -= w * value[c];
      }
    }
  }
}

/// The face's share, with the nodal forces of the six fields.
void add_face(const Solid& solid, const Mat6& compliance, const std::array<Eigen::Matrix3Xd, 6>& force,
              Couplings& shared) {
  const auto psi = [&](int i) { return Vec3<double>(compliance.col(i).tail<3>()); };
  for (std::size_t n = 0; n < solid.mesh().rigid.size(); ++n) {
    const Vec3<double> X = solid.arms().col(Eigen::Index(n));
    const auto r = [&](int i) { return Vec3<double>(force[std::size_t(i)].col(solid.mesh().rigid[n])); };
    for (int i = 0; i < 6; ++i) {
      for (int j = i; j < 6; ++j) {
        const Vec3<double> turn_i = psi(i).cross(X), turn_j = psi(j).cross(X);
        const Vec3<double> second = (psi(i).cross(turn_j) + psi(j).cross(turn_i)) / 4;
        const Vec3<double> moment = (turn_j.cross(r(i)) + turn_i.cross(r(j))) / 2;
        for (int k = 0; k < 6; ++k) shared[std::size_t(k)](i, j) -= r(k).dot(second) + psi(k).dot(moment);
      }
    }
  }
}

}  // namespace

SecondOrder second_order(const Solid& solid, const Statics::Linear& linear) {
  Forms forms;
  for (auto& form : forms) form.fill(Mat6::Zero());
  std::array<Eigen::Matrix3Xd, 6> force;
  for (auto& f : force) f = Eigen::Matrix3Xd::Zero(3, solid.mesh().X.cols());
  const Eigen::MatrixXi& elements = solid.mesh().elements;
  for (Eigen::Index e = 0; e < elements.cols(); ++e) {
    for (Eigen::Index p = 0; p < solid.points(); ++p) {
      const auto gradients = solid.gradients(e, p);
      const double w = solid.volume(e, p);
      PointFields fields;
      for (std::size_t k = 0; k < 6; ++k) {
        fields.H[k] = linear.u[k](Eigen::all, elements.col(e)) * gradients.transpose();
        fields.E[k] = (fields.H[k] + fields.H[k].transpose()) / 2;
        fields.S[k] = second_piola(solid.material(), fields.E[k]);
        const Eigen::Matrix3Xd nodal = w * fields.S[k] * gradients;
        for (Eigen::Index a = 0; a < elements.rows(); ++a) force[k].col(elements(a, e)) += nodal.col(a);
      }
      add_point(fields, w, forms);
    }
  }
  add_face(solid, linear.compliance, force, forms[0]);

  SecondOrder out{linear.compliance, {}};
  for (std::size_t law = 0; law < kLaws.size(); ++law) {
    const Quadratic p = quadratic(kLaws[law], solid.material());
    for (std::size_t k = 0; k < 6; ++k) {
      Mat6 Q = forms[0][k];
      for (std::size_t c = 0; c < 4; ++c) Q += p[c] * forms[c + 1][k];
      out.couplings[law][k] = Q.selfadjointView<Eigen::Upper>();
    }
  }
  return out;
}

}  // namespace halfway::reference::fe
