/// "Unfortunately, this advantage decreases with the dimension of the problem": the gain by stratification for the ball
/// in 2 to 5 dimensions.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "steradian/apps/montecarlo/programmes.h"
#include "steradian/core/statistics/quadrature.h"

namespace steradian::montecarlo {

namespace {

constexpr std::uint32_t kReplicates = 64;

/// The share of the cube [-1, 1]^d that the unit ball fills: 2^-d times the volume V_d = V_(d-1) times the integral of
/// (1 - x^2)^((d-1)/2), over slices.
double ballShare(int dimensions) {
  double share = 1.0;
  for (int d = 1; d <= dimensions; ++d)
    share *= 0.5 * integrate([&](double x) { return std::pow(1.0 - x * x, 0.5 * (d - 1)); }, -1.0, 1.0);
  return share;
}

/// The share of jittered points inside the ball: one in each of side^d cells.
double jittered(int dimensions, std::uint32_t side, std::uint32_t stream, std::uint32_t seed) {
  std::uint64_t cells = 1, inside = 0;
  for (int d = 0; d < dimensions; ++d) cells *= side;
  const SamplerSettings jitter{SamplerType::Independent, seed};
  for (std::uint64_t cell = 0; cell < cells; ++cell) {
    const Sampler<float> point(jitter, stream, static_cast<std::uint32_t>(cell));
    double square = 0.0;
    std::uint64_t rest = cell;
    for (std::uint32_t d = 0; d < static_cast<std::uint32_t>(dimensions); ++d) {
      const double x = 2.0 * (static_cast<double>(rest % side) + centred(point.get1D(d))) / side - 1.0;
      square += x * x;
      rest /= side;
    }
    inside += square < 1.0 ? 1 : 0;
  }
  return static_cast<double>(inside) / static_cast<double>(cells);
}

/// The largest side with side^dimensions <= samples, at least 2.
std::uint32_t sideOf(std::uint32_t samples, int dimensions) {
  std::uint32_t side = 2;
  while (std::pow(side + 1.0, dimensions) <= samples) ++side;
  return side;
}

std::vector<Result> runBalls(const RunSettings& settings) {
  static constexpr std::array<const char*, 4> forms{"pi / 4", "pi / 6", "pi^2 / 32", "pi^2 / 60"};
  std::vector<Result> results;
  for (int d = 2; d <= 5; ++d) {
    const std::uint32_t side = sideOf(settings.samples / kReplicates, d);
    const double cells = std::pow(side, d), share = ballShare(d);
    std::vector<double> grids(kReplicates);
    double sum = 0.0;
    for (std::uint32_t r = 0; r < kReplicates; ++r) sum += grids[r] = jittered(d, side, r, settings.seed);
    Result result{
        .label = fmt::format("{} dimensions", d), .exact = share, .closedForm = forms[static_cast<std::size_t>(d - 2)]};
    result.estimate = withSpreadOf(sum / kReplicates, grids, static_cast<std::uint64_t>(kReplicates * cells));
    result.interval = confidenceInterval(result.estimate);
    const double gain = share * (1.0 - share) / result.estimate.variance;
    result.remark =
        fmt::format("{} grids of {}^{} cells; variance 1/{:.1f} of independent points", kReplicates, side, d, gain);
    results.push_back(std::move(result));
  }
  return results;
}

std::vector<Series> ballSeries(std::uint32_t seed) {
  std::vector<Series> series;
  for (int d = 2; d <= 5; ++d) {
    std::vector<std::uint32_t> sizes;
    for (const double size : {32.0, 128.0, 512.0, 2048.0, 8192.0, 32768.0})
      sizes.push_back(static_cast<std::uint32_t>(std::pow(std::round(std::pow(size, 1.0 / d)), d)));
    const auto run = [d, seed](std::uint32_t samples, std::uint32_t stream) {
      return jittered(d, sideOf(samples, d), stream, seed);
    };
    series.push_back({fmt::format("jittered, {}D", d), sizes, run, ballShare(d)});
  }
  const auto independent = [seed](std::uint32_t samples, std::uint32_t stream) {
    const auto inside = [](const Sampler<float>& point) {
      const double x = uniform(point, -1.0, 1.0), y = 2.0 * centred(point.get1D(1u)) - 1.0;
      return x * x + y * y < 1.0 ? 1.0 : 0.0;
    };
    return estimate(inside, {.samples = samples, .seed = seed, .stream = stream}).mean;
  };
  series.push_back({"independent, 2D", {32, 128, 512, 2048, 8192, 32768}, independent, ballShare(2)});
  return series;
}

}  // namespace

std::vector<Programme> stratificationProgrammes() {
  return {{"balls",
           "4.0.2, section 2.3",
           "how the gain of stratification shrinks: the share of a cube that its ball fills",
           {"theory: the error falls as N^-(1/2 + 1/2d) in d dimensions, so the gain in variance grows as N^1/d only"},
           runBalls,
           ballSeries}};
}

}  // namespace steradian::montecarlo
