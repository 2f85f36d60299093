// halfway eval: JSON lines on stdin, one answer each on stdout; exit 0 at the end of input.
#include "reports/cli/commands.hpp"
#include "reports/eval/answer_lines.hpp"

#include <CLI/CLI.hpp>

#include <malloc.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <iostream>
#include <memory>
#include <thread>

namespace halfway::reports {
namespace {

constexpr std::size_t kOfOneThread = std::size_t(512) << 10;  // bytes of requests that are worth waiting for

constexpr const char* kFields =
    R"(One JSON object a line; SI units, radians, global axes where nothing else is said.

  formulation  a name of `halfway list`
  xi           of `intrinsic` alone, any number
  length, axis of `rod34` alone: of its rod, m, > 0; and the joint axis along which the rod runs from a to b, 1, 2,
               3, or -1, -2, -3 against it; 1 where it is left out
  kind         angular (3 rotations), linear (3 displacements), linear_angular (both, displacements first)
  law          {"type": "linear", "K": ...} with K (or stiffness; or compliance instead): n numbers, a diagonal,
               or n rows of n, n = 3 or 6, N/m, N, N m/rad; positive semidefinite, symmetric to 1e-12 or, of a
               measured one, to "tolerance", at most 0.1. "axes": a rotation whose columns are the axes along
               which it is given; or "axes_translation" and "axes_rotation"
               {"type": "polynomial", "k1": [...], "k3": [...], "k5": [...]}: stress k1 e + k3 e^3 + k5 e^5
               {"type": "per_axis", "axis": [...]}, one of these for each strain: {"stiffness"}; {"k1", "k3", "k5"};
               {"negative", "positive"}, slopes below and above zero; {"x", "y", "interpolation"}, stresses y at
               strains x, linear, akima or monotone between, straight on beyond
               beside each "preload" and "offset", n numbers: stress = law(strain - offset) + preload
  a, b         the nodes: x, position, m; q, node axes -> global axes, a quaternion [w, x, y, z] or the 3 rows
               of a matrix; o, joint point, m, node axes; h, joint axes -> node axes, as q. o and h may be left
               out, or stand beside a and b as offset_a, frame_a, offset_b, frame_b, as in scenes.
  poses        many poses of one joint: [{"a": {"x", "q"}, "b": {"x", "q"}}, ...]; what one of them leaves out is
               taken from a and b beside them
  want         of "strain", "loads", "tangent", "energy"; strain and loads where it is left out
  id           anything; comes back as it came
A number may be a text with a unit, "12 mm", "1.8 N m/deg", "3 kN/mm", and an array {"values": [...], "unit": "mm"}.

Answers: {"id", "strain", "loads", "tangent", "energy"}, and "notes" where the input was normalised.
  strain   n numbers, displacements (m) before rotations (rad), axes of joint frame a's side
  loads    12: force and moment on a, force and moment on b (N, N m; global axes, about the nodes)
  tangent  12 rows of 12: loads by (dx_a, w_a, dx_b, w_b), spins in global axes
  energy   J, null where the formulation has no potential of this kind
Numbers have the fewest digits that give them back. Asked for poses, each of these is a list with an item for
each pose, the same numbers as asked one by one. A pose without a finite result is null in all lists and named
in "errors": [{"pose": 3, "code": "singular_pose", "message"}], counted from 0; the others have their answers.
rod4 and rod34 refuse a pose beyond the rotation within which their energy is convex: code "beyond_convexity".
A pose that is wrong (poses[3].b.q) refuses the line. A line has at most 16 MiB and 1e6 values, 21 a pose.

Signs: q = dU/dx: internal loads; add -q to your equations of motion.

A request that cannot be answered gets {"id", "error": {"code", "message", "field"}}, and the next one its own
answer: such lines do not change the exit code.)";

/// What a long line took serves the next one: else the system takes back every page and gives it anew, a
/// third of the time of lines of a thousand poses.
void keep_memory() {
#ifdef __GLIBC__
  ::mallopt(M_MMAP_THRESHOLD, 32 << 20);
  ::mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
}

std::size_t read_input(char* room, std::size_t size) {
  ssize_t count = 0;
  do count = ::read(STDIN_FILENO, room, size);
  while (count < 0 && errno == EINTR);
  if (count < 0) throw FailedRun("cannot read standard input");
  return std::size_t(count);
}

bool is_ready() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return ::poll(&input, 1, 0) > 0;
}

/// Nobody waits for an answer whose request was read: they are written before more is waited for. What is
/// there already is read first, as much as keeps the threads busy.
void answer_all(int threads) {
  InputLines input(kLongestLine, read_input);
  std::vector<InputLines::Line> lines;
  // Beyond the longest line's bytes they would be taken for one.
  const std::size_t enough =
      threads > 1 ? std::min(std::size_t(threads) * kOfOneThread, kLongestLine / 2) : 0;
  do {
    while (input.unread() < enough && is_ready() && input.read_more()) {
    }
    lines.clear();
    while (const auto line = input.next()) lines.push_back(*line);
    std::cout << answered(lines, threads) << std::flush;
    if (!std::cout) throw FailedRun("cannot write standard output");
  } while (input.read_more());
}

}  // namespace

void add_eval(CLI::App& app) {
  CLI::App* command = app.add_subcommand("eval", "Answer JSON lines from standard input, one line each");
  command->footer(kFields);
  const auto threads = std::make_shared<int>(std::max(1U, std::thread::hardware_concurrency()));
  command->add_option("--threads", *threads, "That share many lines; default: one a core")
      ->check(CLI::Range(1, 256));
  command->callback([threads] {
    std::ios::sync_with_stdio(false);
    keep_memory();
    answer_all(*threads);
  });
}

}  // namespace halfway::reports
