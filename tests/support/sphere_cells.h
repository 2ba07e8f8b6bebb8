#pragma once
/// The cells of a SphereGrid: rings in 1 - cos(theta) about the axis, cut into sectors of phi. Solid angle is the
/// product of both, and each function of this class is in double.
#include <array>
#include <functional>
#include <vector>

#include "steradian/tests/support/statistics.h"

namespace steradian::test {

class SphereCells {
 public:
  explicit SphereCells(const SphereGrid& grid);

  std::size_t size() const { return (edges_.size() - 1) * static_cast<std::size_t>(sectors_); }
  std::size_t cellOf(Vec3f direction) const;
  /// The direction with 1 - cos(theta) = h and azimuth phi about the axis.
  Vec3f direction(double h, double phi) const;
  std::vector<double> integrate(const std::function<double(Vec3f)>& density, double tolerance) const;

 private:
  std::array<double, 3> x_, y_, z_;
  int sectors_;
  std::vector<double> edges_;
};

}  // namespace steradian::test
