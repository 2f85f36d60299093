#include "halfway/batch/isa.hpp"

#include <cstdlib>
#include <iterator>
#include <stdexcept>
#include <string>

namespace halfway::batch {
namespace {

std::string missing(const std::string& name, const char* from) {
  std::string has;
  for (auto isa = std::rbegin(kIsas); isa != std::rend(kIsas); ++isa) {
    if (available(*isa)) has += std::string(has.empty() ? "" : ", ") + to_string(*isa);
  }
  return "instruction set " + name + from + ": this machine has " + has;
}

}  // namespace

const char* to_string(Isa isa) {
  constexpr const char* kNames[] = {"sse2", "avx2", "avx2vl", "avx512"};
  return kNames[int(isa)];
}

bool available(Isa isa) {
#ifdef __x86_64__
  if (isa == Isa::avx2) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (isa == Isa::avx512 || isa == Isa::avx2vl) {
    return available(Isa::avx2) && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
  }
#endif
  return isa == Isa::sse2;
}

Isa choose(std::optional<Isa> wanted) {
  if (wanted) {
    if (!available(*wanted)) throw std::invalid_argument(missing(to_string(*wanted), ""));
    return *wanted;
  }
  const char* const name = std::getenv("HALFWAY_ISA");
  const std::string_view forced = name == nullptr ? "" : name;
  for (auto isa = std::rbegin(kIsas); isa != std::rend(kIsas); ++isa) {
    if (available(*isa) && (forced.empty() || forced == to_string(*isa))) return *isa;
  }
  throw std::invalid_argument(missing("'" + std::string(forced) + "'", " of HALFWAY_ISA"));
}

}  // namespace halfway::batch
