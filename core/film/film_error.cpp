#include "steradian/core/film/film_error.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace steradian {
namespace {

/// Calls f with each block of the film.
template <class Function>
void forEachBlock(const Film& film, int side, Function f) {
  const Crop& c = film.crop();
  for (int y = c.y0; y < c.y1; y += side) {
    for (int x = c.x0; x < c.x1; x += side) {
      f(Crop{x, std::min(x + side, c.x1), y, std::min(y + side, c.y1)});
    }
  }
}

std::vector<MeanEstimate> luminances(const Film& film, const Crop& block) {
  std::vector<MeanEstimate> result;
  for (int y = block.y0; y < block.y1; ++y) {
    for (int x = block.x0; x < block.x1; ++x) result.push_back(film.luminanceEstimate(x, y));
  }
  return result;
}

}  // namespace

std::vector<BlockEstimate> estimateBlocks(const Film& film, int side) {
  std::vector<BlockEstimate> result;
  forEachBlock(film, std::max(side, 1), [&](const Crop& block) {
    double sum = 0.0, variance = 0.0, varianceOfVariance = 0.0;
    bool known = true;
    const std::vector<MeanEstimate> pixels = luminances(film, block);
    for (const MeanEstimate& p : pixels) {
      sum += p.mean;
      known &= p.degreesOfFreedom > 0;
      if (p.degreesOfFreedom == 0) continue;
      const double v = p.standardError * p.standardError;
      variance += v;
      varianceOfVariance += v * v / p.degreesOfFreedom;
    }
    const double n = static_cast<double>(pixels.size());
    BlockEstimate estimate{.pixels = block, .mean = sum / n};
    if (known) {
      estimate.standardError = std::sqrt(variance) / n;
      // A block without any spread: as many degrees as its pixels have.
      const double degrees = std::accumulate(pixels.begin(), pixels.end(), 0.0,
                                             [](double d, const MeanEstimate& p) { return d + p.degreesOfFreedom; });
      estimate.degreesOfFreedom = varianceOfVariance > 0.0 ? variance * variance / varianceOfVariance : degrees;
    }
    result.push_back(estimate);
  });
  return result;
}

double estimateRelMse(const Film& film) {
  std::vector<double> errors;
  forEachBlock(film, 8, [&](const Crop& block) {
    const std::vector<MeanEstimate> pixels = luminances(film, block);
    double variance = 0.0;
    int known = 0;
    for (const MeanEstimate& p : pixels) {
      if (p.degreesOfFreedom == 0) continue;
      variance += p.standardError * p.standardError;
      ++known;
    }
    for (const MeanEstimate& p : pixels) {
      errors.push_back(p.degreesOfFreedom > 0 ? variance / known / (p.mean * p.mean + 0.01)
                                              : std::numeric_limits<double>::infinity());
    }
  });
  const std::size_t kept = errors.size() - errors.size() / 1000;
  std::sort(errors.begin(), errors.end());
  return std::accumulate(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(kept), 0.0) /
         static_cast<double>(kept);
}

}  // namespace steradian
