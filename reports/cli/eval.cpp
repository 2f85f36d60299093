// halfway eval: JSON lines on stdin, one answer each on stdout, flushed; exit 0 at the end of input.
#include "reports/cli/commands.hpp"
#include "reports/eval/eval_line.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <iostream>
#include <limits>
#include <memory>

namespace halfway::reports {
namespace {

constexpr std::size_t kLongestLine = std::size_t(16) << 20;  // bytes; a request needs some hundreds

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
  command->callback([] {
    std::ios::sync_with_stdio(false);
    std::cin.tie(nullptr);
    answer_all(std::cin, std::cout);
  });
}

}  // namespace halfway::reports
