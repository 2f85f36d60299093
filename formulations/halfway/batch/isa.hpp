// The instruction sets that a batch can use.
#pragma once

#include <optional>
#include <string_view>

namespace halfway::batch {

enum class Isa { sse2, avx2, avx2vl, avx512 };
inline constexpr Isa kIsas[] = {Isa::sse2, Isa::avx2, Isa::avx2vl, Isa::avx512};

/// Of one register.
constexpr int bytes(Isa isa) { return isa == Isa::sse2 ? 16 : isa == Isa::avx512 ? 64 : 32; }

/// sse2 is what every x86-64 has, and elsewhere means the compiler's own vectors; avx2vl: packs as wide as
/// those of avx2, in the 32 registers of AVX-512VL.
const char* to_string(Isa isa);

/// Has this machine that set?
bool available(Isa isa);

/// `wanted`, or what HALFWAY_ISA names, or the widest here. Throws std::invalid_argument that names the
/// set where the machine lacks it, or a value that names none.
Isa choose(std::optional<Isa> wanted);

}  // namespace halfway::batch
