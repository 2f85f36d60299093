// The kept numbers: bench/instructions.json.
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/harness/instructions.hpp"

namespace halfway::bench {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MadeWith, compiler, flags, eigen, libc, libm_code)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(InstructionCount, name, instructions)

InstructionBaseline read_instructions(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(fmt::format("{}: cannot be read", file.string()));
  try {
    const auto json = nlohmann::json::parse(in);
    return {json.at("made_with").get<MadeWith>(), json.at("instructions").get<InstructionCounts>()};
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
  }
}

void write_instructions(const std::filesystem::path& file, const InstructionBaseline& baseline) {
  nlohmann::json json{{"made_with", baseline.with}, {"instructions", baseline.counts}};
  for (auto& count : json["instructions"])
    count["instructions"] = std::round(10 * double(count["instructions"])) / 10;
  const std::string part = file.string() + ".part";
  std::ofstream out(part);
  out << json.dump(2) << '\n';
  out.close();
  if (!out) throw std::runtime_error(fmt::format("cannot write {}", part));
  std::filesystem::rename(part, file);
}

InstructionCounts kept_instructions() {
  const InstructionBaseline kept = read_instructions(HALFWAY_INSTRUCTIONS_FILE);
  return kept.with == made_with() ? kept.counts : InstructionCounts{};
}

}  // namespace halfway::bench
