/// "Importance Sampling": x^2 over [0, 2] by densities that follow it more and more closely.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "steradian/apps/montecarlo/piecewise.h"
#include "steradian/apps/montecarlo/programmes.h"
#include "steradian/core/statistics/quadrature.h"

namespace steradian::montecarlo {

namespace {

double curve(double x) { return x * x; }

/// The mean of x^2 / p(x) for x = icd(d), where d is uniform.
Integral areaBy(std::function<double(double)> icd, std::function<double(double)> pdf) {
  const double exact = integrate(curve, 0.0, 2.0);
  const double square = integrate(
      [&](double d) {
        const double x = icd(d);
        return std::pow(curve(x) / pdf(x), 2);
      },
      0.0, 1.0, 1e-13);
  // Values within the error of the quadrature count as 0.
  const double variance = square - exact * exact;
  const auto value = [icd = std::move(icd), pdf = std::move(pdf)](const Sampler<float>& point) {
    const double x = icd(centred(point.get1D(0u)));
    return curve(x) / pdf(x);
  };
  return {value, exact, "8 / 3", variance < 1e-9 ? 0.0 : variance};
}

Integral areaBy(const Piecewise& density) {
  return areaBy([density](double d) { return density.sample(d); }, [density](double x) { return density.pdf(x); });
}

/// The halves of halves of ... p(r) = r / 2: P(r) = r^2 / 4, so the k-th of 2^depth edges is 2 sqrt(k / 2^depth).
Piecewise partition(int depth) {
  const int parts = 1 << depth;
  std::vector<double> edges;
  for (int k = 0; k <= parts; ++k) edges.push_back(2.0 * std::sqrt(static_cast<double>(k) / parts));
  return Piecewise(std::move(edges));
}

std::vector<Result> runPartitions(const RunSettings& settings) {
  std::vector<Result> results;
  for (const int depth : {0, 1, 2, 3, 4, 6, 8, 10}) {
    results.push_back(resultOf(areaBy(partition(depth)), settings));
    results.back().label = fmt::format("depth {}", depth);
  }
  return results;
}

}  // namespace

std::vector<Programme> importanceProgrammes() {
  const std::string section = "4.0.2, section 3.7; 2018, chapter 2";
  std::vector<Programme> list;
  list.push_back(programmeOf("x-squared-uniform", section, "x^2 over [0, 2] by the uniform density 1/2",
                             areaBy([](double d) { return 2.0 * d; }, [](double) { return 0.5; })));
  list.push_back(
      programmeOf("x-squared-two-piece", "4.0.2, sections 3.5 and 3.7",
                  "x^2 over [0, 2] by halves of x/2: uniform in [0, sqrt 2] or in [sqrt 2, 2]", areaBy(partition(1)),
                  {"the book draws a second number within the half; the rest of the first one serves as well"}));
  list.push_back(programmeOf("x-squared-linear", section, "x^2 over [0, 2] by the density x/2",
                             areaBy([](double d) { return std::sqrt(4.0 * d); }, [](double x) { return 0.5 * x; }),
                             {"2018 calls x^2 / 4 the density once: it is the cumulative one"}));
  list.push_back(programmeOf(
      "x-squared-exact", section, "x^2 over [0, 2] by the density 3/8 x^2, which is always right",
      areaBy([](double d) { return 2.0 * std::cbrt(d); }, [](double x) { return 0.375 * x * x; }),
      {"erratum: listing 15 of 4.0.2 inverts P(x) = x^3 / 8 to 8 d^(1/3); it is (8 d)^(1/3) = 2 d^(1/3), as in 2018. "
       "Of its points 98 % lie beyond 2; it prints 8/3 all the same, for x^2 / p is 8/3 everywhere, but the integral "
       "of x "
       "would come out as 1/2 in place of 2"}));
  list.push_back({"partitions",
                  "4.0.2, section 3.5",
                  "x^2 over [0, 2] by halves of halves of x/2",
                  {"from the uniform density (depth 0) to the linear one, whose variance is 8/9: the book's depth of 6 "
                   "to 10 is more than is needed"},
                  runPartitions});
  return list;
}

}  // namespace steradian::montecarlo
