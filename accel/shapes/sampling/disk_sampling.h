#pragma once
/// Sampling of disks by area, from either side.
#include "steradian/accel/shapes/primitives/disk.h"
#include "steradian/accel/shapes/sampling/direction_sample.h"
#include "steradian/core/math/frame.h"
#include "steradian/core/sampling/warp.h"

namespace STERADIAN_API steradian {

/// Surface, m^2 (one side).
template <class F>
F area(const Disk<F>& disk) {
  return F(kPi) * disk.radius * disk.radius;
}
/// Uniform by area; pdf per m^2.
template <class F>
PositionSample<F> samplePosition(const Disk<F>& disk, Vec2<F> u) {
  const Frame<F> axes = Frame<F>::fromZ(disk.normal);
  const Vec2<F> p = UniformDisk<F>::sample(u);
  return {disk.center + (axes.x * p.x + axes.y * p.y) * disk.radius, disk.normal, F(1.0f) / area(disk)};
}
/// The density of samplePosition, per m^2.
template <class F>
F pdfPosition(const Disk<F>& disk) {
  return F(1.0f) / area(disk);
}

/// The unit outward normal at a point of the surface.
template <class F>
Vec3<F> normalAt(const Disk<F>& disk, Vec3<F>) {
  return disk.normal;
}

/// A direction from `from` to a point of the disk that is uniform by area. A point in the disk's plane gets no sample.
template <class F>
DirectionSample<F> sampleDirection(const Disk<F>& disk, Vec3<F> from, Vec2<F> u) {
  const Frame<F> axes = Frame<F>::fromZ(disk.normal);
  const Vec3<F> center = axes.toLocal(disk.center - from);
  const Vec2<F> p = UniformDisk<F>::sample(u);
  const Vec3<F> local{center.x + disk.radius * p.x, center.y + disk.radius * p.y, center.z};
  const F distance = length(local);
  const F pdf = densityPerSteradian(pdfPosition(disk), distance, absolute(center.z));
  return sampleIf(center.z != F(0.0f), axes.toWorld(local * (F(1.0f) / distance)), pdf, distance);
}

/// The density of sampleDirection: 0 where the line misses the disk.
template <class F>
F pdfDirection(const Disk<F>& disk, Vec3<F> from, Vec3<F> wi) {
  const ShapeHit<F> hit = intersect(disk, Ray<F>{from, wi});
  const F height = absDot(disk.center - from, disk.normal);
  return densityIf(hit.valid, densityPerSteradian(pdfPosition(disk), hit.t, height));
}

/// Inverse of sampleDirection: the random numbers that give wi; meaningless where the line misses the disk.
template <class F>
Vec2<F> invertDirection(const Disk<F>& disk, Vec3<F> from, Vec3<F> wi) {
  const Frame<F> axes = Frame<F>::fromZ(disk.normal);
  const Vec3<F> center = axes.toLocal(disk.center - from), local = axes.toLocal(wi);
  const F t = center.z / local.z, scale = F(1.0f) / disk.radius;
  return UniformDisk<F>::invert({(t * local.x - center.x) * scale, (t * local.y - center.y) * scale});
}

}  // namespace steradian
