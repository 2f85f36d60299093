#include "reference/fe/calculix.hpp"

#include "formulations/so3.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace halfway::reference::fe {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = "ccx";
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

/// A folder of this call alone, gone with it.
class Folder {
 public:
  Folder() {
    std::error_code error;
    std::string name = (fs::temp_directory_path(error) / "halfway-ccx-XXXXXX").string();
    if (error || !mkdtemp(name.data()))
      throw std::runtime_error(fmt::format("ccx (CalculiX): no temporary folder can be made (TMPDIR): {}",
                                           error ? error.message() : std::strerror(errno)));
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  fs::path operator/(const char* name) const { return path_ / name; }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::optional<fs::path> find_program() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path candidate = fs::path(folder) / kProgram;
    std::error_code ignored;
    if (fs::is_regular_file(candidate, ignored) && access(candidate.c_str(), X_OK) == 0)
      return fs::absolute(candidate);
  }
  return std::nullopt;
}

std::string last_lines(const fs::path& log) {
  constexpr std::size_t kLines = 8;
  std::deque<std::string> lines;
  std::ifstream in(log);
  for (std::string line; std::getline(in, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    lines.push_back(line);
    if (lines.size() > kLines) lines.pop_front();
  }
  std::string out;
  for (const std::string& line : lines) out += "\n  " + line;
  return out.empty() ? "\n  (it printed nothing)" : out;
}

[[noreturn]] void fail(const std::string& what, const Folder& folder) {
  throw std::runtime_error(
      fmt::format("ccx (CalculiX): {}; its last lines:{}", what, last_lines(folder / "log")));
}

/// This process's environment with one thread, whatever the caller's settings: the cost is then CPU time.
std::vector<std::string> environment() {
  std::vector<std::string> out;
  const std::vector<std::string> ours = {
      "OMP_NUM_THREADS=",     "OPENBLAS_NUM_THREADS=",      "CCX_NPROC_RESULTS=",
      "CCX_NPROC_STIFFNESS=", "CCX_NPROC_EQUATION_SOLVER=", "NUMBER_OF_CPUS="};
  for (char** entry = environ; *entry; ++entry) {
    bool overridden = false;
    for (const std::string& name : ours) overridden = overridden || std::string(*entry).starts_with(name);
    if (!overridden) out.emplace_back(*entry);
  }
  for (const std::string& name : ours) out.push_back(name + "1");
  return out;
}

std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> out;
  for (std::string& s : strings) out.push_back(s.data());
  out.push_back(nullptr);
  return out;
}

/// Runs ccx in the folder, its output in `log`; the exit status, or 128 + the signal that ended it.
int run(const Folder& folder, std::vector<std::string> arguments, CalculixCost& cost) {
  const std::optional<fs::path> program = find_program();
  if (!program) throw std::runtime_error("ccx (CalculiX, package calculix-ccx) is not on PATH");
  arguments.insert(arguments.begin(), kProgram);
  std::vector<std::string> variables = environment();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.path().c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "log", O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  const auto start = std::chrono::steady_clock::now();
  pid_t pid = 0;
  const int error = posix_spawn(&pid, program->c_str(), &actions, nullptr, pointers(arguments).data(),
                                pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
    throw std::runtime_error(
        fmt::format("ccx (CalculiX): {} does not start: {}", program->string(), std::strerror(error)));
  int status = 0;
  rusage usage{};
  while (wait4(pid, &status, 0, &usage) < 0) {
    if (errno != EINTR)
      throw std::runtime_error(fmt::format("ccx (CalculiX): lost: {}", std::strerror(errno)));
  }
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  cost.cpu += seconds(usage.ru_utime) + seconds(usage.ru_stime);
  cost.wall += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ++cost.runs;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

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
std::vector<Vec6> read_poses(const Folder& folder, int steps) {
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
        fail(fmt::format("no displacement can be read from \"{}\"", line), folder);
      poses[std::size_t(step) - 1].segment<3>(3 * half) = u;
    }
  }
  for (const Vec6& pose : poses) {
    if (!pose.allFinite()) fail("the displacement of the rigid face is missing or no number", folder);
  }
  return poses;
}

/// The poses at the ends of the steps of the input that `write` gives.
template <class Write>
std::vector<Vec6> solve(int steps, CalculixCost& cost, Write write) {
  const Folder folder;
  std::ofstream input(folder / "job.inp");
  write(input);
  input.close();
  if (!input) throw std::runtime_error("ccx (CalculiX): its input file cannot be written (disk full?)");
  const int status = run(folder, {"-i", "job"}, cost);
  if (status != 0) fail(fmt::format("ended with status {}", status), folder);
  return read_poses(folder, steps);
}

}  // namespace

bool calculix_available() { return find_program().has_value(); }

std::string calculix_version() {
  const Folder folder;
  CalculixCost cost;
  run(folder, {"-v"}, cost);  // its status is that of a stop, 201
  std::ifstream log(folder / "log");
  for (std::string word; log >> word;) {
    if (word == "Version" && log >> word) return word;
  }
  fail("ccx -v states no version", folder);
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

CalculixPose calculix_nonlinear(const Mesh& mesh, const Material& material,
                                const Vec3<double>& reference_point, const Load& load) {
  CalculixPose out{Vec3<double>::Zero(), Vec3<double>::Zero(), {}};
  while (out.cost.runs < kMostRuns) {
    const Vec3<double> m = load.follower ? Vec3<double>(so3::exp<double>(out.theta) * load.m) : load.m;
    const Vec3<double> applied = so3::gamma<double>(out.theta).transpose() * m;
    const Vec6 pose = solve(1, out.cost, [&](std::ostream& input) {
      write_model(input, mesh, material, reference_point);
      input << "*STEP, NLGEOM, INC=1000\n*STATIC\n1., 1., 1.E-3, 1.\n*CONTROLS, PARAMETERS=FIELD\n"
            << fmt::format("{0:.1E}, {0:.1E}, 0., 0., {0:.1E}, 1.E-12, 1.E-12, {0:.1E}\n", kResidual)
            << "*CONTROLS, PARAMETERS=TIME INCREMENTATION\n"
            << kPatience << '\n';
      write_load(input, mesh, material, load.f, applied);
    })[0];
    const Vec3<double> change = pose.tail<3>() - out.theta;
    out.d = pose.head<3>();
    out.theta = pose.tail<3>();
    // One or two units of the last printed digit; beside it what the residual leaves of a zero.
    const Vec3<double> allowed =
        1e-6 * out.theta.cwiseAbs() + Vec3<double>::Constant(1e-9 * out.theta.norm());
    if (load.m.isZero(0) || (change.cwiseAbs().array() <= allowed.array()).all()) return out;
  }
  throw std::runtime_error(fmt::format(
      "ccx (CalculiX): the moment on the rotation vector does not settle within {} runs", kMostRuns));
}

}  // namespace halfway::reference::fe
