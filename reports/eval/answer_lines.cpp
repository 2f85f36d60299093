#include "reports/eval/answer_lines.hpp"

#include "reports/eval/eval_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace halfway::reports {
namespace {

/// Bytes of requests that take some 100 us, beside 20 for a thread to begin.
constexpr std::size_t kShare = std::size_t(16) << 10;

struct Share {
  std::span<const InputLines::Line> lines;
  std::string answers{};

  void answer() {
    for (const InputLines::Line& line : lines) {
      answers += line.is_too_long ? eval_refusal("line_too_long",
                                                 fmt::format("a line is longer than {} bytes", kLongestLine))
                                  : eval_line(line.text);
      answers += '\n';
    }
  }
};

std::vector<Share> shares_of(std::span<const InputLines::Line> lines) {
  std::vector<Share> out;
  std::size_t first = 0, bytes = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    bytes += lines[i].text.size();
    if (bytes < kShare && i + 1 < lines.size()) continue;
    out.push_back({lines.subspan(first, i + 1 - first)});
    first = i + 1, bytes = 0;
  }
  return out;
}

}  // namespace

std::string answered(std::span<const InputLines::Line> lines, int threads) {
  std::vector<Share> shares = shares_of(lines);
  std::atomic<std::size_t> taken = 0;
  const auto work = [&] {
    for (std::size_t i; (i = taken++) < shares.size();) shares[i].answer();
  };
  {
    std::vector<std::jthread> others(std::min(std::size_t(threads), std::max<std::size_t>(shares.size(), 1)) -
                                     1);
    for (std::jthread& other : others) other = std::jthread(work);
    work();
  }
  std::string out;
  for (const Share& share : shares) out += share.answers;
  return out;
}

}  // namespace halfway::reports
