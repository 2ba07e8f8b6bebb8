#include "steradian/apps/montecarlo/programme.h"

#include <array>
#include <cmath>

namespace steradian::montecarlo {

namespace {

/// Powers of four, so that a stratified set is a whole grid.
std::vector<std::uint32_t> gridSizes() { return {16, 64, 256, 1024, 4096, 16384}; }

}  // namespace

double BookFigure::deviation(double exact) const {
  const double distance = std::abs(printed - exact) - 0.5 * lastDigit;
  return distance <= 0.0 ? 0.0 : std::copysign(distance / standardError, printed - exact);
}

bool BookFigure::outside(double exact) const { return std::abs(deviation(exact)) > 1.96; }

double uniform(const Sampler<float>& point, double low, double high) {
  return low + (high - low) * centred(point.get1D(0u));
}

Result resultOf(const Integral& integral, const RunSettings& settings) {
  Result result{.exact = integral.exact, .closedForm = integral.closedForm, .book = integral.book};
  result.estimate =
      estimate(integral.integrand, {.sampler = settings.sampler, .samples = settings.samples, .seed = settings.seed});
  result.interval = confidenceInterval(result.estimate);
  result.exactVariance = integral.variance;
  return result;
}

std::vector<Series> seriesOf(const Integral& integral, std::uint32_t seed) {
  std::vector<Series> series;
  for (const SamplerType type : {SamplerType::Independent, SamplerType::Stratified, SamplerType::Sobol}) {
    const auto run = [integrand = integral.integrand, type, seed](std::uint32_t samples, std::uint32_t stream) {
      return estimate(integrand, {.sampler = type, .samples = samples, .replicates = 1, .seed = seed, .stream = stream})
          .mean;
    };
    series.push_back({std::string(nameOf(type)), gridSizes(), run, integral.exact});
  }
  return series;
}

Programme programmeOf(std::string name, std::string section, std::string summary, Integral integral,
                      std::vector<std::string> notes) {
  Programme programme{std::move(name), std::move(section), std::move(summary), std::move(notes)};
  // A density that follows the integrand exactly has no error to plot.
  if (!integral.variance || *integral.variance > 0.0)
    programme.series = [integral](std::uint32_t seed) { return seriesOf(integral, seed); };
  programme.run = [integral = std::move(integral)](const RunSettings& settings) {
    return std::vector<Result>{resultOf(integral, settings)};
  };
  return programme;
}

Estimate withSpreadOf(double whole, const std::vector<double>& parts, std::uint64_t samples) {
  const std::vector<std::uint32_t> counts(parts.size(), 1);
  Estimate result;
  static_cast<MeanEstimate&>(result) = meanFromGroups(parts, counts);
  result.mean = whole;
  result.count = samples;
  // The variance of one sample if the estimate were a mean of independent ones.
  result.variance = result.standardError * result.standardError * static_cast<double>(samples);
  return result;
}

}  // namespace steradian::montecarlo
