#pragma once
/// SIMD lanes: one source for one path or for many.
///
/// Everything in the hot loop is a template over a float-like type F: `float` (width 1) or `Lanes<N>` (N floats that
/// advance together). A condition on F is a `MaskOf<F>` (`bool` or `Mask<N>`) and is consumed by `select`, `any`,
/// `all`, never by `if`. Each operation rounds as the scalar one does, so that width 1 and width N give the same bits.
/// This file and core/math/lanes_vectors.h are the only ones that contain SIMD code: the vector extensions of g++ and
/// clang++.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "steradian/core/math/lanes_vectors.h"

namespace STERADIAN_API steradian {

template <int N>
struct Mask {
  using Raw = typename VectorOf<std::int32_t, N>::Type;
  Raw v{};  ///< all bits of a lane set, or none

  Mask() = default;
  Mask(bool all) : v(Raw{} - static_cast<std::int32_t>(all)) {}
  explicit Mask(Raw raw) : v(raw) {}

  bool operator[](int i) const { return v[i] != 0; }
  void set(int i, bool on) { raw::setElement(v, i, on ? std::int32_t{-1} : std::int32_t{0}); }
  friend Mask operator&(Mask a, Mask b) { return Mask(a.v & b.v); }
  friend Mask operator|(Mask a, Mask b) { return Mask(a.v | b.v); }
  friend Mask operator^(Mask a, Mask b) { return Mask(a.v ^ b.v); }
  friend Mask operator!(Mask a) { return Mask(~a.v); }
  Mask& operator&=(Mask b) { return *this = *this & b; }
  Mask& operator|=(Mask b) { return *this = *this | b; }
};

/// N unsigned or signed 32-bit integers (T); arithmetic wraps.
template <class T, int N>
struct IntLanes {
  using Raw = typename VectorOf<T, N>::Type;
  Raw v{};

  IntLanes() = default;
  IntLanes(T all) : v(Raw{} + all) {}
  explicit IntLanes(Raw raw) : v(raw) {}

  T operator[](int i) const { return v[i]; }
  void set(int i, T x) { raw::setElement(v, i, x); }
  friend IntLanes operator+(IntLanes a, IntLanes b) { return IntLanes(a.v + b.v); }
  friend IntLanes operator-(IntLanes a, IntLanes b) { return IntLanes(a.v - b.v); }
  friend IntLanes operator*(IntLanes a, IntLanes b) { return IntLanes(a.v * b.v); }
  friend IntLanes operator&(IntLanes a, IntLanes b) { return IntLanes(a.v & b.v); }
  friend IntLanes operator|(IntLanes a, IntLanes b) { return IntLanes(a.v | b.v); }
  friend IntLanes operator^(IntLanes a, IntLanes b) { return IntLanes(a.v ^ b.v); }
  friend IntLanes operator~(IntLanes a) { return IntLanes(~a.v); }
  friend IntLanes operator<<(IntLanes a, int s) { return IntLanes(a.v << s); }
  friend IntLanes operator>>(IntLanes a, int s) { return IntLanes(a.v >> s); }
  friend Mask<N> operator==(IntLanes a, IntLanes b) { return Mask<N>(typename Mask<N>::Raw(a.v == b.v)); }
  friend Mask<N> operator!=(IntLanes a, IntLanes b) { return Mask<N>(typename Mask<N>::Raw(a.v != b.v)); }
  friend Mask<N> operator<(IntLanes a, IntLanes b) { return Mask<N>(typename Mask<N>::Raw(a.v < b.v)); }
  friend Mask<N> operator>(IntLanes a, IntLanes b) { return Mask<N>(typename Mask<N>::Raw(a.v > b.v)); }
  IntLanes& operator+=(IntLanes b) { return *this = *this + b; }
  IntLanes& operator*=(IntLanes b) { return *this = *this * b; }
  IntLanes& operator^=(IntLanes b) { return *this = *this ^ b; }
};

template <int N>
struct Lanes {
  using Raw = typename VectorOf<float, N>::Type;
  Raw v{};

  Lanes() = default;
  Lanes(float all) : v(all - Raw{}) {}  // (0 + x would have to be computed: it turns -0 into 0)
  explicit Lanes(Raw raw) : v(raw) {}

  float operator[](int i) const { return v[i]; }
  void set(int i, float x) { raw::setElement(v, i, x); }
  friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.v + b.v); }
  friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.v - b.v); }
  friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.v * b.v); }
  friend Lanes operator/(Lanes a, Lanes b) { return Lanes(a.v / b.v); }
  friend Lanes operator-(Lanes a) { return Lanes(-a.v); }
  friend Mask<N> operator<(Lanes a, Lanes b) { return Mask<N>(typename Mask<N>::Raw(a.v < b.v)); }
  friend Mask<N> operator<=(Lanes a, Lanes b) { return Mask<N>(typename Mask<N>::Raw(a.v <= b.v)); }
  friend Mask<N> operator>(Lanes a, Lanes b) { return Mask<N>(typename Mask<N>::Raw(a.v > b.v)); }
  friend Mask<N> operator>=(Lanes a, Lanes b) { return Mask<N>(typename Mask<N>::Raw(a.v >= b.v)); }
  friend Mask<N> operator==(Lanes a, Lanes b) { return Mask<N>(typename Mask<N>::Raw(a.v == b.v)); }
  friend Mask<N> operator!=(Lanes a, Lanes b) { return Mask<N>(typename Mask<N>::Raw(a.v != b.v)); }
  Lanes& operator+=(Lanes b) { return *this = *this + b; }
  Lanes& operator-=(Lanes b) { return *this = *this - b; }
  Lanes& operator*=(Lanes b) { return *this = *this * b; }
  Lanes& operator/=(Lanes b) { return *this = *this / b; }
};

// --- Types that belong to F -------------------------------------------------------------------------------------

template <class F>
struct LaneTraits;
template <>
struct LaneTraits<float> {
  static constexpr int width = 1;
  using MaskType = bool;
  using IntType = std::int32_t;
  using UintType = std::uint32_t;
};
template <int N>
struct LaneTraits<Lanes<N>> {
  static constexpr int width = N;
  using MaskType = Mask<N>;
  using IntType = IntLanes<std::int32_t, N>;
  using UintType = IntLanes<std::uint32_t, N>;
};
template <class F>
inline constexpr int widthOf = LaneTraits<F>::width;
template <class F>
using MaskOf = typename LaneTraits<F>::MaskType;
template <class F>
using IntOf = typename LaneTraits<F>::IntType;
template <class F>
using UintOf = typename LaneTraits<F>::UintType;

// --- The same functions for one lane and for many ---------------------------------------------------------------

/// Bit i is lane i of the mask.
inline std::uint32_t laneBits(bool m) { return m ? 1u : 0u; }
template <int N>
std::uint32_t laneBits(Mask<N> mask) {
  return raw::signBits(mask.v);
}

inline bool any(bool m) { return m; }
inline bool all(bool m) { return m; }
template <int N>
bool any(Mask<N> m) {
  return laneBits(m) != 0;
}
template <int N>
bool all(Mask<N> m) {
  return laneBits(m) == (1u << N) - 1u;
}

/// `mask ? a : b`, per lane. Both are evaluated: neither may trap, and the unselected one may be NaN.
inline float select(bool m, float a, float b) { return m ? a : b; }
inline bool select(bool m, bool a, bool b) { return m ? a : b; }
inline std::int32_t select(bool m, std::int32_t a, std::int32_t b) { return m ? a : b; }
inline std::uint32_t select(bool m, std::uint32_t a, std::uint32_t b) { return m ? a : b; }
template <int N>
Lanes<N> select(Mask<N> m, std::type_identity_t<Lanes<N>> a, std::type_identity_t<Lanes<N>> b) {
  return Lanes<N>(raw::choose(m.v, a.v, b.v));
}
template <class T, int N>
IntLanes<T, N> select(Mask<N> m, IntLanes<T, N> a, IntLanes<T, N> b) {
  return IntLanes<T, N>(raw::choose(m.v, a.v, b.v));
}
template <int N>
Mask<N> select(Mask<N> m, Mask<N> a, Mask<N> b) {
  return (m & a) | ((!m) & b);
}

inline float minimum(float a, float b) { return a < b ? a : b; }
inline float maximum(float a, float b) { return a > b ? a : b; }
template <int N>
Lanes<N> minimum(Lanes<N> a, std::type_identity_t<Lanes<N>> b) {
  return select(a < b, a, b);
}
template <int N>
Lanes<N> maximum(Lanes<N> a, std::type_identity_t<Lanes<N>> b) {
  return select(a > b, a, b);
}

inline float squareRoot(float x) { return std::sqrt(x); }
template <int N>
Lanes<N> squareRoot(Lanes<N> x) {
  return Lanes<N>(raw::squareRoot(x.v));
}

inline std::uint32_t bitsOf(float x) { return std::bit_cast<std::uint32_t>(x); }
inline float floatOf(std::uint32_t bits) { return std::bit_cast<float>(bits); }
template <int N>
IntLanes<std::uint32_t, N> bitsOf(Lanes<N> x) {
  return IntLanes<std::uint32_t, N>(raw::castBits<typename IntLanes<std::uint32_t, N>::Raw>(x.v));
}
template <int N>
Lanes<N> floatOf(IntLanes<std::uint32_t, N> bits) {
  return Lanes<N>(raw::castBits<typename Lanes<N>::Raw>(bits.v));
}

/// Conversion by value. To integers: towards zero, and the value must be in range.
inline std::int32_t toInt(float x) { return static_cast<std::int32_t>(x); }
inline float toFloat(std::int32_t x) { return static_cast<float>(x); }
inline std::uint32_t toUnsigned(std::int32_t x) { return static_cast<std::uint32_t>(x); }
inline std::int32_t toSigned(std::uint32_t x) { return static_cast<std::int32_t>(x); }
template <int N>
IntLanes<std::int32_t, N> toInt(Lanes<N> x) {
  return IntLanes<std::int32_t, N>(raw::convert<typename IntLanes<std::int32_t, N>::Raw>(x.v));
}
template <int N>
Lanes<N> toFloat(IntLanes<std::int32_t, N> x) {
  return Lanes<N>(raw::convert<typename Lanes<N>::Raw>(x.v));
}
template <int N>
IntLanes<std::uint32_t, N> toUnsigned(IntLanes<std::int32_t, N> x) {
  return IntLanes<std::uint32_t, N>(raw::castBits<typename IntLanes<std::uint32_t, N>::Raw>(x.v));
}
template <int N>
IntLanes<std::int32_t, N> toSigned(IntLanes<std::uint32_t, N> x) {
  return IntLanes<std::int32_t, N>(raw::castBits<typename IntLanes<std::int32_t, N>::Raw>(x.v));
}

/// One lane of a value, and its replacement: the same spelling at width 1.
inline float lane(float x, int) { return x; }
inline bool lane(bool x, int) { return x; }
inline std::uint32_t lane(std::uint32_t x, int) { return x; }
inline void setLane(float& x, int, float value) { x = value; }
inline void setLane(bool& x, int, bool value) { x = value; }
inline void setLane(std::uint32_t& x, int, std::uint32_t value) { x = value; }
template <int N>
float lane(Lanes<N> x, int i) {
  return x[i];
}
template <int N>
bool lane(Mask<N> x, int i) {
  return x[i];
}
template <class T, int N>
T lane(IntLanes<T, N> x, int i) {
  return x[i];
}
template <int N>
void setLane(Lanes<N>& x, int i, float value) {
  x.set(i, value);
}
template <int N>
void setLane(Mask<N>& x, int i, bool value) {
  x.set(i, value);
}
template <class T, int N>
void setLane(IntLanes<T, N>& x, int i, T value) {
  x.set(i, value);
}

/// Quotient of unsigned integers; the remainder goes to `remainder`. (No machine divides vectors of integers.)
inline std::uint32_t divide(std::uint32_t dividend, std::uint32_t divisor, std::uint32_t& remainder) {
  remainder = dividend % divisor;
  return dividend / divisor;
}
template <int N>
IntLanes<std::uint32_t, N> divide(IntLanes<std::uint32_t, N> dividend, std::uint32_t divisor,
                                  IntLanes<std::uint32_t, N>& remainder) {
  IntLanes<std::uint32_t, N> quotient;
  for (int i = 0; i < N; ++i) {
    quotient.set(i, dividend[i] / divisor);
    remainder.set(i, dividend[i] % divisor);
  }
  return quotient;
}

/// `width` consecutive floats from memory (no alignment needed), and back.
template <class F>
F load(const float* from) {
  if constexpr (widthOf<F> == 1) {
    return *from;
  } else {
    F r;
    __builtin_memcpy(static_cast<void*>(&r.v), from, sizeof(r.v));
    return r;
  }
}
template <class F>
void store(float* to, F x) {
  __builtin_memcpy(to, &x, sizeof(x));
}

/// The 32 bits in opposite order.
constexpr std::uint32_t reverseBits(std::uint32_t x) {
  x = __builtin_bswap32(x);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  return ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
}
template <int N>
IntLanes<std::uint32_t, N> reverseBits(IntLanes<std::uint32_t, N> x) {
  return IntLanes<std::uint32_t, N>(raw::reverseBits(x.v));
}

/// table[index] per lane.
inline float gather(const float* table, std::uint32_t index) { return table[index]; }
template <int N>
Lanes<N> gather(const float* table, IntLanes<std::uint32_t, N> index) {
  Lanes<N> r;
  for (int i = 0; i < N; ++i) r.set(i, table[index[i]]);
  return r;
}
inline std::uint32_t gather(const std::uint32_t* table, std::uint32_t index) { return table[index]; }
template <int N>
IntLanes<std::uint32_t, N> gather(const std::uint32_t* table, IntLanes<std::uint32_t, N> index) {
  IntLanes<std::uint32_t, N> r;
  for (int i = 0; i < N; ++i) r.set(i, table[index[i]]);
  return r;
}

/// table[index] to table[index + 3] per lane: records of four in a quarter of the instructions that four gathers take,
/// by loading each lane's record as a whole and transposing.
inline std::array<float, 4> gather4(const float* table, std::uint32_t index) {
  const float* record = table + index;
  return {record[0], record[1], record[2], record[3]};
}
inline std::array<std::uint32_t, 4> gather4(const std::uint32_t* table, std::uint32_t index) {
  const std::uint32_t* record = table + index;
  return {record[0], record[1], record[2], record[3]};
}
template <int N>
std::array<Lanes<N>, 4> gather4(const float* table, const IntLanes<std::uint32_t, N>& index) {
  const auto r = raw::gather4<N>(table, index, 0);
  return {Lanes<N>(r[0]), Lanes<N>(r[1]), Lanes<N>(r[2]), Lanes<N>(r[3])};
}
template <int N>
std::array<IntLanes<std::uint32_t, N>, 4> gather4(const std::uint32_t* table, const IntLanes<std::uint32_t, N>& index) {
  using Ints = IntLanes<std::uint32_t, N>;
  const auto r = raw::gather4<N>(table, index, 0);
  return {Ints(r[0]), Ints(r[1]), Ints(r[2]), Ints(r[3])};
}

}  // namespace steradian
