#include "steradian/core/sampling/sampled_inverse_cdf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "steradian/core/base/diagnostics.h"

namespace steradian {

namespace {

constexpr int kMaxDepth = 16;

/// A knot of the cumulative distribution: `before` of the sum of weights lies before x.
struct Knot {
  double x, before;
};

std::vector<WeightedPlace> checkedAndSorted(std::span<const WeightedPlace> samples, float low, float high) {
  if (samples.empty()) throw Error(ErrorKind::Usage, "a distribution of samples needs at least one");
  if (!(low < high) || !std::isfinite(high - low)) {
    throw Error(ErrorKind::Usage, fmt::format("a distribution of samples has the domain [{}, {}]", low, high));
  }
  for (const WeightedPlace& s : samples) {
    if (!(s.x >= low && s.x <= high)) {
      throw Error(ErrorKind::Usage, fmt::format("a sample lies at {}: not in [{}, {}]", s.x, low, high));
    }
    if (!(s.weight >= 0.0f) || std::isinf(s.weight)) {
      throw Error(ErrorKind::Usage, fmt::format("a sample has the weight {}: not a finite number >= 0", s.weight));
    }
  }
  std::vector<WeightedPlace> sorted(samples.begin(), samples.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  return sorted;
}

/// The cumulative distribution, straight between knots: the last one has the sum of all weights.
std::vector<Knot> knotsOf(std::span<const WeightedPlace> sorted, float low, float high) {
  std::vector<Knot> knots{{low, 0.0}};
  double sum = 0.0;
  for (std::size_t i = 0; i < sorted.size();) {
    const float x = sorted[i].x;
    double weight = 0.0;
    for (; i < sorted.size() && sorted[i].x == x; ++i) weight += static_cast<double>(sorted[i].weight);
    // What lies on an end has no room on its other side.
    const bool inside = x > low && x < high;
    if (inside) knots.push_back({x, sum + 0.5 * weight});
    sum += weight;
  }
  if (!(sum > 0.0)) return {{low, 0.0}, {high, 1.0}};
  knots.push_back({high, sum});
  return knots;
}

}  // namespace

SampledInverseCdf::SampledInverseCdf(std::span<const WeightedPlace> samples, float low, float high, int depth) {
  if (depth < 0 || depth > kMaxDepth) {
    throw Error(ErrorKind::Usage, fmt::format("a binary partition of depth {}: not in [0, {}]", depth, kMaxDepth));
  }
  const std::vector<Knot> knots = knotsOf(checkedAndSorted(samples, low, high), low, high);
  const std::size_t bins = std::size_t{1} << depth;
  edges_.push_back(low);
  std::size_t k = 0;
  for (std::size_t i = 1; i < bins; ++i) {
    const double target = knots.back().before * static_cast<double>(i) / static_cast<double>(bins);
    while (knots[k + 1].before < target) ++k;
    const Knot &a = knots[k], &b = knots[k + 1];
    const double t = (target - a.before) / (b.before - a.before);
    // A bin too narrow for floats gets the width of one of their steps.
    const auto edge = static_cast<float>(a.x + (b.x - a.x) * t);
    edges_.push_back(std::max(edge, std::nextafter(edges_.back(), high)));
  }
  edges_.push_back(high);
  for (std::size_t i = bins; i-- > 1 && edges_[i] >= edges_[i + 1];) edges_[i] = std::nextafter(edges_[i + 1], low);
  if (!(edges_[0] < edges_[1])) {
    throw Error(ErrorKind::Usage, fmt::format("[{}, {}] is too narrow for {} bins", low, high, bins));
  }
}

}  // namespace steradian
