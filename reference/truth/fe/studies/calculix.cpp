#include "reference/truth/fe/studies/calculix.hpp"

#include "halfway/rotations/so3.hpp"
#include "reference/truth/fe/studies/calculix_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace halfway::reference::fe {
namespace {

/// Largest residual over the average nodal force: with ccx's own 5e-3 the second-order parts of d and
/// theta were off by 2e-5, with this by at most 2e-6. Rounding leaves 1e-11 (1k unknowns) to 5e-10 (5k).
constexpr double kResidual = 1e-8;
/// *CONTROLS, TIME INCREMENTATION: ccx converges linearly, with residuals that rise now and then, which
/// its own counts take for divergence. Checks start later; most iterations: 60.
constexpr const char* kPatience = "20, 30, 60, 60, 60, 4";
constexpr int kMostRuns = 12;
/// Young's modulus in the inputs: ccx takes a residual force below 1e-6 for zero, whatever the unit, so
/// forces are given in a unit that makes them large. Displacements and rotations know no unit of force.
constexpr double kModulus = 1e12;

const char* element_name(ElementKind kind) {
  if (kind == ElementKind::hex20) return "C3D20R";
  if (kind == ElementKind::hex20_full) return "C3D20";
  throw std::invalid_argument(
      fmt::format("element {} has no counterpart in CalculiX; allowed: hex20, hex20_full", to_string(kind)));
}

/// ccx counts from 1 and reads fields of 20 characters.
std::string number(double value) { return fmt::format("{:.13E}", value); }

void write_set(std::ostream& out, const char* name, const std::vector<int>& nodes) {
  out << "*NSET, NSET=" << name << '\n';
  for (int node : nodes) out << node + 1 << ",\n";
}

/// Node N + 1 carries d and the force, node N + 2 theta and the moment.
void write_model(std::ostream& out, const Mesh& mesh, const Material& material,
                 const Vec3<double>& reference_point) {
  if (mesh.clamped.empty() || mesh.rigid.empty())
    throw std::invalid_argument("a mesh for CalculiX needs a clamped face and a rigid one");
  const auto node = [&out](Eigen::Index i, const Vec3<double>& X) {
    out << i + 1 << ", " << number(X[0]) << ", " << number(X[1]) << ", " << number(X[2]) << '\n';
  };
  const Eigen::Index count = mesh.X.cols();
  out << "*NODE\n";
  for (Eigen::Index i = 0; i < count; ++i) node(i, mesh.X.col(i));
  node(count, reference_point);
  node(count + 1, reference_point);
  out << "*ELEMENT, TYPE=" << element_name(mesh.element) << ", ELSET=BODY\n";
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e) {
    out << e + 1;
    // At most 16 entries to a line.
    for (Eigen::Index k = 0; k < mesh.elements.rows(); ++k)
      out << (k == 10 ? ",\n" : ", ") << mesh.elements(k, e) + 1;
    out << '\n';
  }
  write_set(out, "CLAMPED", mesh.clamped);
  write_set(out, "RIGID", mesh.rigid);
  write_set(out, "POSE", {int(count), int(count) + 1});
  out << "*MATERIAL, NAME=M\n*ELASTIC\n"
      << number(kModulus) << ", " << number(material.nu)
      << "\n*SOLID SECTION, ELSET=BODY, MATERIAL=M\n*BOUNDARY\nCLAMPED, 1, 3\n"
      << "*RIGID BODY, NSET=RIGID, REF NODE=" << count + 1 << ", ROT NODE=" << count + 2 << '\n';
}

void write_load(std::ostream& out, const Mesh& mesh, const Material& material, const Vec3<double>& f,
                const Vec3<double>& m) {
  const Eigen::Index nodes = mesh.X.cols();
  const double unit = kModulus / material.E;
  out << "*CLOAD, OP=NEW\n";
  for (int k = 0; k < 3; ++k) {
    out << nodes + 1 << ", " << k + 1 << ", " << number(unit * f[k]) << '\n';
    out << nodes + 2 << ", " << k + 1 << ", " << number(unit * m[k]) << '\n';
  }
  out << "*NODE PRINT, NSET=POSE\nU\n*END STEP\n";
}

/// The poses ccx printed, one for each step: (d, theta) of the last increment.
std::vector<Vec6> read_poses(const CalculixFolder& folder, int steps) {
  std::ifstream in(folder / "job.dat");
  std::vector<Vec6> poses(std::size_t(steps), Vec6::Constant(std::nan("")));
  for (std::string line; std::getline(in, line);) {
    const std::size_t time = line.find("time");
    if (line.find("displacements") == std::string::npos || time == std::string::npos) continue;
    // A step lasts 1 s; only the pose at its end counts.
    const double end = std::strtod(line.c_str() + time + 4, nullptr);
    const double step = std::round(end);
    if (std::abs(end - step) > 1e-6 || step < 1 || step > steps) continue;
    std::getline(in, line);
    for (int half = 0; half < 2; ++half) {
      std::getline(in, line);
      std::istringstream fields(line);
      int node = 0;
      Vec3<double> u;
      std::string surplus;
      if (!(fields >> node >> u[0] >> u[1] >> u[2]) || fields >> surplus)
        calculix_fail(fmt::format("no displacement can be read from \"{}\"", line), folder);
      poses[std::size_t(step) - 1].segment<3>(3 * half) = u;
    }
  }
  for (const Vec6& pose : poses) {
    if (!pose.allFinite())
      calculix_fail("the displacement of the rigid face is missing or no number", folder);
  }
  return poses;
}

/// The poses at the ends of the steps of the input that `write` gives.
template <class Write>
std::vector<Vec6> solve(int steps, CalculixCost& cost, Write write) {
  const CalculixFolder folder;
  std::ofstream input(folder / "job.inp");
  write(input);
  input.close();
  if (!input) throw std::runtime_error("ccx (CalculiX): its input file cannot be written (disk full?)");
  const int status = run_calculix(folder, {"-i", "job"}, cost);
  if (status != 0) calculix_fail(fmt::format("ended with status {}", status), folder);
  return read_poses(folder, steps);
}

}  // namespace

std::string calculix_version() {
  const CalculixFolder folder;
  CalculixCost cost;
  run_calculix(folder, {"-v"}, cost);  // its status is that of a stop, 201
  std::ifstream log(folder / "log");
  for (std::string word; log >> word;) {
    if (word == "Version" && log >> word) return word;
  }
  calculix_fail("ccx -v states no version", folder);
}

CalculixLinear calculix_linear(const Mesh& mesh, const Material& material,
                               const Vec3<double>& reference_point) {
  CalculixLinear out;
  const std::vector<Vec6> poses = solve(6, out.cost, [&](std::ostream& input) {
    write_model(input, mesh, material, reference_point);
    for (int k = 0; k < 6; ++k) {
      const Vec6 load = Vec6::Unit(k);
      input << "*STEP\n*STATIC\n";
      write_load(input, mesh, material, load.head<3>(), load.tail<3>());
    }
  });
  for (int k = 0; k < 6; ++k) out.compliance.col(k) = poses[std::size_t(k)];
  return out;
}

CalculixPose calculix_as_coded(const Mesh& mesh, const Material& material,
                               const Vec3<double>& reference_point, const Vec3<double>& f,
                               const Vec3<double>& m) {
  CalculixPose out{Vec3<double>::Zero(), Vec3<double>::Zero(), {}};
  const Vec6 pose = solve(1, out.cost, [&](std::ostream& input) {
    write_model(input, mesh, material, reference_point);
    input << "*STEP, NLGEOM, INC=1000\n*STATIC\n1., 1., 1.E-3, 1.\n*CONTROLS, PARAMETERS=FIELD\n"
          << fmt::format("{0:.1E}, {0:.1E}, 0., 0., {0:.1E}, 1.E-12, 1.E-12, {0:.1E}\n", kResidual)
          << "*CONTROLS, PARAMETERS=TIME INCREMENTATION\n"
          << kPatience << '\n';
    write_load(input, mesh, material, f, m);
  })[0];
  out.d = pose.head<3>();
  out.theta = pose.tail<3>();
  return out;
}

CalculixPose calculix_nonlinear(const Mesh& mesh, const Material& material,
                                const Vec3<double>& reference_point, const Load& load) {
  CalculixPose out{Vec3<double>::Zero(), Vec3<double>::Zero(), {}};
  while (out.cost.runs < kMostRuns) {
    const Vec3<double> m = load.follower ? Vec3<double>(so3::exp<double>(out.theta) * load.m) : load.m;
    const Vec3<double> applied = so3::gamma<double>(out.theta).transpose() * m;
    CalculixPose next = calculix_as_coded(mesh, material, reference_point, load.f, applied);
    const Vec3<double> change = next.theta - out.theta;
    next.cost.cpu += out.cost.cpu;
    next.cost.runs += out.cost.runs;
    out = next;
    // One or two units of the last printed digit; beside it what the residual leaves of a zero.
    const Vec3<double> allowed =
        1e-6 * out.theta.cwiseAbs() + Vec3<double>::Constant(1e-9 * out.theta.norm());
    if (load.m.isZero(0) || (change.cwiseAbs().array() <= allowed.array()).all()) return out;
  }
  throw std::runtime_error(fmt::format(
      "ccx (CalculiX): the moment on the rotation vector does not settle within {} runs", kMostRuns));
}

}  // namespace halfway::reference::fe
