#include "steradian/tests/integrators/estimate.h"

#include <cmath>

#include "steradian/tests/support/statistics.h"

namespace steradian::test {

Estimate meanOf(const Film& film) {
  const Crop& crop = film.crop();
  double sum = 0.0, variance = 0.0, pixels = 0.0;
  for (int y = crop.y0; y < crop.y1; ++y) {
    for (int x = crop.x0; x < crop.x1; ++x) {
      const MeanEstimate pixel = film.luminanceEstimate(x, y);
      sum += pixel.mean;
      variance += pixel.standardError * pixel.standardError;
      pixels += 1.0;
    }
  }
  return {sum / pixels, std::sqrt(variance) / pixels};
}

Estimate meanOf(const Scene& scene, const Integrator& integrator, int size, std::uint32_t samplesPerPixel,
                std::uint32_t seed) {
  RenderSettings settings;
  settings.width = size;
  settings.height = size;
  settings.samplesPerPixel = samplesPerPixel;
  settings.seed = seed;
  settings.replicates = 8;
  return meanOf(render(scene, integrator, settings).film);
}

testing::AssertionResult agree(const Estimate& a, const Estimate& b) {
  const double error = std::hypot(a.standardError, b.standardError);
  const double p = zTestPValue(a.mean, error, b.mean, 1e-4 * std::abs(b.mean));
  if (p >= suiteLevel()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << a.mean << " +- " << a.standardError << " against " << b.mean << " +- "
                                     << b.standardError << ": " << (a.mean - b.mean) / error << " standard errors";
}

testing::AssertionResult agree(const Estimate& a, double expected) { return agree(a, Estimate{expected, 0.0}); }

}  // namespace steradian::test
