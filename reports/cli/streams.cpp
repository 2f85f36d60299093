#include "reports/cli/streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

namespace halfway::reports {
namespace {

bool lost = false;

void write(std::FILE* stream, std::string_view text) {
  lost |= std::fwrite(text.data(), 1, text.size(), stream) != text.size();
}

}  // namespace

void reserve_streams() {
  for (int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) != -1) continue;
    // The lowest free descriptor is this one, those below being open.
    const int opened = ::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    if (opened != descriptor && opened >= 0) ::close(opened);
  }
}

void print(std::string_view text) { write(stdout, text); }

void tell(std::string_view text) {
  lost |= std::fflush(stdout) != 0;
  write(stderr, text);
}

bool lost_output() {
  lost |= std::fflush(stdout) != 0 || std::ferror(stdout) != 0;
  return lost;
}

std::string printable(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0;
    if (c < 0x20 || c == 0x7F) {
      out += fmt::format("\\u{:04x}", c);
    } else if (c == 0xC2 && next >= 0x80 && next < 0xA0) {  // U+0080 to U+009F
      out += fmt::format("\\u{:04x}", next);
      ++i;
    } else {
      out += text[i];
    }
  }
  return out;
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : printable(text)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace halfway::reports
