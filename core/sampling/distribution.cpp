#include "steradian/core/sampling/distribution.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "steradian/core/base/diagnostics.h"

namespace steradian {

namespace {

constexpr std::size_t kMaxBins = std::size_t{1} << 22;
constexpr std::int64_t kSteps = std::int64_t{1} << 24;

/// The sum of the weights, after looking at each.
double checkedSum(std::span<const float> weights) {
  if (weights.empty()) throw Error(ErrorKind::Usage, "a distribution needs at least one weight");
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!(weights[i] >= 0.0f) || std::isinf(weights[i])) {
      throw Error(ErrorKind::Usage,
                  fmt::format("weight {} of a distribution is {}: not a finite number >= 0", i, weights[i]));
    }
    sum += weights[i];
  }
  return sum;
}

void checkBins(std::size_t bins) {
  if (bins > kMaxBins) {
    throw Error(ErrorKind::Usage, fmt::format("a distribution has {} bins: more than {}", bins, kMaxBins));
  }
}

/// Appends the cumulative sums of one table.
void appendCumulative(std::span<const float> weights, std::vector<float>& out) {
  const double total = checkedSum(weights);
  const auto weight = [&](std::size_t i) { return total > 0.0 ? static_cast<double>(weights[i]) : 1.0; };
  const double sum = total > 0.0 ? total : static_cast<double>(weights.size());
  auto positiveLeft = static_cast<std::int64_t>(weights.size());
  if (total > 0.0) {
    positiveLeft = std::count_if(weights.begin(), weights.end(), [](float w) { return w > 0.0f; });
  }
  std::int64_t steps = 0;
  double partial = 0.0;
  out.push_back(0.0f);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weight(i) > 0.0) {
      partial += weight(i);
      --positiveLeft;
      const std::int64_t ideal = std::llround(partial / sum * static_cast<double>(kSteps));
      // At least one step for this bin, and one left for each that follows; the last takes the rest.
      steps = positiveLeft == 0 ? kSteps : std::clamp(ideal, steps + 1, kSteps - positiveLeft);
    }
    out.push_back(static_cast<float>(steps) * 0x1p-24f);
  }
}

std::vector<float> rowSums(std::span<const float> weights, std::size_t columns, std::size_t rows) {
  if (columns == 0 || rows == 0 || weights.size() / columns != rows || weights.size() % columns != 0) {
    throw Error(ErrorKind::Usage,
                fmt::format("a distribution of {} x {} cells has {} weights", columns, rows, weights.size()));
  }
  std::vector<double> sums;
  for (std::size_t row = 0; row < rows; ++row) sums.push_back(checkedSum(weights.subspan(row * columns, columns)));
  // The sums of large weights need not be floats; their ratios are what counts.
  const double largest = *std::max_element(sums.begin(), sums.end());
  std::vector<float> scaled;
  for (const double sum : sums) {
    const auto share = static_cast<float>(largest > 0.0 ? sum / largest : 0.0);
    scaled.push_back(sum > 0.0 ? std::max(share, std::numeric_limits<float>::denorm_min()) : 0.0f);
  }
  return scaled;
}

}  // namespace

std::vector<float> detail::cumulative(std::span<const float> weights) {
  checkBins(weights.size());
  std::vector<float> sums;
  sums.reserve(weights.size() + 1);
  appendCumulative(weights, sums);
  return sums;
}

PiecewiseConstant1D::PiecewiseConstant1D(std::span<const float> weights, float low, float high)
    : cumulative_(detail::cumulative(weights)),
      low_(low),
      high_(high),
      binWidth_((high - low) / static_cast<float>(weights.size())),
      last_(std::nextafter(high, low)) {
  if (!(low < high) || !std::isfinite(1.0f / binWidth_) || !std::isfinite(high - low)) {
    throw Error(ErrorKind::Usage, fmt::format("a distribution has the domain [{}, {})", low, high));
  }
}

PiecewiseConstant2D::PiecewiseConstant2D(std::span<const float> weights, std::size_t columns, std::size_t rows)
    : columns_(static_cast<std::uint32_t>(columns)),
      rows_(static_cast<std::uint32_t>(rows)),
      marginal_(rowSums(weights, columns, rows)) {
  checkBins(columns);
  conditional_.reserve((columns + 1) * rows);
  if (conditional_.capacity() > 0xffffffffu) throw Error(ErrorKind::Usage, "a distribution has more than 2^32 cells");
  for (std::size_t row = 0; row < rows; ++row) appendCumulative(weights.subspan(row * columns, columns), conditional_);
}

AliasTable::AliasTable(std::span<const float> weights) {
  const std::vector<float> sums = detail::cumulative(weights);
  const std::size_t slots = std::bit_ceil(weights.size());
  const std::int64_t capacity = kSteps / static_cast<std::int64_t>(slots);
  std::vector<std::int64_t> steps(slots, 0);
  std::vector<std::uint32_t> small, large;
  for (std::size_t i = 0; i < slots; ++i) {
    if (i < weights.size()) {
      probability_.push_back(sums[i + 1] - sums[i]);
      steps[i] = static_cast<std::int64_t>(probability_[i] * static_cast<float>(kSteps));
    }
    alias_.push_back(static_cast<std::uint32_t>(i));
    (steps[i] < capacity ? small : large).push_back(static_cast<std::uint32_t>(i));
  }
  threshold_.assign(slots, 1.0f);
  // The sum of all steps fills all slots, so that whenever one is short another has too much.
  while (!small.empty()) {
    const std::uint32_t poor = small.back(), rich = large.back();
    small.pop_back();
    threshold_[poor] = static_cast<float>(steps[poor]) / static_cast<float>(capacity);
    alias_[poor] = rich;
    steps[rich] -= capacity - steps[poor];
    if (steps[rich] < capacity) {
      large.pop_back();
      small.push_back(rich);
    }
  }
}

}  // namespace steradian
