// The sums over elements and their scattering into the interior's sparse columns and the face's block.
#include "reference/truth/fe/solid.hpp"

#include <thread>

namespace halfway::reference::fe {

void Solid::scatter(Eigen::Index element, const Eigen::MatrixXd& K, Assembly& out) const {
  const Eigen::Index nodes = mesh_.elements.rows();
  const int* outer = out.K.outerIndexPtr();
  double* values = out.K.valuePtr();
  for (Eigen::Index b = 0; b < nodes; ++b) {
    const int column = 3 * numbering_.interior[std::size_t(mesh_.elements(b, element))];
    if (column < 0) continue;
    for (Eigen::Index a = 0; a < nodes; ++a) {
      const int slot = slots_(a + nodes * b, element);
      if (slot < 0) continue;
      for (int c = 0; c < 3; ++c) {
        // The first block of a column keeps its rows c, ..., 2 only: 3 slot - c rows stand before row 0.
        double* target = values + outer[column + c] + 3 * slot - c;
        for (int r = slot == 0 ? c : 0; r < 3; ++r) target[r] += K(3 * a + r, 3 * b + c);
      }
    }
  }
}

void Solid::scatter_face(Eigen::Index element, const Eigen::MatrixXd& K, const State& state,
                         Assembly& out) const {
  const Eigen::Index nodes = mesh_.elements.rows();
  Eigen::Matrix<double, Eigen::Dynamic, 6> motion =
      Eigen::Matrix<double, Eigen::Dynamic, 6>::Zero(3 * nodes, 6);
  bool touches = false;
  for (Eigen::Index a = 0; a < nodes; ++a) {
    const int i = numbering_.face[std::size_t(mesh_.elements(a, element))];
    if (i < 0) continue;
    touches = true;
    const Vec3<double> arm = state.R * arms_.col(i);
    motion.block<3, 3>(3 * a, 0).setIdentity();
    motion.block<3, 3>(3 * a, 3) = -skew<double>(arm);
  }
  if (!touches) return;
  const Eigen::Matrix<double, Eigen::Dynamic, 6> K_motion = K.selfadjointView<Eigen::Lower>() * motion;
  out.face += motion.transpose() * K_motion;
  for (Eigen::Index a = 0; a < nodes; ++a) {
    const int place = numbering_.interior[std::size_t(mesh_.elements(a, element))];
    if (place >= 0) out.K_face.middleRows<3>(3 * place) += K_motion.middleRows<3>(3 * a);
  }
}

template <int nodes>
void Solid::assemble_range(SolidLaw law, const State& state, Eigen::Index begin, Eigen::Index end,
                           Assembly& out) const {
  const Eigen::Index n_points = points();
  Eigen::Matrix<double, Eigen::Dynamic, 3 * nodes> B(6 * n_points, 3 * nodes), DB(6 * n_points, 3 * nodes);
  Eigen::Matrix<double, Eigen::Dynamic, nodes> G(3 * n_points, nodes), SG(3 * n_points, nodes);
  Eigen::MatrixXd K(3 * nodes, 3 * nodes);
  Eigen::Matrix<double, nodes, nodes> geometric;
  for (Eigen::Index e = begin; e < end; ++e) {
    Eigen::Matrix<double, 3, nodes> u, f = Eigen::Matrix<double, 3, nodes>::Zero();
    for (int a = 0; a < nodes; ++a) u.col(a) = state.u.col(mesh_.elements(a, e));
    for (Eigen::Index p = 0; p < n_points; ++p) {
      const Eigen::Matrix<double, 3, nodes> g = gradients(e, p);
      const Mat3<double> H = u * g.transpose();
      const Mat3<double> F = Mat3<double>::Identity() + H;
      const LawResponse6 r = respond(law, material_, (H + H.transpose() + H.transpose() * H) / 2);
      const double w = volume(e, p);
      Mat3<double> S;
      S << r.S[0], r.S[3], r.S[5], r.S[3], r.S[1], r.S[4], r.S[5], r.S[4], r.S[2];
      f += w * (F * S) * g;
      for (int a = 0; a < nodes; ++a) {
        for (int k = 0; k < 3; ++k) {
          auto b = B.col(3 * a + k).template segment<6>(6 * p);
          b << F(k, 0) * g(0, a), F(k, 1) * g(1, a), F(k, 2) * g(2, a), F(k, 0) * g(1, a) + F(k, 1) * g(0, a),
              F(k, 1) * g(2, a) + F(k, 2) * g(1, a), F(k, 0) * g(2, a) + F(k, 2) * g(0, a);
        }
      }
      const Mat6 D = w / 2 * (r.D + r.D.transpose());
      DB.template middleRows<6>(6 * p).noalias() = D * B.template middleRows<6>(6 * p);
      G.template middleRows<3>(3 * p) = g;
      SG.template middleRows<3>(3 * p) = w * S * g;
    }
    K.template triangularView<Eigen::Lower>() = B.transpose() * DB;
    geometric.noalias() = G.transpose() * SG;
    for (int b = 0; b < nodes; ++b) {
      for (int a = b; a < nodes; ++a) {
        for (int k = 0; k < 3; ++k) K(3 * a + k, 3 * b + k) += geometric(a, b);
      }
    }
    // scatter reads pairs in global order, so both halves are wanted.
    K.template triangularView<Eigen::StrictlyUpper>() = K.transpose();
    for (int a = 0; a < nodes; ++a) out.force.col(mesh_.elements(a, e)) += f.col(a);
    scatter(e, K, out);
    scatter_face(e, K, state, out);
  }
}

template <int nodes>
Assembly Solid::assemble_all(SolidLaw law, const State& state) const {
  const auto empty = [&] {
    Assembly a;
    a.force = Eigen::Matrix3Xd::Zero(3, mesh_.X.cols());
    a.K = pattern_;
    a.K_face = Eigen::Matrix<double, Eigen::Dynamic, 6>::Zero(interior_unknowns(), 6);
    a.face = Mat6::Zero();
    return a;
  };
  // Two threads, each with its own sums: added in a fixed order, so that every run gives the same digits.
  Assembly first = empty(), second = empty();
  const Eigen::Index half = mesh_.elements.cols() / 2;
  std::thread other([&] { assemble_range<nodes>(law, state, half, mesh_.elements.cols(), second); });
  assemble_range<nodes>(law, state, 0, half, first);
  other.join();
  first.force += second.force;
  Eigen::Map<Eigen::VectorXd>(first.K.valuePtr(), first.K.nonZeros()) +=
      Eigen::Map<const Eigen::VectorXd>(second.K.valuePtr(), second.K.nonZeros());
  first.K_face += second.K_face;
  first.face += second.face;
  return first;
}

Assembly Solid::assemble(SolidLaw law, const State& state) const {
  Assembly a =
      mesh_.element == ElementKind::hex27 ? assemble_all<27>(law, state) : assemble_all<20>(law, state);
  // The arm turns with the face: d(arm x f) = (dw x arm) x f = f x (arm x dw).
  for (std::size_t i = 0; i < mesh_.rigid.size(); ++i) {
    const Vec3<double> arm = state.R * arms_.col(Eigen::Index(i)), f = a.force.col(mesh_.rigid[i]);
    a.face.bottomRightCorner<3, 3>() += skew<double>(f) * skew<double>(arm);
  }
  return a;
}

}  // namespace halfway::reference::fe
