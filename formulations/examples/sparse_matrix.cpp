#include <halfway/assemble/assembler.hpp>
#include <halfway/assemble/eigen.hpp>
#include <halfway/batch/table.hpp>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include <cstdio>
#include <utility>
#include <vector>

int main() {
  using namespace halfway::assemble;
  // 50 bodies in a row, 0.1 m apart, the first one fixed; bushings between them, half-way. SI units, radians.
  const int bodies = 50;
  std::vector<Nodes> joints;
  std::vector<NodePose> poses(bodies);
  for (int i = 0; i < bodies; ++i) poses[i].x[0] = 0.1 * i;
  for (int i = 0; i + 1 < bodies; ++i) joints.push_back({i, i + 1});
  const std::vector<int> fixed = {0};
  const Pattern pattern({.layout = Layout::columns, .part = Part::upper}, rows_of(bodies, fixed), joints);

  halfway::batch::Table<double> law(21, 1);  // the upper triangle of 6 x 6, one for all
  for (int row : {0, 6, 11}) law(row, 0) = 1e4;
  for (int row : {15, 18, 20}) law(row, 0) = 100;
  const halfway::batch::BatchEnd<double> a{.o = {0.05, 0, 0}}, b{.o = {-0.05, 0, 0}};
  const Input input{.poses = poses, .law = std::as_const(law).columns(), .a = &a, .b = &b};
  const Assembler assembler({.formulation = "fasse", .kind = halfway::Kind::linear_angular}, pattern);
  validate(assembler, input);  // once: assign() checks sizes alone

  auto tangent = matrix_of(pattern);  // an Eigen::SparseMatrix; its pattern is analysed once
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper> solver;
  solver.analyzePattern(tangent);
  Eigen::VectorXd residual(pattern.unknown_count());
  double change = 1;
  for (int iteration = 0; iteration < 30 && change > 1e-10; ++iteration) {
    assembler.assign(input, {residual.data(), std::size_t(residual.size())}, values_of(tangent));
    residual(residual.size() - 4) -= 0.02;  // N along z, on the last body
    solver.factorize(tangent);
    const Eigen::VectorXd step = solver.solve(-residual);
    change = step.norm();
    for (int i = 1; i < bodies; ++i) {  // (x, w) of each free body; it turns by w in global axes
      const Eigen::Vector3d x = step.segment<3>(6 * i - 6), w = step.segment<3>(6 * i - 3);
      double* const q = poses[i].q;
      for (int c = 0; c < 3; ++c) poses[i].x[c] += x[c];
      const Eigen::Quaterniond turn(Eigen::AngleAxisd(w.norm(), w.stableNormalized()));
      const Eigen::Quaterniond turned = (turn * Eigen::Quaterniond(q[0], q[1], q[2], q[3])).normalized();
      q[0] = turned.w(), q[1] = turned.x(), q[2] = turned.y(), q[3] = turned.z();
    }
  }
  std::printf("%ld unknowns, %ld numbers in the matrix\n", pattern.unknown_count(), pattern.value_count());
  std::printf("last body at %.6f %.6f %.6f m%s\n", poses.back().x[0], poses.back().x[1], poses.back().x[2],
              change > 1e-10 ? ", not converged" : "");
}
