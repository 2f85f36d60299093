#include "reports/cli/errors.hpp"
#include "reports/history/dashboard/dashboard.hpp"
#include "reports/views/files.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <zlib.h>

#include <cstdlib>
#include <ctime>
#include <iterator>
#include <stdexcept>

namespace halfway::history {
namespace {

constexpr std::string_view kPlaceholder = "<!-- halfway data -->";

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    for (int k = 0; k < 4; ++k) {
      const bool is_padding = i + std::size_t(k) > bytes.size();
      out += is_padding ? '=' : kDigits[word >> (18 - 6 * k) & 63];
    }
  }
  return out;
}

std::string block(const std::string& id, const std::string& json) {
  return fmt::format("<script type=\"text/plain\" id=\"{}\">{}</script>\n", id, packed(json));
}

}  // namespace

std::string packed(const std::string& text) {
  z_stream stream{};
  // Level 9 takes three times as long for a tenth less. With zlib's header and checksum: a damaged block is
  // noticed.
  if (::deflateInit2(&stream, 7, Z_DEFLATED, 15, 9, Z_DEFAULT_STRATEGY) != Z_OK) throw std::bad_alloc();
  std::string out(::deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = uInt(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = uInt(out.size());
  const int end = ::deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  ::deflateEnd(&stream);
  if (end != Z_STREAM_END) throw std::runtime_error("zlib: deflate did not end");
  return base64(out);
}

std::filesystem::path template_file() {
  const char* file = std::getenv("HALFWAY_DASHBOARD");
  return file && *file ? file : HALFWAY_DASHBOARD_FILE;
}

std::string fill(const std::filesystem::path& file, const std::string& blocks) {
  if (!std::filesystem::exists(file))
    throw reports::BadInput(file.string() +
                            ": the dashboard's page was not built; build the target report_page (it "
                            "needs npm), or set HALFWAY_DASHBOARD to a built page");
  std::string page = reports::read_file(file);
  const auto at = page.find(kPlaceholder);
  if (at == std::string::npos || page.find(kPlaceholder, at + 1) != std::string::npos)
    throw reports::BadInput(
        fmt::format("{}: no page of the dashboard: it must hold {} once", file.string(), kPlaceholder));
  const bool has_line = page.compare(at + kPlaceholder.size(), 1, "\n") == 0;
  return page.replace(at, kPlaceholder.size() + has_line, blocks);
}

std::string dashboard_html(const History& history, const std::string& command) {
  if (history.runs.empty())
    throw reports::BadInput("the history has no run yet; ./halfway history add keeps one");
  const std::string now = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  std::string blocks = block("index", index_json(history, find_changes(history), command, now));
  for (int f = 0; f < int(history.figures.size()); ++f)
    blocks += block(fmt::format("f{}", f), figure_json(history, f));
  return fill(template_file(), blocks);
}

}  // namespace halfway::history
