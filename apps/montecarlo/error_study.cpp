#include "steradian/apps/montecarlo/error_study.h"

#include <cmath>

namespace steradian::montecarlo {

double ErrorCurve::fitted(double samples) const { return std::exp(offset + slope * std::log(samples)); }

ErrorCurve fitted(std::string name, std::vector<ErrorPoint> points) {
  std::erase_if(points, [](const ErrorPoint& p) { return !(p.error > 0.0); });
  ErrorCurve curve{std::move(name), std::move(points)};
  const auto count = static_cast<double>(curve.points.size());
  double meanX = 0.0, meanY = 0.0, xx = 0.0, xy = 0.0;
  for (const ErrorPoint& p : curve.points) {
    meanX += std::log(p.samples) / count;
    meanY += std::log(p.error) / count;
  }
  for (const ErrorPoint& p : curve.points) {
    const double x = std::log(p.samples) - meanX;
    xx += x * x;
    xy += x * (std::log(p.error) - meanY);
  }
  if (xx > 0.0) curve.slope = xy / xx;
  curve.offset = meanY - curve.slope * meanX;
  return curve;
}

ErrorCurve errorCurve(const Series& series) {
  constexpr std::uint32_t runs = 64;
  std::vector<ErrorPoint> points;
  for (const std::uint32_t size : series.sizes) {
    double squares = 0.0;
    for (std::uint32_t run = 0; run < runs; ++run) {
      const double error = series.estimate(size, run) - series.exact;
      squares += error * error;
    }
    points.push_back({static_cast<double>(size), std::sqrt(squares / runs)});
  }
  return fitted(series.name, std::move(points));
}

}  // namespace steradian::montecarlo
