#include "reference/truth/fe/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace halfway::reference::fe {
namespace {

/// 1 - (1 - s)^p: dense toward s = 1.
double dense_at_one(double s, double p) { return 1 - std::pow(1 - s, p); }

/// Lattice of 2 n + 1 positions in [0, 1]: corners graded, mid-nodes half-way, so that edges stay
/// straight in the parameter and no element is a quarter-point element by accident.
std::vector<double> lattice(int n, double p, bool one_sided) {
  std::vector<double> t(std::size_t(2 * n + 1));
  for (int i = 0; i <= n; ++i) {
    const double s = double(i) / n;
    if (one_sided)
      t[std::size_t(2 * i)] = dense_at_one(s, p);
    else
      t[std::size_t(2 * i)] =
          s < 0.5 ? (1 - dense_at_one(1 - 2 * s, p)) / 2 : (1 + dense_at_one(2 * s - 1, p)) / 2;
  }
  for (int i = 0; i < n; ++i) {
    const auto k = std::size_t(2 * i);
    t[k + 1] = (t[k] + t[k + 2]) / 2;
  }
  return t;
}

/// Nodes found again by position.
class NodeSet {
 public:
  explicit NodeSet(double tolerance) : tolerance_(tolerance) {}

  int at(const Vec3<double>& X) {
    const auto [it, added] = index_.try_emplace(key(X), int(positions_.size()));
    if (added) positions_.push_back(X);
    return it->second;
  }
  Eigen::Matrix3Xd positions() const {
    Eigen::Matrix3Xd X(3, Eigen::Index(positions_.size()));
    for (std::size_t i = 0; i < positions_.size(); ++i) X.col(Eigen::Index(i)) = positions_[i];
    return X;
  }

 private:
  using Key = std::array<long long, 3>;
  /// Half a cell off the origin, where symmetric bodies have their nodes.
  Key key(const Vec3<double>& X) const {
    Key k;
    for (int d = 0; d < 3; ++d) k[std::size_t(d)] = (long long)(std::floor(X[d] / tolerance_ + 0.5));
    return k;
  }

  double tolerance_;
  std::map<Key, int> index_;
  std::vector<Vec3<double>> positions_;
};

void add_patch(const Patch& patch, const ReferenceElement& reference, NodeSet& nodes,
               std::vector<std::vector<int>>& elements, std::vector<int>& clamped, std::vector<int>& rigid) {
  std::array<std::vector<double>, 3> t;
  for (std::size_t d = 0; d < 3; ++d)
    t[d] = lattice(patch.divisions[d], patch.grading[d], patch.one_sided[d]);
  const auto [n1, n2, n3] = patch.divisions;
  for (int k = 0; k < n3; ++k) {
    for (int j = 0; j < n2; ++j) {
      for (int i = 0; i < n1; ++i) {
        std::vector<int> element;
        for (const Vec3<int>& local : reference.nodes) {
          const Vec3<int> at(2 * i + 1 + local[0], 2 * j + 1 + local[1], 2 * k + 1 + local[2]);
          element.push_back(nodes.at(
              patch.map({t[0][std::size_t(at[0])], t[1][std::size_t(at[1])], t[2][std::size_t(at[2])]})));
          if (at[0] == 0) clamped.push_back(element.back());
          if (at[0] == 2 * n1) rigid.push_back(element.back());
        }
        elements.push_back(std::move(element));
      }
    }
  }
}

void make_unique(std::vector<int>& v) {
  std::sort(v.begin(), v.end());
  v.erase(std::unique(v.begin(), v.end()), v.end());
}

void check_orientation(const Mesh& mesh, const ReferenceElement& reference) {
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e) {
    const Eigen::Matrix3Xd X = mesh.X(Eigen::all, mesh.elements.col(e));
    for (const Eigen::Matrix3Xd& dN : reference.dN) {
      if (Mat3<double>(X * dN.transpose()).determinant() <= 0)
        throw std::invalid_argument("element " + std::to_string(e) + " of the mesh is turned inside out");
    }
  }
}

}  // namespace

Mesh structured(ElementKind element, const std::vector<Patch>& patches) {
  const ReferenceElement& reference = reference_element(element);
  double size = 0;
  for (const Patch& patch : patches) {
    for (int corner = 0; corner < 8; ++corner)
      size = std::max(
          size, patch.map({double(corner & 1), double(corner >> 1 & 1), double(corner >> 2 & 1)}).norm());
  }
  NodeSet nodes(1e-9 * size);
  std::vector<std::vector<int>> elements;
  Mesh mesh;
  mesh.element = element;
  for (const Patch& patch : patches) add_patch(patch, reference, nodes, elements, mesh.clamped, mesh.rigid);
  make_unique(mesh.clamped);
  make_unique(mesh.rigid);
  mesh.X = nodes.positions();
  mesh.elements.resize(Eigen::Index(reference.nodes.size()), Eigen::Index(elements.size()));
  for (std::size_t e = 0; e < elements.size(); ++e)
    mesh.elements.col(Eigen::Index(e)) =
        Eigen::Map<const Eigen::VectorXi>(elements[e].data(), mesh.elements.rows());
  check_orientation(mesh, reference);
  return mesh;
}

Numbering number_nodes(const Mesh& mesh) {
  Numbering n;
  n.interior.assign(std::size_t(mesh.X.cols()), 0);
  n.face.assign(n.interior.size(), -1);
  for (int node : mesh.clamped) n.interior[std::size_t(node)] = -1;
  for (std::size_t i = 0; i < mesh.rigid.size(); ++i) {
    n.interior[std::size_t(mesh.rigid[i])] = -1;
    n.face[std::size_t(mesh.rigid[i])] = int(i);
  }
  for (int& place : n.interior) {
    if (place == 0) place = n.interior_count++;
  }
  return n;
}

Mesh tapered_block(ElementKind element, const TaperedBlock& body, const std::array<int, 3>& divisions,
                   double grading) {
  const auto map = [body](const Vec3<double>& t) {
    const double b = body.clamped[0] + t[0] * (body.free[0] - body.clamped[0]);
    const double c = body.clamped[1] + t[0] * (body.free[1] - body.clamped[1]);
    return Vec3<double>(body.length * t[0], b * (t[1] - 0.5), c * (t[2] - 0.5));
  };
  return structured(element, {{divisions, {grading, grading, grading}, {}, map}});
}

}  // namespace halfway::reference::fe
