// A pack of joints as one scalar: the compiler's own vectors, one joint per lane.
//
// Why no library: none is faster. The invariant angular kernel, 8 doubles of AVX-512, g++ 12, ns per joint,
// residual / with tangent: these vectors 3.6 / 10.0, xsimd 8.1 3.6 / 10.2, Highway 1.0 3.7 / 10.2,
// std::experimental::simd 3.6 / 10.1 (best of runs on an AMD Zen 4, noise about 0.1); and the last is g++'s
// alone.
//
// The instruction set is part of the type, so that no function compiled for one is ever linked into
// code for another (a plain `inline` function would be: the linker keeps one of its copies).
#pragma once

#include "halfway/kernels/core/scalar.hpp"

namespace halfway::batch {

/// Tags of the instruction sets, with the width of a register in bytes.
struct Sse2 {
  static constexpr int kBytes = 16;
};
struct Avx2 {
  static constexpr int kBytes = 32;
};
struct Avx2Vl {  // of AVX-512VL: the registers are 32, not 16
  static constexpr int kBytes = 32;
};
struct Avx512 {
  static constexpr int kBytes = 64;
};

namespace detail {
template <class T>
struct BitsOf;
template <>
struct BitsOf<double> {
  using type = long long;
};
template <>
struct BitsOf<float> {
  using type = int;
};
}  // namespace detail

// Square roots and streaming stores have no spelling that both compilers share but the instruction.
#ifdef __SSE2__
#ifdef __AVX__
#define HALFWAY_VECTOR_INSTRUCTION(name, operands) "v" name " " operands
#else
#define HALFWAY_VECTOR_INSTRUCTION(name, operands) name " " operands
#endif
#ifdef __AVX512F__
#define HALFWAY_VECTOR_REGISTER "v"
#else
#define HALFWAY_VECTOR_REGISTER "x"
#endif
#endif

template <class V>
HALFWAY_INLINE V vector_sqrt(const V& x) {
  V root;
#ifdef __SSE2__
  if constexpr (sizeof(x[0]) == 8)
    asm(HALFWAY_VECTOR_INSTRUCTION("sqrtpd", "%1, %0")
        : "=" HALFWAY_VECTOR_REGISTER(root)
        : HALFWAY_VECTOR_REGISTER(x));
  else
    asm(HALFWAY_VECTOR_INSTRUCTION("sqrtps", "%1, %0")
        : "=" HALFWAY_VECTOR_REGISTER(root)
        : HALFWAY_VECTOR_REGISTER(x));
#else
  for (int i = 0; i < int(sizeof(V) / sizeof(x[0])); ++i) root[i] = __builtin_sqrt(x[i]);
#endif
  return root;
}

/// A store past the caches; `to` on a boundary of the vector's size.
template <class V>
HALFWAY_INLINE void stream(void* to, const V& x) {
#ifdef __SSE2__
  asm volatile(HALFWAY_VECTOR_INSTRUCTION("movntpd", "%1, %0")
               : "=m"(*static_cast<V*>(to))
               : HALFWAY_VECTOR_REGISTER(x));
#else
  __builtin_memcpy(to, &x, sizeof x);
#endif
}

template <class Number, class Isa>
struct Pack {
  static constexpr int kLanes = Isa::kBytes / int(sizeof(Number));
  typedef Number V __attribute__((vector_size(Isa::kBytes)));
  typedef typename detail::BitsOf<Number>::type Bits __attribute__((vector_size(Isa::kBytes)));

  V v;

  Pack() = default;
  HALFWAY_INLINE explicit Pack(double x) : v(Number(x) - V{}) {}  // x - 0 is x, of either sign
  HALFWAY_INLINE explicit Pack(V x) : v(x) {}

  /// The same vector wherever its numbers lie. No memcpy: g++ moves what it copies in halves.
  typedef Number Anywhere __attribute__((vector_size(Isa::kBytes), aligned(sizeof(Number)), may_alias));

  static HALFWAY_INLINE Pack load(const Number* from) {
    return Pack(V(*reinterpret_cast<const Anywhere*>(from)));
  }
  HALFWAY_INLINE void store(Number* to) const { *reinterpret_cast<Anywhere*>(to) = v; }
  /// Past the caches; `to` on a boundary of kBytes.
  HALFWAY_INLINE void stream(Number* to) const { batch::stream(to, v); }

  friend HALFWAY_INLINE Pack operator+(const Pack& a, const Pack& b) { return Pack(V(a.v + b.v)); }
  friend HALFWAY_INLINE Pack operator-(const Pack& a, const Pack& b) { return Pack(V(a.v - b.v)); }
  friend HALFWAY_INLINE Pack operator*(const Pack& a, const Pack& b) { return Pack(V(a.v * b.v)); }
  friend HALFWAY_INLINE Pack operator/(const Pack& a, const Pack& b) { return Pack(V(a.v / b.v)); }
  friend HALFWAY_INLINE Pack operator-(const Pack& a) { return Pack(V(-a.v)); }

  /// -1 where the sign bit of x is set, otherwise 1.
  friend HALFWAY_INLINE Pack sign_of(const Pack& x) {
    const V minus_zero = -V{}, one = Number(1) - V{};
    return Pack(V((Bits(x.v) & Bits(minus_zero)) | Bits(one)));
  }
  friend HALFWAY_INLINE Pack where_negative(const Pack& x, const Pack& negative, const Pack& other) {
    return Pack(V(x.v < V{} ? negative.v : other.v));
  }
  friend HALFWAY_INLINE Pack sqrt(const Pack& x) { return Pack(vector_sqrt(x.v)); }
};

}  // namespace halfway::batch

namespace halfway::kernel {
template <class Number, class Isa>
struct Digits<batch::Pack<Number, Isa>> : Digits<Number> {};
}  // namespace halfway::kernel
