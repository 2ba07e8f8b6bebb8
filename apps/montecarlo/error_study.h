#pragma once
/// The error of an estimate as a function of the number of samples.
#include "steradian/apps/montecarlo/programme.h"

namespace steradian::montecarlo {

struct ErrorPoint {
  double samples = 0.0;
  double error = 0.0;  ///< root of the mean squared error over independent runs
};

struct ErrorCurve {
  std::string name;
  std::vector<ErrorPoint> points;  ///< without those whose error is 0
  double slope = 0.0;              ///< of ln(error) over ln(samples), by least squares; 0 for fewer than two points
  double offset = 0.0;             ///< ln(error) of the fitted line at ln(samples) = 0

  double fitted(double samples) const;
};

/// Fits slope and offset to the points.
ErrorCurve fitted(std::string name, std::vector<ErrorPoint> points);

/// 64 independent runs of each size.
ErrorCurve errorCurve(const Series& series);

}  // namespace steradian::montecarlo
