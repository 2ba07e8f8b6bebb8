#pragma once
/// What lanes are made of: the compiler's vectors, halves of them where a register is too narrow, and the few functions
/// that neither has as operators. For core/math/lanes.h alone.
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

/// As many floats as one instruction of the compile target holds. It differs between the object files that
/// core/base/isa.h describes, and so does the layout of wider vectors: neither may be passed between them.
#if defined(__AVX512F__)
constexpr int kNativeWidth = 16;
#elif defined(__AVX__)
constexpr int kNativeWidth = 8;
#else
constexpr int kNativeWidth = 4;
#endif

template <class T, int N>
struct Halves;
/// N values of T: the compiler's vector, or halves where no register is so wide. (g++ 12 splits wider vectors itself,
/// but selects and compares them element by element.)
template <class T, int N, bool fits = (N <= kNativeWidth)>
struct VectorOf {
  using Type = Halves<T, N>;
};
template <class T, int N>
struct VectorOf<T, N, true> {
  typedef T Type __attribute__((vector_size(sizeof(T) * N)));
};

template <class T, int N>
struct Halves {
  using Half = typename VectorOf<T, N / 2>::Type;
  using Truth = Halves<std::int32_t, N>;
  Half low{}, high{};

  T operator[](int i) const { return i < N / 2 ? low[i] : high[i - N / 2]; }
  friend Halves operator+(const Halves& a, const Halves& b) { return {a.low + b.low, a.high + b.high}; }
  friend Halves operator-(const Halves& a, const Halves& b) { return {a.low - b.low, a.high - b.high}; }
  friend Halves operator*(const Halves& a, const Halves& b) { return {a.low * b.low, a.high * b.high}; }
  friend Halves operator/(const Halves& a, const Halves& b) { return {a.low / b.low, a.high / b.high}; }
  friend Halves operator&(const Halves& a, const Halves& b) { return {a.low & b.low, a.high & b.high}; }
  friend Halves operator|(const Halves& a, const Halves& b) { return {a.low | b.low, a.high | b.high}; }
  friend Halves operator^(const Halves& a, const Halves& b) { return {a.low ^ b.low, a.high ^ b.high}; }
  friend Halves operator<<(const Halves& a, int s) { return {a.low << s, a.high << s}; }
  friend Halves operator>>(const Halves& a, int s) { return {a.low >> s, a.high >> s}; }
  friend Halves operator~(const Halves& a) { return {~a.low, ~a.high}; }
  friend Halves operator-(const Halves& a) { return {-a.low, -a.high}; }
  friend Halves operator+(const Halves& a, T b) { return {a.low + b, a.high + b}; }
  friend Halves operator-(const Halves& a, T b) { return {a.low - b, a.high - b}; }
  friend Halves operator-(T a, const Halves& b) { return {a - b.low, a - b.high}; }
  friend Truth operator<(const Halves& a, const Halves& b) { return {a.low < b.low, a.high < b.high}; }
  friend Truth operator<=(const Halves& a, const Halves& b) { return {a.low <= b.low, a.high <= b.high}; }
  friend Truth operator>(const Halves& a, const Halves& b) { return {a.low > b.low, a.high > b.high}; }
  friend Truth operator>=(const Halves& a, const Halves& b) { return {a.low >= b.low, a.high >= b.high}; }
  friend Truth operator==(const Halves& a, const Halves& b) { return {a.low == b.low, a.high == b.high}; }
  friend Truth operator!=(const Halves& a, const Halves& b) { return {a.low != b.low, a.high != b.high}; }
};

namespace raw {
// Operations that a struct cannot offer as operators (v[i] = x, m ? a : b, conversions), for vectors and halves.

template <class V, class T>
void setElement(V& v, int i, T x) {
  v[i] = x;
}
template <class T, int N>
void setElement(Halves<T, N>& v, int i, T x) {
  i < N / 2 ? setElement(v.low, i, x) : setElement(v.high, i - N / 2, x);
}
template <class M, class V>
V choose(const M& m, const V& a, const V& b) {
  return m ? a : b;
}
template <class T, int N>
Halves<T, N> choose(const Halves<std::int32_t, N>& m, const Halves<T, N>& a, const Halves<T, N>& b) {
  return {choose(m.low, a.low, b.low), choose(m.high, a.high, b.high)};
}
/// The same bits as another type.
template <class To, class From>
To castBits(const From& from) {
  return std::bit_cast<To>(from);
}
/// By value.
template <class To, class From>
To convert(const From& from) {
  if constexpr (requires { from.low; }) {
    using Half = typename To::Half;
    return {convert<Half>(from.low), convert<Half>(from.high)};
  } else {
    return __builtin_convertvector(from, To);
  }
}
template <class V>
V squareRoot(const V& x) {
  V r{};
  if constexpr (requires { x.low; }) {
    r = {squareRoot(x.low), squareRoot(x.high)};
  } else {
    for (int i = 0; i < static_cast<int>(sizeof(V) / sizeof(float)); ++i) r[i] = std::sqrt(x[i]);
  }
  return r;
}
/// Bit i is the sign of element i.
template <class V>
std::uint32_t signBits(const V& v) {
  constexpr int count = static_cast<int>(sizeof(V) / sizeof(std::int32_t));
  if constexpr (requires { v.low; }) {
    return signBits(v.low) | (signBits(v.high) << (count / 2));
  } else {
#if defined(__AVX__)
    // One instruction that neither g++ 12 nor clang++ 14 finds in the loop below; worth 10 % of a ray query.
    if constexpr (count == 8) {
      using Floats = typename VectorOf<float, 8>::Type;
      return static_cast<std::uint32_t>(__builtin_ia32_movmskps256(castBits<Floats>(v)));
    }
#endif
#if defined(__SSE__)
    if constexpr (count == 4) {
      using Floats = typename VectorOf<float, 4>::Type;
      return static_cast<std::uint32_t>(__builtin_ia32_movmskps(castBits<Floats>(v)));
    }
#endif
    std::uint32_t bits = 0;
    for (int i = 0; i < count; ++i) bits |= (static_cast<std::uint32_t>(v[i]) >> 31) << i;
    return bits;
  }
}

template <class V>
V reverseBits(const V& x) {
  if constexpr (requires { x.low; }) {
    return {reverseBits(x.low), reverseBits(x.high)};
  } else {
#if defined(__AVX2__)
    // By table, half a byte at a time: seven instructions.
    if constexpr (sizeof(V) == 32) {
      typedef char Bytes __attribute__((vector_size(32)));
      const Bytes order = {3, 2, 1, 0, 7, 6, 5, 4, 11, 10, 9, 8, 15, 14, 13, 12,
                           3, 2, 1, 0, 7, 6, 5, 4, 11, 10, 9, 8, 15, 14, 13, 12};
      const Bytes reversed = {0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15,
                              0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15};
      const V bytes = castBits<V>(__builtin_ia32_pshufb256(castBits<Bytes>(x), order));
      const V low = bytes & 0x0f0f0f0fu, high = (bytes >> 4) & 0x0f0f0f0fu;
      return (castBits<V>(__builtin_ia32_pshufb256(reversed, castBits<Bytes>(low))) << 4) |
             castBits<V>(__builtin_ia32_pshufb256(reversed, castBits<Bytes>(high)));
    }
#endif
    V r = (x >> 16) | (x << 16);
    r = ((r >> 8) & 0x00ff00ffu) | ((r & 0x00ff00ffu) << 8);
    r = ((r >> 4) & 0x0f0f0f0fu) | ((r & 0x0f0f0f0fu) << 4);
    r = ((r >> 2) & 0x33333333u) | ((r & 0x33333333u) << 2);
    return ((r >> 1) & 0x55555555u) | ((r & 0x55555555u) << 1);
  }
}

template <class A, std::size_t... i>
auto join(const A& a, const A& b, std::index_sequence<i...>) {
  return __builtin_shufflevector(a, b, static_cast<int>(i)...);
}
/// a0 b0 a1 b1 of each four elements, or a2 b2 a3 b3 (high); by pairs a0 a1 b0 b1, or a2 a3 b2 b3. One instruction.
template <bool high, bool pairs, class V, std::size_t... i>
V interleave(const V& a, const V& b, std::index_sequence<i...>) {
  constexpr auto from = [](std::size_t lane) {
    const std::size_t k = lane % 4, other = pairs ? k / 2 : k % 2, place = (pairs ? k % 2 : k / 2) + (high ? 2 : 0);
    return static_cast<int>(lane - k + place + other * sizeof...(i));
  };
  return __builtin_shufflevector(a, b, from(i)...);
}
/// The four rows of the records at index[first], ..., index[first + N - 1].
template <int N, class T, class Index>
std::array<typename VectorOf<T, N>::Type, 4> gather4(const T* table, const Index& index, int first) {
  using V = typename VectorOf<T, N>::Type;
  if constexpr (N > kNativeWidth) {
    const auto low = gather4<N / 2>(table, index, first), high = gather4<N / 2>(table, index, first + N / 2);
    return {V{low[0], high[0]}, V{low[1], high[1]}, V{low[2], high[2]}, V{low[3], high[3]}};
  } else {
    const auto load4 = [&](int i) {
      typename VectorOf<T, 4>::Type r;
      __builtin_memcpy(&r, table + index[first + i], sizeof(r));
      return r;
    };
    // Every fourth record, side by side; then each four by four is transposed.
    const auto records = [&](int i) {
      static_assert(N == 4 || N == 8 || N == 16);
      constexpr auto eight = std::make_index_sequence<8>{};
      if constexpr (N == 4) {
        return load4(i);
      } else if constexpr (N == 8) {
        return join(load4(i), load4(i + 4), eight);
      } else {
        return join(join(load4(i), load4(i + 4), eight), join(load4(i + 8), load4(i + 12), eight),
                    std::make_index_sequence<16>{});
      }
    };
    constexpr auto lanes = std::make_index_sequence<static_cast<std::size_t>(N)>{};
    const V a = records(0), b = records(1), c = records(2), d = records(3);
    const V ab01 = interleave<false, false>(a, b, lanes), ab23 = interleave<true, false>(a, b, lanes);
    const V cd01 = interleave<false, false>(c, d, lanes), cd23 = interleave<true, false>(c, d, lanes);
    return {interleave<false, true>(ab01, cd01, lanes), interleave<true, true>(ab01, cd01, lanes),
            interleave<false, true>(ab23, cd23, lanes), interleave<true, true>(ab23, cd23, lanes)};
  }
}
}  // namespace raw

}  // namespace steradian
