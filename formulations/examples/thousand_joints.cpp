#include <halfway/batch/plan.hpp>
#include <halfway/batch/table.hpp>

#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

int main() {
  namespace batch = halfway::batch;
  // Two sorts of joints, mixed: which one each is. SI units, radians.
  const std::vector<batch::Member> members = {
      {{.formulation = "invariant", .kind = halfway::Kind::linear_angular}},
      {{.formulation = "intrinsic", .kind = halfway::Kind::angular, .xi = 0.3}}};
  std::vector<int> sort_of(1000);
  for (int i = 0; i < 1000; ++i) sort_of[i] = i % 3 == 0;
  const batch::Plan plan(members, sort_of);

  // Tables have a row for each number and a column for each joint, in the plan's order.
  batch::Table<double> q_a(4, 1000), q_b(4, 1000), x_a(3, 1000), x_b(3, 1000), law(21, 1000), loads(9, 1000),
      tangent(81, 1000);
  for (long k = 0; k < plan.count(); ++k) {
    const long i = plan.order()[k];
    q_a(0, k) = 1;
    q_b(0, k) = std::cos(0.0005 * i), q_b(3, k) = std::sin(0.0005 * i);  // i mrad about z
    x_b(0, k) = 0.001;
    const bool is_angular = sort_of[i] == 1;
    for (int row : {0, 6, 11, 15, 18, 20}) law(row, k) = is_angular ? 0 : 1e4;  // the diagonal of 6 x 6
    if (is_angular) law(0, k) = law(3, k) = law(5, k) = 100;                    // of 3 x 3
  }
  const batch::Joints<double> joints{.count = plan.count(),
                                     .q_a = std::as_const(q_a).columns(),
                                     .q_b = std::as_const(q_b).columns(),
                                     .x_a = std::as_const(x_a).columns(),
                                     .x_b = std::as_const(x_b).columns(),
                                     .law = std::as_const(law).columns(),
                                     .law_per_joint = true};
  const batch::Results<double> results{loads.columns(), tangent.columns()};
  batch::validate(plan, joints, results, batch::Output::tangent);  // once: evaluate() checks nothing
  plan.evaluate(joints, results, batch::Output::tangent);

  // Rows of loads: m_b of an angular joint, else f_b, m_a, m_b. Internal loads: add -q to your equations.
  batch::Table<double> back(9, 1000);
  plan.restore<double>(9, std::as_const(loads).columns(), back.columns());
  std::printf("joint 600, moment on b about z %.6f N m\n", back(2, 600));
  std::printf("joint 601, force on b %.6f %.6f %.6f N\n", back(0, 601), back(1, 601), back(2, 601));
}
