#include "steradian/core/film/film_kernels.h"

#include <algorithm>

namespace steradian {
namespace {

/// Samples below these limits take the fast path: steps64 and ShortSum128.
constexpr float kNarrowLimit = 0x1p18f;
constexpr float kDepthLimit = 0x1p31f;

constexpr std::size_t kBatch = SampleSums::kMaxCount;
using Column = std::array<float, kBatch>;

/// Up to kBatch samples by channel, padded with zeros, which change no sum: loops that the compiler turns into SIMD.
struct Batch {
  std::array<Column, 10> values{};
  Column depth{};  // 0 for a miss
  std::uint32_t hits = 0;

  explicit Batch(std::span<const PixelSample> samples) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const std::array<float, 10> v = valuesOf(samples[i]);
      for (std::size_t c = 0; c < v.size(); ++c) values[c][i] = v[c];
      const bool hit = samples[i].depth != kInfinity;
      depth[i] = hit ? samples[i].depth : 0.0f;
      hits += hit ? 1u : 0u;
    }
  }
  /// All values are finite and small enough for the fast path. Compares bits, which order magnitudes as their values
  /// do, NaN and infinity last; by place first, by channel only in the end, because that is the order of SIMD lanes.
  bool ordinary() const {
    std::array<std::uint32_t, kBatch> largest{};
    for (const Column& column : values) {
      for (std::size_t i = 0; i < kBatch; ++i) largest[i] = std::max(largest[i], bitsOf(absolute(column[i])));
    }
    std::uint32_t largestValue = 0, largestDepth = 0;
    for (std::size_t i = 0; i < kBatch; ++i) {
      largestValue = std::max(largestValue, largest[i]);
      largestDepth = std::max(largestDepth, bitsOf(absolute(depth[i])));
    }
    return largestValue < bitsOf(kNarrowLimit) && largestDepth < bitsOf(kDepthLimit);
  }
};

FixedPoint128 wideSum(const Column& column) {
  ShortSum128 sum;
  for (const float v : column) sum.add(v);
  return sum.total();
}

FixedPoint64 narrowSum(const Column& column) {
  std::int64_t steps = 0;
  for (const float v : column) steps += steps64(v);
  return FixedPoint64::fromSteps(steps);
}

bool sum(std::span<const PixelSample> samples, SampleSums& sums) {
  const Batch batch(samples);
  if (!batch.ordinary()) return false;
  for (std::size_t c = 0; c < 3; ++c) sums.radiance[c] = wideSum(batch.values[c]);
  sums.depth = wideSum(batch.depth);
  for (std::size_t c = 0; c < sums.narrow.size(); ++c) sums.narrow[c] = narrowSum(batch.values[c + 3]);
  for (std::size_t i = 0; i < kBatch; ++i) {
    sums.luminance[i] = steps64(luminance(Rgb{batch.values[0][i], batch.values[1][i], batch.values[2][i]}));
  }
  sums.hits = batch.hits;
  return true;
}

}  // namespace

namespace STERADIAN_ISA {
constinit const FilmKernels filmKernels{sum};
}

}  // namespace steradian
