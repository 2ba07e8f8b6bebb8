/// "A Simple Monte Carlo Program".
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "steradian/apps/montecarlo/jittered_circle.h"
#include "steradian/apps/montecarlo/programmes.h"
#include "steradian/core/statistics/quadrature.h"

namespace steradian::montecarlo {

namespace {

using std::numbers::pi;

/// The area of the square times 1 inside the circle and 0 outside.
double inCircle(const Sampler<float>& point) {
  const Vec2f u = point.get2D(0u);
  const double x = 2.0 * centred(u.x) - 1.0, y = 2.0 * centred(u.y) - 1.0;
  return x * x + y * y < 1.0 ? 4.0 : 0.0;
}

/// 4 with probability pi / 4.
double piVariance() { return pi * (4.0 - pi); }
double piError(double samples) { return std::sqrt(piVariance() / samples); }

Integral diskArea(std::vector<BookFigure> book) {
  const double exact = integrate([](double x) { return 2.0 * std::sqrt(1.0 - x * x); }, -1.0, 1.0);
  return {inCircle, exact, "pi", piVariance(), std::move(book)};
}

std::vector<Result> runRunning(const RunSettings& settings) {
  const auto schedule = doublingSchedule(settings.samples);
  const auto estimates = runningEstimates(
      inCircle, {.sampler = settings.sampler, .samples = settings.samples, .seed = settings.seed}, schedule);
  const Integral area = diskArea({});
  std::vector<Result> results;
  results.reserve(estimates.size());
  for (const Estimate& e : estimates)
    results.push_back({fmt::format("N = {}", e.count), e, confidenceInterval(e), area.exact, area.closedForm});
  return results;
}

std::vector<Result> runStratified(RunSettings settings) {
  const Integral regular = diskArea({{"4.0.2, section 2.3", 3.141184, 1e-6, 1e6, piError(1e6)},
                                     {"2018, chapter 1", 3.1415, 1e-5, 1e8, piError(1e8)}});
  Integral stratified = diskArea({{"4.0.2, section 2.3", 3.14146, 1e-6, 1e6, jitteredCircleError(1000)},
                                  {"2018, chapter 1", 3.14159, 1e-5, 1e8, jitteredCircleError(10000)}});
  stratified.variance.reset();  // it is the mean's variance that stratification lowers, not that of a sample
  std::vector<Result> results;
  settings.sampler = SamplerType::Independent;
  results.push_back(resultOf(regular, settings));
  results.back().label = "regular";
  settings.sampler = SamplerType::Stratified;
  results.push_back(resultOf(stratified, settings));
  results.back().label = "stratified";
  const double gain = results[0].estimate.standardError / results[1].estimate.standardError;
  results.back().remark = fmt::format("16 grids; error 1/{:.0f} of the regular one", gain);
  return results;
}

/// A needle as long as the boards are wide (1): its middle is at most 1/2 from the nearest joint, and it crosses if
/// that is less than half of its extent across the boards. (Sampling its angle needs pi itself.)
double needle(const Sampler<float>& point) {
  const Vec2f u = point.get2D(0u);
  const double distance = 0.5 * centred(u.x), angle = 0.5 * pi * centred(u.y);
  return distance <= 0.5 * std::sin(angle) ? 1.0 : 0.0;
}

Integral crossing() {
  const double p = integrate([](double angle) { return std::sin(angle); }, 0.0, 0.5 * pi) / (0.5 * pi);
  return {needle, p, "2 / pi", p * (1.0 - p)};
}

std::vector<Result> runBuffon(const RunSettings& settings) {
  Result crossings = resultOf(crossing(), settings);
  crossings.label = "share that crosses";
  // 2 / share is monotonic, so the interval of the share is mapped to that of pi.
  const double share = crossings.estimate.mean;
  Result inverse{.label = "pi = 2 / share", .exact = 2.0 / crossings.exact, .closedForm = "pi"};
  inverse.estimate = crossings.estimate;
  inverse.estimate.mean = 2.0 / share;
  inverse.estimate.standardError = 2.0 / (share * share) * crossings.estimate.standardError;
  inverse.estimate.variance = 4.0 / std::pow(share, 4) * crossings.estimate.variance;
  inverse.interval = {2.0 / crossings.interval.high, 2.0 / crossings.interval.low};
  return {crossings, inverse};
}

}  // namespace

std::vector<Programme> piProgrammes() {
  std::vector<Programme> list;
  list.push_back(
      programmeOf("pi", "4.0.2, section 2.1; 2018, chapter 1", "pi by rejection: points inside the unit circle",
                  diskArea({{"4.0.2, section 2.1", 3.14376, 1e-6, 1e5, piError(1e5)},
                            {"2018, chapter 1", 3.196, 1e-5, 1000, piError(1000)}}),
                  {"2018 does not say how many samples gave 3.196: 799 of 1000 inside are the fewest that do"}));
  list.push_back({"pi-running",
                  "4.0.2, section 2.2",
                  "pi by rejection, as the samples come",
                  {"each digit more takes a hundred times as many samples"},
                  runRunning});
  list.push_back({"pi-stratified",
                  "4.0.2, section 2.3; 2018, chapter 1",
                  "pi by rejection, one point in each cell of a grid",
                  {"only cells that the circle crosses are uncertain: the error falls as N^-3/4, not N^-1/2"},
                  runStratified});
  list.push_back({"buffon",
                  "4.0.2, section 2.1",
                  "Buffon's needle: the share of needles that cross a joint of the boards",
                  {},
                  runBuffon,
                  [](std::uint32_t seed) { return seriesOf(crossing(), seed); }});
  return list;
}

}  // namespace steradian::montecarlo
