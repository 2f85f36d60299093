#include "reports/history/tests/support.hpp"

#include "reports/history/exchange/lines.hpp"
#include "reports/history/store/store.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>

#include <fstream>

namespace halfway::history::test {

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "history.XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  folder_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::string day(int i) { return fmt::format("2026-{:02}-{:02}T12:00:00Z", 1 + i / 28 % 12, 1 + i % 28); }

Record record(int i, int exact, int times) {
  Record out;
  out.run = {.commit = fmt::format("{:012x}", 0xabc000000000 + i),
             .date = day(i),
             .title = fmt::format("title of {}", i),
             .release = ""};
  out.run.load = 0.25, out.run.libraries = R"({"Eigen":"3.4.0"})";
  out.series = {{"a processor", 2, "L1d 48 KiB", "0x1"}, "g++ 12", "-O3", "Release", "avx2"};
  for (int f = 0; f < exact; ++f) {
    const std::string name = fmt::format("e{}", f);
    const Reading reading{
        .value = 1e-15 * (f + 1), .comparison = Comparison::at_most, .high = 1e-12, .verdict = Verdict::pass};
    out.exact[name] = {{.name = name, .unit = "eps", .better = Better::down}, reading};
  }
  for (int f = 0; f < times; ++f) {
    const std::string name = fmt::format("t{}", f);
    const std::int64_t median = 100000 * (f + 1) + 37 * i;
    out.timed[name] = {{.name = name, .unit = "ns per joint", .kind = Kind::time, .better = Better::down},
                       {.median = median, .low = 990, .high = 1030, .n = 3},
                       {median, median * 99 / 100, median * 103 / 100}};
  }
  return out;
}

std::string bytes_of(const std::filesystem::path& file) { return reports::read_file(file); }

void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

void keep(const std::filesystem::path& file, const std::vector<Record>& records) {
  with_store(file, Access::write, [&](Store& store) {
    for (const Record& one : records) store.add(one);
  });
}

History load(const std::filesystem::path& file) {
  History out;
  with_store(file, Access::read, [&](Store& store) { out = store.load(); });
  return out;
}

std::string exported(const std::filesystem::path& file) { return json_lines(load(file), -1); }

std::string complaint(const std::function<void()>& work) {
  try {
    work();
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace halfway::history::test
