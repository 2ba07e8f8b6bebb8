#pragma once
/// Monte Carlo as a library: the mean of a function over random points, with its error.
///
///     // The integral of x^2 over [0, 2]: the mean of x^2 / pdf for x uniform, pdf = 1/2.
///     const Estimate e = estimate([](const Sampler<float>& point) {
///       const double x = 2.0 * centred(point.get1D(0u));
///       return x * x / 0.5;
///     }, {.sampler = SamplerType::Sobol});
///     const Interval i = confidenceInterval(e);   // holds 8/3 in 95 of 100 runs
///
/// The function is given a `Sampler`: its coordinates are `get1D(d)` and `get2D(d)` for any dimensions d, each drawn
/// once. It need not know which kind of sampler it is given.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "steradian/core/samplers/sampler.h"
#include "steradian/core/statistics/running_mean.h"
#include "steradian/core/statistics/standard_error.h"

namespace STERADIAN_API steradian {

/// The middle of the step of 2^-24 that a random number of a sampler stands for, in (0, 1). Numbers are rounded down to
/// their step, which shifts means by 2^-25 of a slope: less than noise, but more than the error of a long Sobol'
/// sequence.
constexpr double centred(float u) { return static_cast<double>(u) + 0x1p-25; }

struct EstimateSettings {
  SamplerType sampler = SamplerType::Independent;
  std::uint32_t samples = 1u << 16;  ///< N, in all; at least 1
  /// R, at least 1: with stratified and Sobol' points, the error is estimated from R independently randomised sets of
  /// about N / R points. Each is smaller than one set of all points; for R = 1 the error is not known. Independent
  /// points need none.
  std::uint32_t replicates = 16;
  std::uint32_t seed = 0;
  std::uint32_t stream = 0;  ///< other streams of the same seed are independent
};

/// A mean with its standard error, and the variance of the values it is the mean of.
struct Estimate : MeanEstimate {
  double variance = 0.0;  ///< of one value, unbiased for independent points; 0 for fewer than two values
};

struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  bool contains(double x) const { return low <= x && x <= high; }
};

/// Holds the expected value with probability `confidence`, in (0, 1): the mean and Student's t times the standard error
/// to both sides. Unbounded where the error is not known. For means that are nearly normal
/// (`core/statistics/standard_error.h`).
Interval confidenceInterval(const MeanEstimate& estimate, double confidence = 0.95);

/// 1, 2, 4, ... and at last `samples` itself, which is at least 1.
std::vector<std::uint32_t> doublingSchedule(std::uint32_t samples);

namespace detail {

/// Throws Error (Usage) unless there is at least one sample and one replicate.
void checkSettings(const EstimateSettings& settings);

/// Collects the values of an estimate in the order of their samples.
class EstimateSums {
 public:
  explicit EstimateSums(const EstimateSettings& settings) : independent_(settings.sampler == SamplerType::Independent) {
    sums_.resize(settings.replicates);
    counts_.resize(settings.replicates);
  }
  void add(double value) {
    all_.add(value);
    sums_[group_] += value;
    ++counts_[group_];
    if (++group_ == sums_.size()) group_ = 0;
  }
  Estimate result() const;

 private:
  bool independent_;
  RunningMean all_;
  std::vector<double> sums_;
  std::vector<std::uint32_t> counts_;
  std::size_t group_ = 0;
};

}  // namespace detail

/// Estimates after each number of samples of `schedule` (ascending; none above settings.samples; those below 1 are
/// skipped), of one run: how it converges. Stratified points are in random order, so only whole sets are better than
/// independent ones. Throws Error (Usage) for settings without samples or replicates.
template <class Function>
std::vector<Estimate> runningEstimates(Function&& f, const EstimateSettings& settings,
                                       std::span<const std::uint32_t> schedule) {
  detail::checkSettings(settings);
  const SamplerSettings points{settings.sampler, settings.seed, settings.samples, settings.replicates};
  detail::EstimateSums sums(settings);
  std::vector<Estimate> results;
  results.reserve(schedule.size());
  std::uint32_t drawn = 0;
  for (const std::uint32_t count : schedule) {
    for (const std::uint32_t end = std::min(count, settings.samples); drawn < end; ++drawn)
      sums.add(f(Sampler<float>(points, settings.stream, drawn)));
    if (drawn > 0) results.push_back(sums.result());
  }
  return results;
}

/// The mean of f over settings.samples points. A value that is NaN makes the mean NaN. Throws Error (Usage) for
/// settings without samples or replicates.
template <class Function>
Estimate estimate(Function&& f, const EstimateSettings& settings = {}) {
  return runningEstimates(f, settings, std::span(&settings.samples, 1)).back();
}

}  // namespace steradian
