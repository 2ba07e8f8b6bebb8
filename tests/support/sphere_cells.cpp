#include "steradian/tests/support/sphere_cells.h"

#include <algorithm>
#include <cmath>

namespace steradian::test {

SphereCells::SphereCells(const SphereGrid& grid) : sectors_(grid.sectors) {
  // In double, so that small angles around the axis keep their digits.
  const double n = std::hypot(static_cast<double>(grid.axis.x), grid.axis.y, grid.axis.z);
  z_ = {grid.axis.x / n, grid.axis.y / n, grid.axis.z / n};
  const std::array<double, 3> helper = std::abs(z_[0]) < 0.6 ? std::array{1.0, 0.0, 0.0} : std::array{0.0, 1.0, 0.0};
  const auto cross = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::array{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  x_ = cross(helper, z_);
  const double length = std::hypot(x_[0], x_[1], x_[2]);
  for (double& c : x_) c /= length;
  y_ = cross(z_, x_);
  const double s = std::sin(0.5 * std::min(grid.focus, 1.57079632679489662));
  const double split = 2.0 * s * s;  // 1 - cos(focus)
  const int inner = grid.rings / 2;
  for (int i = 0; i <= grid.rings; ++i) {
    const double outer = static_cast<double>(i - inner) / (grid.rings - inner);
    // Around a narrow peak rings of equal ratio follow its tail.
    const double beyond = grid.focus < 0.1 ? split * std::pow(2.0 / split, outer) : split + (2.0 - split) * outer;
    edges_.push_back(i <= inner ? split * i / inner : beyond);
  }
  edges_.back() = 2.0;
}

std::size_t SphereCells::cellOf(Vec3f w) const {
  const double px = x_[0] * w.x + x_[1] * w.y + x_[2] * w.z;
  const double py = y_[0] * w.x + y_[1] * w.y + y_[2] * w.z;
  const double pz = z_[0] * w.x + z_[1] * w.y + z_[2] * w.z;
  const double h = pz > 0.0 ? (px * px + py * py) / (1.0 + pz) : 1.0 - pz;
  const double turn = std::atan2(py, px) / 6.28318530717958648;
  const auto above = std::upper_bound(edges_.begin() + 1, edges_.end() - 1, h);
  const auto ring = static_cast<std::size_t>(above - edges_.begin() - 1);
  const int sector = std::min(static_cast<int>((turn < 0.0 ? turn + 1.0 : turn) * sectors_), sectors_ - 1);
  return ring * static_cast<std::size_t>(sectors_) + static_cast<std::size_t>(sector);
}

Vec3f SphereCells::direction(double h, double phi) const {
  const double s = std::sqrt(std::max(0.0, h * (2.0 - h)));
  const double a = s * std::cos(phi), b = s * std::sin(phi), c = 1.0 - h;
  const auto component = [&](std::size_t i) { return static_cast<float>(x_[i] * a + y_[i] * b + z_[i] * c); };
  return {component(0), component(1), component(2)};
}

std::vector<double> SphereCells::integrate(const std::function<double(Vec3f)>& density, double tolerance) const {
  const double width = 6.28318530717958648 / sectors_;
  std::vector<double> cells;
  for (std::size_t ring = 0; ring + 1 < edges_.size(); ++ring) {
    for (int sector = 0; sector < sectors_; ++sector) {
      const Rectangle cell{edges_[ring], edges_[ring + 1], sector * width, (sector + 1) * width};
      cells.push_back(
          test::integrate([&](double h, double phi) { return density(direction(h, phi)); }, cell, tolerance));
    }
  }
  return cells;
}

std::vector<double> integrateCells(const std::function<double(Vec3f)>& density, const SphereGrid& grid,
                                   double tolerance) {
  return SphereCells(grid).integrate(density, tolerance);
}

double integrateSphere(const std::function<double(Vec3f)>& density, const SphereGrid& grid, double tolerance) {
  double sum = 0.0;
  for (const double cell : integrateCells(density, grid, tolerance)) sum += cell;
  return sum;
}

double integrateHemisphere(const std::function<double(Vec3f)>& density, Vec3f axis, double tolerance) {
  SphereGrid grid;
  grid.axis = axis;
  // With the default focus the first half of the rings is the hemisphere.
  const std::vector<double> cells = integrateCells(density, grid, tolerance);
  double sum = 0.0;
  for (std::size_t i = 0; i < cells.size() / 2; ++i) sum += cells[i];
  return sum;
}

}  // namespace steradian::test
