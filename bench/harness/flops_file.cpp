#include "bench/harness/flops.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <stdexcept>

namespace halfway::bench {

const Flops& kept_flops() {
  static const Flops kept = [] {
    const std::string file = HALFWAY_FLOPS_FILE;
    std::ifstream in(file);
    if (!in) throw std::runtime_error(fmt::format("{}: cannot be read", file));
    try {
      return nlohmann::json::parse(in).at("flops").get<Flops>();
    } catch (const nlohmann::json::exception& error) {
      throw std::runtime_error(fmt::format("{}: {}", file, error.what()));
    }
  }();
  return kept;
}

double kept_flops(const std::string& name) {
  const auto found = kept_flops().find(name);
  return found == kept_flops().end() ? 0 : found->second;
}

void write_flops(const std::filesystem::path& file, const Flops& flops) {
  const std::string part = file.string() + ".part";
  std::ofstream out(part);
  out << nlohmann::json{{"flops", flops}}.dump(1) << '\n';
  out.close();
  if (!out) throw std::runtime_error(fmt::format("cannot write {}", part));
  std::filesystem::rename(part, file);
}

}  // namespace halfway::bench
