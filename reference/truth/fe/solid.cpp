#include "reference/truth/fe/solid.hpp"

#include "halfway/rotations/so3.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <stdexcept>

namespace halfway::reference::fe {

Solid::Solid(Mesh mesh, const Material& material, const Vec3<double>& reference_point)
    : mesh_(std::move(mesh)), material_(material), reference_point_(reference_point) {
  if (mesh_.element == ElementKind::hex8i)
    throw std::invalid_argument("element is \"hex8i\"; it serves linear analysis only");
  check(material_);
  numbering_ = number_nodes(mesh_);
  find_arms();
  find_gradients();
  find_pattern();
}

void Solid::find_arms() {
  arms_.resize(3, Eigen::Index(mesh_.rigid.size()));
  for (std::size_t i = 0; i < mesh_.rigid.size(); ++i)
    arms_.col(Eigen::Index(i)) = mesh_.X.col(mesh_.rigid[i]) - reference_point_;
}

void Solid::find_gradients() {
  const ReferenceElement& reference = reference_element(mesh_.element);
  const auto nodes = Eigen::Index(reference.nodes.size()), points = Eigen::Index(reference.points.size());
  volumes_.resize(points, mesh_.elements.cols());
  gradients_.resize(3, nodes * points * mesh_.elements.cols());
  for (Eigen::Index e = 0; e < mesh_.elements.cols(); ++e) {
    const Eigen::Matrix3Xd X = mesh_.X(Eigen::all, mesh_.elements.col(e));
    for (Eigen::Index p = 0; p < points; ++p) {
      const Eigen::Matrix3Xd& dN = reference.dN[std::size_t(p)];
      const Mat3<double> J = X * dN.transpose();
      gradients_.middleCols((e * points + p) * nodes, nodes) = J.inverse().transpose() * dN;
      volumes_(p, e) = reference.weights[std::size_t(p)] * J.determinant();
    }
  }
}

Eigen::Map<const Eigen::Matrix3Xd> Solid::gradients(Eigen::Index element, Eigen::Index point) const {
  const Eigen::Index nodes = mesh_.elements.rows();
  return {gradients_.data() + 3 * nodes * (element * points() + point), 3, nodes};
}

// Block columns of 3: the lower half of the diagonal block, then 3 rows per lower neighbour.
void Solid::find_pattern() {
  std::vector<std::vector<int>> rows(std::size_t(numbering_.interior_count), std::vector<int>{});
  const Eigen::Index nodes = mesh_.elements.rows();
  const auto place = [&](Eigen::Index e, Eigen::Index a) {
    return numbering_.interior[std::size_t(mesh_.elements(a, e))];
  };
  for (Eigen::Index e = 0; e < mesh_.elements.cols(); ++e) {
    for (Eigen::Index b = 0; b < nodes; ++b) {
      for (Eigen::Index a = 0; a < nodes; ++a) {
        if (place(e, b) >= 0 && place(e, a) >= place(e, b))
          rows[std::size_t(place(e, b))].push_back(place(e, a));
      }
    }
  }
  std::vector<int> outer = {0}, inner;
  for (auto& column : rows) {
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
    for (int c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < column.size(); ++i) {
        for (int r = i == 0 ? c : 0; r < 3; ++r) inner.push_back(3 * column[i] + r);
      }
      outer.push_back(int(inner.size()));
    }
  }
  const std::vector<double> zeros(inner.size(), 0.0);
  pattern_ = Eigen::Map<const Eigen::SparseMatrix<double>>(interior_unknowns(), interior_unknowns(),
                                                           Eigen::Index(inner.size()), outer.data(),
                                                           inner.data(), zeros.data());
  slots_.setConstant(nodes * nodes, mesh_.elements.cols(), -1);
  for (Eigen::Index e = 0; e < mesh_.elements.cols(); ++e) {
    for (Eigen::Index b = 0; b < nodes; ++b) {
      for (Eigen::Index a = 0; a < nodes; ++a) {
        if (place(e, b) < 0 || place(e, a) < place(e, b)) continue;
        const auto& column = rows[std::size_t(place(e, b))];
        slots_(a + nodes * b, e) =
            int(std::lower_bound(column.begin(), column.end(), place(e, a)) - column.begin());
      }
    }
  }
}

State Solid::unloaded() const {
  State state;
  state.u = Eigen::Matrix3Xd::Zero(3, mesh_.X.cols());
  return state;
}

void Solid::place_face(State& state) const {
  for (std::size_t i = 0; i < mesh_.rigid.size(); ++i) {
    const Vec3<double> X = arms_.col(Eigen::Index(i));
    state.u.col(mesh_.rigid[i]) = state.d + (state.R - Mat3<double>::Identity()) * X;
  }
}

void Solid::move(State& state, const Eigen::VectorXd& interior, const Vec6& face) const {
  for (std::size_t node = 0; node < numbering_.interior.size(); ++node) {
    if (numbering_.interior[node] >= 0)
      state.u.col(Eigen::Index(node)) += interior.segment<3>(3 * numbering_.interior[node]);
  }
  state.d += face.head<3>();
  state.R = so3::exp<double>(face.tail<3>()) * state.R;
  place_face(state);
}

Eigen::VectorXd Solid::interior(const Eigen::Matrix3Xd& nodal) const {
  Eigen::VectorXd out(interior_unknowns());
  for (std::size_t node = 0; node < numbering_.interior.size(); ++node) {
    if (numbering_.interior[node] >= 0)
      out.segment<3>(3 * numbering_.interior[node]) = nodal.col(Eigen::Index(node));
  }
  return out;
}

Vec6 Solid::face_load(const State& state, const Eigen::Matrix3Xd& force) const {
  Vec6 load = Vec6::Zero();
  for (std::size_t i = 0; i < mesh_.rigid.size(); ++i) {
    const Vec3<double> arm = state.R * arms_.col(Eigen::Index(i)), f = force.col(mesh_.rigid[i]);
    load.head<3>() += f;
    load.tail<3>() += arm.cross(f);
  }
  return load;
}

}  // namespace halfway::reference::fe
