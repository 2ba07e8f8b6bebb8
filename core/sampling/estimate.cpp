#include "steradian/core/sampling/estimate.h"

#include "steradian/core/base/diagnostics.h"
#include "steradian/core/statistics/student_t.h"

namespace steradian {

Interval confidenceInterval(const MeanEstimate& estimate, double confidence) {
  if (estimate.degreesOfFreedom < 1 || !std::isfinite(estimate.standardError)) return {};
  const double reach = studentTwoSidedQuantile(1.0 - confidence, estimate.degreesOfFreedom) * estimate.standardError;
  return {estimate.mean - reach, estimate.mean + reach};
}

std::vector<std::uint32_t> doublingSchedule(std::uint32_t samples) {
  std::vector<std::uint32_t> schedule;
  for (std::uint64_t n = 1; n < samples; n *= 2) schedule.push_back(static_cast<std::uint32_t>(n));
  schedule.push_back(samples);
  return schedule;
}

namespace detail {

void checkSettings(const EstimateSettings& settings) {
  if (settings.samples == 0) throw Error(ErrorKind::Usage, "an estimate needs at least one sample");
  if (settings.replicates == 0) throw Error(ErrorKind::Usage, "an estimate needs at least one replicate");
}

Estimate EstimateSums::result() const {
  Estimate result;
  if (independent_) {
    result.mean = all_.mean();
    result.count = static_cast<std::uint64_t>(all_.count());
    if (all_.count() > 1) {
      result.standardError = all_.standardError();
      result.degreesOfFreedom =
          static_cast<int>(std::min<std::int64_t>(all_.count() - 1, std::numeric_limits<int>::max()));
    }
  } else {
    static_cast<MeanEstimate&>(result) = meanFromGroups(sums_, counts_);
  }
  result.variance = all_.variance();
  return result;
}

}  // namespace detail

}  // namespace steradian
