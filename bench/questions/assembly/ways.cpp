// Five ways from poses to a sparse matrix, each as its user would write it.
#include "bench/questions/assembly/lattice.hpp"
#include "bench/questions/kernels/kernel_joint.hpp"
#include "bench/questions/methods/textbook.hpp"
#include "halfway/peers/mbdyn_joint_inv.hpp"
#include "halfway/systems/intrinsic.hpp"

#include <algorithm>
#include <utility>

namespace halfway::bench {
namespace {

using assemble::Pattern, assemble::Place;
template <int n>
using Block = Eigen::Map<Eigen::Matrix<double, n, n, Eigen::RowMajor>>;

/// Loads of both nodes and their tangent, added block by block.
template <int n, class Loads, class Tangent>
void add_joint(const Place& place, const Loads& q, const Tangent& tangent, std::span<double> residual,
               std::span<double> values) {
  for (int i = 0; i < 2; ++i) {
    Eigen::Map<Eigen::Matrix<double, n, 1>>(&residual[place.row[i]]) += q.template segment<n>(n * i);
    for (int j = 0; j < 2; ++j) {
      Block<n>(&values[place.block[2 * i + j]]) += tangent.template block<n, n>(n * i, n * j);
    }
  }
}
void add(const Place& place, const NodeLoads<double>& l, std::span<double> residual,
         std::span<double> values) {
  add_joint<6>(place, l.q, l.tangent, residual, values);
}
void add(const Place& place, const AngularLoads<double>& l, std::span<double> residual,
         std::span<double> values) {
  Eigen::Matrix<double, 6, 1> q;
  Eigen::Matrix<double, 6, 6> tangent;
  q << -l.m_b, l.m_b;
  tangent << -l.m_b_wa, -l.m_b_wb, l.m_b_wa, l.m_b_wb;
  add_joint<3>(place, q, tangent, residual, values);
}

/// @tparam Evaluate  loads of a joint between nodes a and b
template <class Evaluate>
Assemble joint_by_joint(const Pattern& pattern, const Evaluate& evaluate) {
  return [&pattern, evaluate](std::span<double> residual, std::span<double> values) {
    std::ranges::fill(residual, 0.), std::ranges::fill(values, 0.);
    for (const Place& place : pattern.places()) {
      add(place, evaluate(place.node[0], place.node[1]), residual, values);
    }
  };
}

const Eigen::MatrixXd& stiffness(const Lattice& l) {
  return std::get<reference::LinearSpec>(l.spec.law).matrix;
}

/// A force and a moment that do not know of each other: the sum of a linear joint and an angular one.
NodeLoads<double> full_textbook(const textbook::Properties& force, const textbook::Properties& moment,
                                const Pose<double>& a, const Pose<double>& b) {
  using textbook::Frame;
  NodeLoads<double> out = textbook::linear<Frame::halfway, true>(force, a, b);
  const AngularLoads<double> m = textbook::angular<Frame::halfway, true>(moment, a, b);
  out.q.segment<3>(3) -= m.m_b, out.q.segment<3>(9) += m.m_b;
  out.tangent.block<3, 3>(3, 3) -= m.m_b_wa, out.tangent.block<3, 3>(3, 9) -= m.m_b_wb;
  out.tangent.block<3, 3>(9, 3) += m.m_b_wa, out.tangent.block<3, 3>(9, 9) += m.m_b_wb;
  return out;
}

template <Kind kind>
Assemble textbook_loop(const Lattice& l, const Pattern& pattern) {
  const Eigen::MatrixXd& K = stiffness(l);
  const textbook::Properties first{K.topLeftCorner<3, 3>(), {}, {}},
      last{K.bottomRightCorner<3, 3>(), {}, {}};
  return joint_by_joint(pattern, [&l, first, last](int a, int b) {
    if constexpr (kind == Kind::angular)
      return textbook::angular<textbook::Frame::halfway, true>(first, l.matrices[a], l.matrices[b]);
    else if constexpr (kind == Kind::linear)
      return textbook::linear<textbook::Frame::halfway, true>(first, l.matrices[a], l.matrices[b]);
    else
      return full_textbook(first, last, l.matrices[a], l.matrices[b]);
  });
}

template <Kind kind>
Assemble mbdyn_like_loop(const Lattice& l, const Pattern& pattern) {
  constexpr int n = strain_count(kind);
  const Joint<kind, double, MbdynJointInv, LinearLaw<double, n>> joint{{}, {stiffness(l)}, {}, {}};
  return joint_by_joint(
      pattern, [&l, joint](int a, int b) { return loads<true>(joint, l.matrices[a], l.matrices[b]); });
}

template <Kind kind>
Assemble kernel_loop(const Lattice& l, const Pattern& pattern) {
  const auto joint = static_kernel_joint<Invariant, kind, double, kernel::NoEnds>(l.spec);
  return [&l, &pattern, joint](std::span<double> residual, std::span<double> values) {
    constexpr int n = kind == Kind::angular ? 3 : 6;
    const auto pose = [&l](int node) {
      const auto& [x, q] = l.poses[node];
      return kernel::NodePose<double>{{x[0], x[1], x[2]}, {q[0], {q[1], q[2], q[3]}}};
    };
    std::ranges::fill(residual, 0.), std::ranges::fill(values, 0.);
    for (const Place& place : pattern.places()) {
      const auto a = pose(place.node[0]), b = pose(place.node[1]);
      if constexpr (kind == Kind::angular) {
        const auto loads = kernel::loads<true>(joint, a.q, b.q);
        AngularLoads<double> out;
        kernel::V3<double> rows[] = {loads.wa.x, loads.wa.y, loads.wa.z, loads.wb.x, loads.wb.y, loads.wb.z};
        out.m_b << loads.m.x, loads.m.y, loads.m.z;
        for (int r = 0; r < 3; ++r) {
          out.m_b_wa.row(r) << rows[r].x, rows[r].y, rows[r].z;
          out.m_b_wb.row(r) << rows[r + 3].x, rows[r + 3].y, rows[r + 3].z;
        }
        add(place, out, residual, values);
      } else {
        double numbers[12 + 144];
        kernel::expand<true>(kernel::loads<true>(joint, a, b), numbers);
        add_joint<n>(place, Eigen::Map<const Eigen::Matrix<double, 12, 1>>(numbers),
                     Eigen::Map<const Eigen::Matrix<double, 12, 12, Eigen::RowMajor>>(numbers + 12), residual,
                     values);
      }
    }
  };
}

template <class Make>
Way for_kind(Kind kind, const Make& make) {
  switch (kind) {
    case Kind::angular:
      return make.template operator()<Kind::angular>();
    case Kind::linear:
      return make.template operator()<Kind::linear>();
    default:
      return make.template operator()<Kind::linear_angular>();
  }
}

/// A batch as its interface suggests: poses into tables, the whole table of results, then its columns joint
/// by joint.
class WholeTable {
 public:
  WholeTable(const Lattice& l, const Pattern& pattern)
      : lattice_(l),
        pattern_(pattern),
        batch_({"invariant", l.spec.kind}),
        q_a_(4, count()),
        q_b_(4, count()),
        x_a_(3, count()),
        x_b_(3, count()),
        loads_(batch::load_rows(l.spec.kind), count()),
        tangent_(batch::tangent_rows(l.spec.kind, batch::Output::tangent), count()) {
    joints_.count = count();
    joints_.q_a = std::as_const(q_a_).columns(), joints_.q_b = std::as_const(q_b_).columns();
    joints_.x_a = std::as_const(x_a_).columns(), joints_.x_b = std::as_const(x_b_).columns();
    joints_.law = l.law.columns();
  }

  void run(std::span<double> residual, std::span<double> values) {
    std::ranges::fill(residual, 0.), std::ranges::fill(values, 0.);
    for (long i = 0; i < count(); ++i) {
      const assemble::Nodes& n = lattice_.joints[i];
      const assemble::NodePose &a = lattice_.poses[n.a], &b = lattice_.poses[n.b];
      for (int c = 0; c < 3; ++c) x_a_(c, i) = a.x[c], x_b_(c, i) = b.x[c];
      for (int c = 0; c < 4; ++c) q_a_(c, i) = a.q[c], q_b_(c, i) = b.q[c];
    }
    batch_.evaluate(joints_, batch::Results<double>{loads_.columns(), tangent_.columns()},
                    batch::Output::tangent);
    for (long i = 0; i < count(); ++i) {
      if (lattice_.spec.kind == Kind::angular)
        add(pattern_.places()[i], angular_at(i), residual, values);
      else
        add(pattern_.places()[i], point_at(i), residual, values);
    }
  }

 private:
  long count() const { return long(lattice_.joints.size()); }
  Eigen::Vector3d vector(int row, long i) const {
    return {loads_(row, i), loads_(row + 1, i), loads_(row + 2, i)};
  }
  Eigen::Matrix3d matrix(int row, long i) const {
    Eigen::Matrix3d m;
    for (int k = 0; k < 9; ++k) m(k / 3, k % 3) = tangent_(row + k, i);
    return m;
  }
  AngularLoads<double> angular_at(long i) const {
    AngularLoads<double> out;
    out.m_b = vector(0, i), out.m_b_wa = matrix(0, i), out.m_b_wb = matrix(9, i);
    return out;
  }
  NodeLoads<double> point_at(long i) const {
    NodeLoads<double> out;
    out.q << -vector(0, i), vector(3, i), vector(0, i), vector(6, i);
    for (const auto& [row, first] : {std::pair{6, 0}, {3, 27}, {9, 54}}) {
      const Eigen::Matrix3d by_x = matrix(first, i);
      out.tangent.middleRows<3>(row) << -by_x, matrix(first + 9, i), by_x, matrix(first + 18, i);
    }
    out.tangent.topRows<3>() = -out.tangent.middleRows<3>(6);
    return out;
  }

  const Lattice& lattice_;
  const Pattern& pattern_;
  batch::Batch batch_;
  batch::Table<double> q_a_, q_b_, x_a_, x_b_, loads_, tangent_;
  batch::Joints<double> joints_;
};

}  // namespace

Way textbook_way(Kind kind) {
  return for_kind(kind, []<Kind k>() -> Way { return textbook_loop<k>; });
}
Way mbdyn_like_way(Kind kind) {
  return for_kind(kind, []<Kind k>() -> Way { return mbdyn_like_loop<k>; });
}
Way kernel_way(Kind kind) {
  return for_kind(kind, []<Kind k>() -> Way { return kernel_loop<k>; });
}
Way batch_way() {
  return [](const Lattice& l, const Pattern& pattern) -> Assemble {
    return [table = std::make_shared<WholeTable>(l, pattern)](std::span<double> r, std::span<double> v) {
      table->run(r, v);
    };
  };
}
Way assemble_way(const std::string& formulation, int threads) {
  return [=](const Lattice& l, const Pattern& pattern) -> Assemble {
    const batch::Model model{formulation, l.spec.kind};
    auto assembler =
        std::make_shared<assemble::Assembler>(model, pattern, assemble::Options{.threads = threads});
    return [assembler, &l](std::span<double> residual, std::span<double> values) {
      assembler->assign({l.poses, l.law.columns()}, residual, values);
    };
  };
}

}  // namespace halfway::bench
