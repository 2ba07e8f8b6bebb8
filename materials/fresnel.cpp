#include "steradian/materials/fresnel.h"

#include <cmath>

namespace steradian {

double diffuseTransmittance(double eta) {
  // From the denser side the integrand has a square-root edge at the critical angle: integrate from the other.
  if (eta < 1.0) return eta * eta * diffuseTransmittance(1.0 / eta);
  constexpr int steps = 2048;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double c = (i + 0.5) / steps;
    const double t = std::sqrt(1.0 - (1.0 - c * c) / (eta * eta));
    const double parallel = (eta * c - t) / (eta * c + t), perpendicular = (c - eta * t) / (c + eta * t);
    sum += (1.0 - 0.5 * (parallel * parallel + perpendicular * perpendicular)) * 2.0 * c;
  }
  return sum / steps;
}

}  // namespace steradian
