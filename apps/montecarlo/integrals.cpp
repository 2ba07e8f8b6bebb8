/// "One Dimensional Monte Carlo Integration": areas under curves by points that are uniform in [0, 2].
#include <cmath>

#include "steradian/apps/montecarlo/programmes.h"
#include "steradian/core/statistics/quadrature.h"

namespace steradian::montecarlo {

namespace {

constexpr double kLow = 0.0, kHigh = 2.0;

Integral areaUnder(double (*curve)(double), std::string closedForm) {
  const auto value = [curve](double x) { return (kHigh - kLow) * curve(x); };
  const double exact = integrate(curve, kLow, kHigh);
  const double square = integrate([&](double x) { return value(x) * value(x); }, kLow, kHigh) / (kHigh - kLow);
  return {[value](const Sampler<float>& point) { return value(uniform(point, kLow, kHigh)); }, exact,
          std::move(closedForm), square - exact * exact};
}

double square(double x) { return x * x; }
double fifthPowerOfSine(double x) { return std::pow(std::sin(x), 5.0); }
double logarithmOfSine(double x) { return std::log(std::sin(x)); }

}  // namespace

std::vector<Programme> integralProgrammes() {
  return {programmeOf("x-squared", "4.0.2, section 3.2; 2018, chapter 2", "the area under x^2 over [0, 2]",
                      areaUnder(square, "8 / 3")),
          programmeOf("sin-fifth", "4.0.2, section 3.2", "the area under sin^5 x over [0, 2]",
                      areaUnder(fifthPowerOfSine, "8/15 - cos 2 + 2/3 cos^3 2 - 1/5 cos^5 2")),
          programmeOf("log-sin", "4.0.2, section 3.2; 2018, chapter 2", "the area under ln(sin x) over [0, 2]",
                      areaUnder(logarithmOfSine, ""),
                      {"no elementary integral, but -2 ln 2 - Cl2(4) / 2 with Clausen's function Cl2",
                       "infinite at 0, where it is integrable: few points lie there, and the variance is finite"})};
}

}  // namespace steradian::montecarlo
