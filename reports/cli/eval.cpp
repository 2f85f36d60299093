// halfway eval: JSON lines on stdin, one answer each on stdout, flushed; exit 0 at the end of input.
#include "reports/cli/commands.hpp"
#include "reports/eval/eval_line.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <iostream>
#include <limits>
#include <memory>

namespace halfway::reports {
namespace {

constexpr std::size_t kLongestLine = std::size_t(16) << 20;  // bytes; a request needs some hundreds

constexpr const char* kFields =
    R"(One JSON object a line; SI units, radians, global axes where nothing else is said.

  formulation  a name of `halfway list`
  xi           of `intrinsic` alone, any number
  kind         angular (3 rotations), linear (3 displacements), linear_angular (both, displacements first)
  law          {"type": "linear", "K": ...} with K (or stiffness; or compliance instead): n numbers, a diagonal,
               or n rows of n, n = 3 or 6, N/m, N, N m/rad; symmetric to 1e-12, positive semidefinite
               {"type": "polynomial", "k1": [...], "k3": [...], "k5": [...]}: stress k1 e + k3 e^3 + k5 e^5
  a, b         the nodes: x, position, m; q, node axes -> global axes, a quaternion [w, x, y, z] or the 3 rows
               of a matrix; o, joint point, m, node axes; h, joint axes -> node axes, as q. o and h may be left
               out, or stand beside a and b as offset_a, frame_a, offset_b, frame_b, as in scenes.
  want         of "strain", "loads", "tangent", "energy"; strain and loads where it is left out
  id           anything; comes back as it came

Answers: {"id", "strain", "loads", "tangent", "energy"}, and "notes" where the input was normalised.
  strain   n numbers, displacements (m) before rotations (rad), axes of joint frame a's side
  loads    12: force and moment on a, force and moment on b (N, N m; global axes, about the nodes)
  tangent  12 rows of 12: loads by (dx_a, w_a, dx_b, w_b), spins in global axes
  energy   J, null where the formulation has no potential of this kind

Signs: q = dU/dx: internal loads; add -q to your equations of motion.

A request that cannot be answered gets {"id", "error": {"code", "message", "field"}}, and the next one its own
answer: such lines do not change the exit code.)";

void answer_all(std::istream& in, std::ostream& out) {
  const std::size_t capacity = kLongestLine + 1;
  const auto line = std::make_unique_for_overwrite<char[]>(capacity);
  while (true) {
    in.getline(line.get(), std::streamsize(capacity));
    const auto count = std::size_t(in.gcount());
    if (in.eof() && count == 0) return;
    if (in.bad()) throw FailedRun("cannot read standard input");
    if (in.fail()) {  // the buffer is full and the line goes on
      in.clear();
      in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
      out << eval_refusal("line_too_long", fmt::format("a line is longer than {} bytes", kLongestLine));
    } else {
      const std::size_t line_end = in.eof() ? 0 : 1;
      out << eval_line({line.get(), count - line_end});
    }
    out << '\n' << std::flush;
    if (!out) throw FailedRun("cannot write standard output");
  }
}

}  // namespace

void add_eval(CLI::App& app) {
  CLI::App* command = app.add_subcommand("eval", "Answer JSON lines from standard input, one line each");
  command->footer(kFields);
  command->callback([] {
    std::ios::sync_with_stdio(false);
    std::cin.tie(nullptr);
    answer_all(std::cin, std::cout);
  });
}

}  // namespace halfway::reports
