/// The function that the books do not integrate analytically, exp(-x / 2 pi) sin^2 x over [0, 2 pi]: the point that
/// halves its area, a density made of such points, and a random walk that needs only the function.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "steradian/apps/montecarlo/piecewise.h"
#include "steradian/apps/montecarlo/programmes.h"
#include "steradian/core/statistics/quadrature.h"

namespace steradian::montecarlo {

namespace {

constexpr double kEnd = 2.0 * std::numbers::pi;

double curve(double x) { return std::exp(-x / kEnd) * std::sin(x) * std::sin(x); }

double area(double low, double high) { return integrate(curve, low, high); }

double exactHalfway() {
  const double half = 0.5 * area(0.0, kEnd);
  double low = 0.0, high = kEnd;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (area(0.0, middle) < half ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

struct WeightedPoint {
  double x, weight;
};

/// The points at which the weights, added up in the order of x, reach 1/parts, 2/parts, ... of their sum.
std::vector<double> splits(std::vector<WeightedPoint> points, int parts) {
  std::ranges::sort(points, {}, &WeightedPoint::x);
  double total = 0.0, sum = 0.0;
  for (const WeightedPoint& p : points) total += p.weight;
  std::vector<double> found;
  for (const WeightedPoint& p : points) {
    sum += p.weight;
    while (static_cast<int>(found.size()) < parts - 1 && sum * parts >= total * static_cast<double>(found.size() + 1))
      found.push_back(p.x);
  }
  return found;
}

/// Listing 12: uniform points with the curve as weight, in `groups` independent sets of points.
std::vector<std::vector<WeightedPoint>> weighted(SamplerType type, std::uint32_t samples, std::uint32_t groups,
                                                 std::uint32_t seed, std::uint32_t stream) {
  std::vector<std::vector<WeightedPoint>> sets(groups);
  const SamplerSettings settings{type, seed, samples, groups};
  for (std::uint32_t i = 0; i < samples; ++i) {
    const double x = uniform(Sampler<float>(settings, stream, i), 0.0, kEnd);
    sets[i % groups].push_back({x, curve(x)});
  }
  return sets;
}

Integral areaByUniform() {
  const double exact = area(0.0, kEnd);
  const double square = kEnd * integrate([](double x) { return curve(x) * curve(x); }, 0.0, kEnd);
  return {[](const Sampler<float>& point) { return kEnd * curve(uniform(point, 0.0, kEnd)); }, exact,
          "2 pi (1 - 1/e) (1 - 1 / (1 + 16 pi^2)) / 2", square - exact * exact};
}

/// The halfway point of N uniform points: half of the weight's spread over the weight at the halfway point (the delta
/// method for a weighted median).
double halfwayError(double samples) {
  const double square = kEnd * integrate([](double x) { return curve(x) * curve(x); }, 0.0, kEnd);
  return 0.5 * std::sqrt(square / samples) / curve(exactHalfway());
}

std::vector<Result> runHalfway(const RunSettings& settings) {
  constexpr std::uint32_t groups = 32;
  Integral under = areaByUniform();
  under.book = {{"4.0.2, section 3.5", 1.977233943713, 1e-12, 1e4, std::sqrt(*under.variance / 1e4)}};
  Result areaResult = resultOf(under, settings);
  areaResult.label = "area";
  std::vector<double> halfways;
  std::vector<WeightedPoint> all;
  for (auto& set : weighted(settings.sampler, settings.samples, groups, settings.seed, 1)) {
    all.insert(all.end(), set.begin(), set.end());
    halfways.push_back(splits(std::move(set), 2).front());
  }
  Result result{.label = "halfway point", .exact = exactHalfway()};
  result.estimate = withSpreadOf(splits(std::move(all), 2).front(), halfways, settings.samples);
  result.interval = confidenceInterval(result.estimate);
  result.exactVariance = std::pow(halfwayError(1.0), 2);
  result.book = {{"4.0.2, section 3.5", 2.016002314977, 1e-12, 1e4, halfwayError(1e4)}};
  return {areaResult, result};
}

std::vector<Series> halfwaySeries(std::uint32_t seed) {
  std::vector<Series> series = seriesOf(areaByUniform(), seed);  // for their names and sizes
  for (std::size_t i = 0; i < series.size(); ++i) {
    const SamplerType type = *samplerTypeOf(series[i].name);
    series[i].exact = exactHalfway();
    series[i].estimate = [type, seed](std::uint32_t samples, std::uint32_t stream) {
      return splits(std::move(weighted(type, samples, 1, seed, stream).front()), 2).front();
    };
  }
  return series;
}

/// The density whose 2^depth parts are found by sorting uniform points, as the books split it again and again.
Piecewise partition(int depth, std::uint32_t seed) {
  constexpr std::uint32_t pilot = 1u << 16;
  std::vector<double> edges{0.0};
  for (const double x : splits(std::move(weighted(SamplerType::Independent, pilot, 1, seed, 2).front()), 1 << depth)) {
    if (x > edges.back()) edges.push_back(x);
  }
  edges.push_back(kEnd);
  return Piecewise(std::move(edges));
}

std::vector<Result> runPartition(const RunSettings& settings) {
  std::vector<Result> results;
  for (const int depth : {0, 1, 2, 4, 6, 8, 10}) {
    const Piecewise density = partition(depth, settings.seed);
    const auto value = [&density](const Sampler<float>& point) {
      const double x = density.sample(centred(point.get1D(0u)));
      return curve(x) / density.pdf(x);
    };
    results.push_back(resultOf({value, area(0.0, kEnd)}, settings));
    results.back().label = fmt::format("depth {}", depth);
  }
  return results;
}

/// A random walk whose stops follow the curve in the long run: a step, symmetric about 0 and periodic at the ends, is
/// accepted with probability min(1, curve at its end / curve here), or else the stop counts again (Metropolis et al.
/// 1953; with equal chances of either direction Hastings' factor is 1). It begins at a point of the curve's own
/// density, found by rejection, so that every stop has that density.
struct Walk {
  std::vector<WeightedPoint> stops;
  int taken = 0;
};
Walk metropolis(std::uint32_t steps, std::uint32_t stream, std::uint32_t seed) {
  constexpr double reach = 2.0;
  RandomStream random(stream, 0u, 0u, seed);
  const auto next = [&] { return centred(random.next()); };
  double x = kEnd * next();
  while (next() >= curve(x)) x = kEnd * next();
  Walk walk;
  walk.stops.reserve(steps);
  for (std::uint32_t i = 0; i < steps; ++i) {
    const double step = x + reach * (2.0 * next() - 1.0);
    const double y = step - kEnd * std::floor(step / kEnd);
    if (next() * curve(x) < curve(y)) {
      x = y;
      ++walk.taken;
    }
    walk.stops.push_back({x, 1.0});
  }
  return walk;
}

std::vector<Result> runMetropolis(const RunSettings& settings) {
  constexpr std::uint32_t walks = 64;
  const std::uint32_t steps = std::max(settings.samples / walks, 1u);
  std::vector<double> means, halfways;
  std::vector<WeightedPoint> all;
  double sum = 0.0, taken = 0.0;
  for (std::uint32_t w = 0; w < walks; ++w) {
    Walk walk = metropolis(steps, w, settings.seed);
    double own = 0.0;
    for (const WeightedPoint& stop : walk.stops) own += stop.x;
    sum += own;
    taken += walk.taken;
    means.push_back(own / steps);
    all.insert(all.end(), walk.stops.begin(), walk.stops.end());
    halfways.push_back(splits(std::move(walk.stops), 2).front());
  }
  const std::uint64_t count = std::uint64_t{walks} * steps;
  Result mean{.label = "mean of x"}, halfway{.label = "halfway point"};
  mean.exact = integrate([](double x) { return x * curve(x); }, 0.0, kEnd) / area(0.0, kEnd);
  mean.estimate = withSpreadOf(sum / static_cast<double>(count), means, count);
  mean.remark = fmt::format("{} walks, {:.0f} % of the steps taken", walks, 100.0 * taken / static_cast<double>(count));
  halfway.exact = exactHalfway();
  halfway.estimate = withSpreadOf(splits(std::move(all), 2).front(), halfways, count);
  for (Result* result : {&mean, &halfway}) result->interval = confidenceInterval(result->estimate);
  return {mean, halfway};
}

}  // namespace

std::vector<Programme> halfwayProgrammes() {
  const double low = area(0.0, 2.016), high = area(2.016, kEnd);
  std::vector<Programme> list;
  list.push_back(
      {"halfway",
       "4.0.2, section 3.5",
       "the point that halves the area under exp(-x / 2 pi) sin^2 x over [0, 2 pi]",
       {fmt::format("erratum: the areas before and after 2.016 are not \"almost exactly the same\" but {:.4f} and "
                    "{:.4f}: 2.016 is one noisy run",
                    low, high)},
       runHalfway,
       halfwaySeries});
  list.push_back({"halfway-partition",
                  "4.0.2, section 3.5",
                  "the same area by a density of halves of halves, found by sorting 65536 points",
                  {"beyond depth 8 or so the parts hold too few of those points to become better"},
                  runPartition});
  list.push_back({"metropolis",
                  "4.0.2, section 3.5",
                  "Metropolis-Hastings: a walk whose stops follow exp(-x / 2 pi) sin^2 x",
                  {"neighbouring stops are alike: the variance is that of several times fewer independent points"},
                  runMetropolis});
  return list;
}

}  // namespace steradian::montecarlo
