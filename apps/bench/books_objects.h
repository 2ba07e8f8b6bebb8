#pragma once
/// Shapes as in "Ray Tracing: The Next Week": double precision, one ray at a time, virtual calls. Written anew after
/// the book's text, as the renderer that Steradian is compared with; needless costs of the book's program (reference
/// counts per hit, rand()) are avoided.
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "steradian/core/math/vec.h"
#include "steradian/core/transport/spectrum.h"

namespace steradian::bench::books {

using Vec = Vec3<double>;
using Colour = Spectrum<double>;

inline constexpr double kFar = std::numeric_limits<double>::infinity();

double lengthOf(Vec v);
Vec unit(Vec v);
Vec inDoubles(Vec3f v);
Colour inDoubles(Rgb c);

/// Numbers in [0, 1): splitmix64 (Steele, Lea & Flood 2014, "Fast splittable pseudorandom number generators").
class Random {
 public:
  Random(std::uint32_t seed, std::uint32_t stream);
  double next() { return static_cast<double>(word() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * next(); }
  /// By rejection from the cube, as the book does.
  Vec onSphere();
  /// By rejection from the square; z is 0.
  Vec inDisk();

 private:
  std::uint64_t word();

  std::uint64_t state_;
};

struct Ray {
  Vec origin, direction;  ///< of any length
  double time = 0.0;      ///< of the shutter, in [0, 1)

  Vec at(double t) const { return origin + direction * t; }
};

struct Interval {
  double min = -kFar, max = kFar;
};

class Material;

struct Hit {
  Vec position, normal;  ///< the normal is of unit length and faces the ray
  const Material* material = nullptr;
  double t = 0.0, u = 0.0, v = 0.0;
  bool front = true;  ///< the ray came from outside

  void setNormal(const Ray& ray, Vec outward);
};

/// An axis-aligned bounding box.
struct Bounds {
  Vec low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};

  void add(Vec p);
  void add(const Bounds& other);
  bool hit(const Ray& ray, Interval range) const;
};

class Hittable {
 public:
  virtual ~Hittable() = default;
  /// The nearest hit in the range. Media draw random numbers.
  virtual bool hit(const Ray& ray, Interval range, Hit& hit, Random& random) const = 0;
  virtual Bounds bounds() const = 0;
};
using Object = std::unique_ptr<const Hittable>;

class Sphere final : public Hittable {
 public:
  /// From one centre to the other while the shutter is open.
  Sphere(Vec from, Vec to, double radius, const Material* material);
  bool hit(const Ray& ray, Interval range, Hit& hit, Random& random) const override;
  Bounds bounds() const override;

 private:
  Vec center_, move_;
  double radius_;
  const Material* material_;
};

class Quad final : public Hittable {
 public:
  Quad(Vec corner, Vec u, Vec v, const Material* material);
  bool hit(const Ray& ray, Interval range, Hit& hit, Random& random) const override;
  Bounds bounds() const override;

 private:
  Vec corner_, u_, v_, normal_, w_;
  double distance_;  ///< of the plane from the origin, along the normal
  const Material* material_;
};

/// /// Tests each object in turn.
class List final : public Hittable {
 public:
  explicit List(std::vector<Object> objects) : objects_(std::move(objects)) {}
  bool hit(const Ray& ray, Interval range, Hit& hit, Random& random) const override;
  Bounds bounds() const override;

 private:
  std::vector<Object> objects_;
};

/// Six quads.
Object makeBox(Vec low, Vec high, const Material* material);

/// A hierarchy: split at the median along the longest axis of the bounds. There must be an object.
Object makeHierarchy(std::vector<Object> objects);

class Translated final : public Hittable {
 public:
  Translated(Object object, Vec offset) : object_(std::move(object)), offset_(offset) {}
  bool hit(const Ray& ray, Interval range, Hit& hit, Random& random) const override;
  Bounds bounds() const override;

 private:
  Object object_;
  Vec offset_;
};

/// Turned about the y axis, counter-clockwise seen from above.
class RotatedY final : public Hittable {
 public:
  RotatedY(Object object, double sine, double cosine);
  bool hit(const Ray& ray, Interval range, Hit& hit, Random& random) const override;
  Bounds bounds() const override { return bounds_; }

 private:
  Vec toWorld(Vec v) const { return {cosine_ * v.x + sine_ * v.z, v.y, cosine_ * v.z - sine_ * v.x}; }
  Vec toObject(Vec v) const { return {cosine_ * v.x - sine_ * v.z, v.y, cosine_ * v.z + sine_ * v.x}; }

  Object object_;
  double sine_, cosine_;
  Bounds bounds_;
};

/// Fills a convex boundary with particles.
class ConstantMedium final : public Hittable {
 public:
  /// `density`: hits per unit of length.
  ConstantMedium(Object boundary, double density, const Material* particles);
  bool hit(const Ray& ray, Interval range, Hit& hit, Random& random) const override;
  Bounds bounds() const override { return boundary_->bounds(); }

 private:
  Object boundary_;
  double meanFreePath_;
  const Material* particles_;
};

}  // namespace steradian::bench::books
