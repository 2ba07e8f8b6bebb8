#pragma once
/// Exact sums: numbers in fixed point, whose addition does not round, so that any order and any grouping of the same
/// numbers gives the same bits. (Floating-point partial sums that are merged later differ in nearly every pixel.)
///
/// A number is rounded once, to a whole number of steps (nearest, ties to even), when it enters (in the default
/// rounding mode).
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

/// 128 bits in steps of 2^-64: exact for every float of magnitude in [2^-41, 2^63), and within 2^-65 below that.
///
/// The sum of numbers whose magnitudes add up to less than 2^63 is exact. Beyond that it saturates: it becomes +-limit
/// and stays there, regardless of later additions. Saturation, too, is independent of the order if no number is
/// negative.
class FixedPoint128 {
 public:
  __extension__ typedef __int128 Steps;  // `using` cannot carry __extension__, which keeps -Wpedantic quiet

  constexpr FixedPoint128() = default;
  static constexpr FixedPoint128 fromSteps(Steps steps) {
    FixedPoint128 r;
    r.steps_ = steps < -kLimit ? -kLimit : steps > kLimit ? kLimit : steps;
    return r;
  }
  /// `x` must not be NaN; +-infinity saturates.
  static FixedPoint128 from(double x) {
    const double magnitude = std::fabs(x);
    if (magnitude >= 0x1p63) return fromSteps(x < 0.0 ? -kLimit : kLimit);
    // Below 2^-11 the steps fit a double's mantissa; from there on every double is a whole number of steps.
    if (magnitude < 0x1p-11) return fromSteps(static_cast<Steps>(std::nearbyint(x * 0x1p64)));
    const double whole = std::floor(magnitude);
    const Steps steps = static_cast<Steps>(whole) * kOne + static_cast<Steps>((magnitude - whole) * 0x1p64);
    return fromSteps(x < 0.0 ? -steps : steps);
  }

  constexpr FixedPoint128& operator+=(FixedPoint128 b) {
    if (saturated()) return *this;
    if (b.saturated()) return *this = b;
    Steps sum = 0;
    if (__builtin_add_overflow(steps_, b.steps_, &sum)) sum = steps_ < 0 ? -kLimit : kLimit;
    return *this = fromSteps(sum);
  }
  friend constexpr bool operator==(FixedPoint128, FixedPoint128) = default;

  constexpr Steps steps() const { return steps_; }
  constexpr bool saturated() const { return steps_ == kLimit || steps_ == -kLimit; }
  /// The nearest double; +-2^63 where saturated.
  constexpr double toDouble() const { return static_cast<double>(steps_) * 0x1p-64; }

 private:
  static constexpr Steps kOne = static_cast<Steps>(1) << 64;
  static constexpr Steps kLimit = static_cast<Steps>(std::numeric_limits<std::int64_t>::max()) * kOne + (kOne - 1);

  Steps steps_ = 0;
};

/// 64 bits in steps of 2^-32: exact for every float of magnitude in [2^-9, 2^31), and within 2^-33 below that.
/// It adds and saturates as FixedPoint128 does, with the limit 2^31.
class FixedPoint64 {
 public:
  constexpr FixedPoint64() = default;
  static constexpr FixedPoint64 fromSteps(std::int64_t steps) {
    FixedPoint64 r;
    r.steps_ = steps < -kLimit ? -kLimit : steps;
    return r;
  }
  /// `x` must not be NaN; +-infinity saturates.
  static FixedPoint64 from(double x) {
    if (std::fabs(x) >= 0x1p31) return fromSteps(x < 0.0 ? -kLimit : kLimit);
    return fromSteps(static_cast<std::int64_t>(std::nearbyint(x * 0x1p32)));
  }

  constexpr FixedPoint64& operator+=(FixedPoint64 b) {
    if (saturated()) return *this;
    if (b.saturated()) return *this = b;
    std::int64_t sum = 0;
    if (__builtin_add_overflow(steps_, b.steps_, &sum)) sum = steps_ < 0 ? -kLimit : kLimit;
    return *this = fromSteps(sum);
  }
  friend constexpr bool operator==(FixedPoint64, FixedPoint64) = default;

  constexpr std::int64_t steps() const { return steps_; }
  constexpr bool saturated() const { return steps_ == kLimit || steps_ == -kLimit; }
  /// The nearest double; +-2^31 where saturated.
  constexpr double toDouble() const { return static_cast<double>(steps_) * 0x1p-32; }

 private:
  static constexpr std::int64_t kLimit = std::numeric_limits<std::int64_t>::max();

  std::int64_t steps_ = 0;
};

/// FixedPoint64::from(x).steps() for |x| < 2^18, in an addition and a subtraction: in the binade of 1.5 * 2^20 a
/// double's last place is 2^-32, so adding rounds x to whole steps, which then stand in the last bits.
inline std::int64_t steps64(double x) {
  constexpr double binade = 0x1.8p20;
  return std::bit_cast<std::int64_t>(x + binade) - std::bit_cast<std::int64_t>(binade);
}

/// Accumulates up to 2048 numbers below 2^31 before they are added to a FixedPoint128: two 64-bit integers, the upper
/// in steps of 2^-20, the lower in steps of 2^-64. The result is that of FixedPoint128::from of each number, at a
/// fraction of the cost, and without a branch.
struct ShortSum128 {
  static constexpr int kMaxCount = 2048;

  std::int64_t high = 0, low = 0;

  /// |x| < 2^31
  void add(double x) {
    constexpr double highBinade = 0x1.8p32, lowBinade = 0x1.8p-12;
    const double shifted = x + highBinade;
    const double rest = x - (shifted - highBinade);  // exact, and at most 2^-21
    high += std::bit_cast<std::int64_t>(shifted) - std::bit_cast<std::int64_t>(highBinade);
    low += std::bit_cast<std::int64_t>(rest + lowBinade) - std::bit_cast<std::int64_t>(lowBinade);
  }
  FixedPoint128 total() const {
    using Steps = FixedPoint128::Steps;
    return FixedPoint128::fromSteps(static_cast<Steps>(high) * (static_cast<Steps>(1) << 44) + low);
  }
};

}  // namespace steradian
