#include "steradian/apps/bench/books_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace steradian::bench::books {
namespace {

constexpr double kPi = 3.14159265358979323846;
/// Half the thickness of the bounds of flat shapes.
constexpr double kPadding = 5e-5;

double component(Vec v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

std::array<Vec, 8> cornersOf(const Bounds& b) {
  std::array<Vec, 8> corners;
  for (unsigned i = 0; i < 8; ++i)
    corners[i] = {(i & 1u) != 0 ? b.high.x : b.low.x, (i & 2u) != 0 ? b.high.y : b.low.y,
                  (i & 4u) != 0 ? b.high.z : b.low.z};
  return corners;
}

class Node final : public Hittable {
 public:
  Node(Object left, Object right) : left_(std::move(left)), right_(std::move(right)) {
    bounds_ = left_->bounds();
    bounds_.add(right_->bounds());
  }
  bool hit(const Ray& ray, Interval range, Hit& hit, Random& random) const override {
    if (!bounds_.hit(ray, range)) return false;
    const bool onLeft = left_->hit(ray, range, hit, random);
    const bool onRight = right_->hit(ray, {range.min, onLeft ? hit.t : range.max}, hit, random);
    return onLeft || onRight;
  }
  Bounds bounds() const override { return bounds_; }

 private:
  Object left_, right_;
  Bounds bounds_;
};

Object hierarchyOf(std::span<Object> objects) {
  if (objects.size() == 1) return std::move(objects[0]);
  Bounds all;
  for (const Object& object : objects) all.add(object->bounds());
  const Vec size = all.high - all.low;
  const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  std::sort(objects.begin(), objects.end(), [axis](const Object& a, const Object& b) {
    return component(a->bounds().low, axis) < component(b->bounds().low, axis);
  });
  const std::size_t half = objects.size() / 2;
  Object left = hierarchyOf(objects.first(half));
  return std::make_unique<Node>(std::move(left), hierarchyOf(objects.subspan(half)));
}

}  // namespace

double lengthOf(Vec v) { return std::sqrt(lengthSquared(v)); }
Vec unit(Vec v) { return v / lengthOf(v); }
Vec inDoubles(Vec3f v) { return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)}; }
Colour inDoubles(Rgb c) { return {static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b)}; }

// --- Random -----------------------------------------------------------------------------------------------------

Random::Random(std::uint32_t seed, std::uint32_t stream)
    : state_((static_cast<std::uint64_t>(seed) << 32) | static_cast<std::uint64_t>(stream)) {
  state_ = word();  // streams are far apart, not next to each other
}

std::uint64_t Random::word() {
  std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

Vec Random::onSphere() {
  for (;;) {
    const double x = between(-1.0, 1.0), y = between(-1.0, 1.0), z = between(-1.0, 1.0);
    const Vec p{x, y, z};
    const double squared = lengthSquared(p);
    if (squared > 1e-160 && squared <= 1.0) return p / std::sqrt(squared);
  }
}

Vec Random::inDisk() {
  for (;;) {
    const double x = between(-1.0, 1.0), y = between(-1.0, 1.0);
    if (x * x + y * y < 1.0) return {x, y, 0.0};
  }
}

// --- Bounds, Hit ------------------------------------------------------------------------------------------------

void Hit::setNormal(const Ray& ray, Vec outward) {
  front = dot(ray.direction, outward) < 0.0;
  normal = front ? outward : -outward;
}

void Bounds::add(Vec p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

void Bounds::add(const Bounds& other) {
  add(other.low);
  add(other.high);
}

bool Bounds::hit(const Ray& ray, Interval range) const {
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1.0 / component(ray.direction, axis), origin = component(ray.origin, axis);
    double enter = (component(low, axis) - origin) * inverse, leave = (component(high, axis) - origin) * inverse;
    if (inverse < 0.0) std::swap(enter, leave);
    range.min = enter > range.min ? enter : range.min;
    range.max = leave < range.max ? leave : range.max;
    if (range.max <= range.min) return false;
  }
  return true;
}

// --- Sphere, Quad -----------------------------------------------------------------------------------------------

Sphere::Sphere(Vec from, Vec to, double radius, const Material* material)
    : center_(from), move_(to - from), radius_(radius), material_(material) {}

bool Sphere::hit(const Ray& ray, Interval range, Hit& hit, Random&) const {
  const Vec center = center_ + move_ * ray.time;
  const Vec toCenter = center - ray.origin;
  const double a = lengthSquared(ray.direction), half = dot(ray.direction, toCenter);
  const double discriminant = half * half - a * (lengthSquared(toCenter) - radius_ * radius_);
  if (discriminant < 0.0) return false;
  const double root = std::sqrt(discriminant);
  double t = (half - root) / a;
  if (t <= range.min || t >= range.max) {
    t = (half + root) / a;
    if (t <= range.min || t >= range.max) return false;
  }
  hit.t = t;
  hit.position = ray.at(t);
  const Vec outward = (hit.position - center) / radius_;
  hit.setNormal(ray, outward);
  hit.u = (std::atan2(-outward.z, outward.x) + kPi) / (2.0 * kPi);
  hit.v = std::acos(std::clamp(-outward.y, -1.0, 1.0)) / kPi;
  hit.material = material_;
  return true;
}

Bounds Sphere::bounds() const {
  const Vec reach{radius_, radius_, radius_};
  Bounds b;
  for (const Vec center : {center_, center_ + move_}) {
    b.add(center - reach);
    b.add(center + reach);
  }
  return b;
}

Quad::Quad(Vec corner, Vec u, Vec v, const Material* material) : corner_(corner), u_(u), v_(v), material_(material) {
  const Vec n = cross(u, v);
  normal_ = unit(n);
  w_ = n / lengthSquared(n);
  distance_ = dot(normal_, corner);
}

bool Quad::hit(const Ray& ray, Interval range, Hit& hit, Random&) const {
  const double slope = dot(normal_, ray.direction);
  if (std::fabs(slope) < 1e-8) return false;
  const double t = (distance_ - dot(normal_, ray.origin)) / slope;
  if (t < range.min || t > range.max) return false;
  const Vec position = ray.at(t), offset = position - corner_;
  const double a = dot(w_, cross(offset, v_)), b = dot(w_, cross(u_, offset));
  if (a < 0.0 || a > 1.0 || b < 0.0 || b > 1.0) return false;
  hit.t = t;
  hit.u = a;
  hit.v = b;
  hit.position = position;
  hit.material = material_;
  hit.setNormal(ray, normal_);
  return true;
}

Bounds Quad::bounds() const {
  Bounds b;
  for (const Vec p : {corner_, corner_ + u_, corner_ + v_, corner_ + u_ + v_}) b.add(p);
  const Vec padding{kPadding, kPadding, kPadding};
  return {b.low - padding, b.high + padding};
}

// --- Lists and hierarchy ----------------------------------------------------------------------------------------

bool List::hit(const Ray& ray, Interval range, Hit& hit, Random& random) const {
  bool any = false;
  for (const Object& object : objects_) {
    if (!object->hit(ray, range, hit, random)) continue;
    any = true;
    range.max = hit.t;
  }
  return any;
}

Bounds List::bounds() const {
  Bounds all;
  for (const Object& object : objects_) all.add(object->bounds());
  return all;
}

Object makeBox(Vec low, Vec high, const Material* material) {
  const Vec size = high - low, x{size.x, 0.0, 0.0}, y{0.0, size.y, 0.0}, z{0.0, 0.0, size.z};
  std::vector<Object> sides;
  const auto add = [&](Vec corner, Vec u, Vec v) { sides.push_back(std::make_unique<Quad>(corner, u, v, material)); };
  add(low + z, x, y);
  add(low + x + z, -z, y);
  add(low + x, -x, y);
  add(low, z, y);
  add(low + y + z, x, -z);
  add(low, x, z);
  return std::make_unique<List>(std::move(sides));
}

Object makeHierarchy(std::vector<Object> objects) { return hierarchyOf(objects); }

// --- Instances --------------------------------------------------------------------------------------------------

bool Translated::hit(const Ray& ray, Interval range, Hit& hit, Random& random) const {
  const Ray moved{ray.origin - offset_, ray.direction, ray.time};
  if (!object_->hit(moved, range, hit, random)) return false;
  hit.position += offset_;
  return true;
}

Bounds Translated::bounds() const {
  const Bounds b = object_->bounds();
  return {b.low + offset_, b.high + offset_};
}

RotatedY::RotatedY(Object object, double sine, double cosine)
    : object_(std::move(object)), sine_(sine), cosine_(cosine) {
  for (const Vec corner : cornersOf(object_->bounds())) bounds_.add(toWorld(corner));
}

bool RotatedY::hit(const Ray& ray, Interval range, Hit& hit, Random& random) const {
  const Ray turned{toObject(ray.origin), toObject(ray.direction), ray.time};
  if (!object_->hit(turned, range, hit, random)) return false;
  hit.position = toWorld(hit.position);
  hit.normal = toWorld(hit.normal);
  return true;
}

// --- Media ------------------------------------------------------------------------------------------------------

ConstantMedium::ConstantMedium(Object boundary, double density, const Material* particles)
    : boundary_(std::move(boundary)), meanFreePath_(1.0 / density), particles_(particles) {}

bool ConstantMedium::hit(const Ray& ray, Interval range, Hit& hit, Random& random) const {
  Hit enter, leave;
  if (!boundary_->hit(ray, {}, enter, random)) return false;
  if (!boundary_->hit(ray, {enter.t + 0.0001, kFar}, leave, random)) return false;
  const double from = std::max({enter.t, range.min, 0.0}), to = std::min(leave.t, range.max);
  if (from >= to) return false;
  const double length = lengthOf(ray.direction);
  const double flight = -meanFreePath_ * std::log(random.next());
  if (flight > (to - from) * length) return false;
  hit.t = from + flight / length;
  hit.position = ray.at(hit.t);
  hit.normal = {1.0, 0.0, 0.0};  // arbitrary: phase functions ignore it
  hit.front = true;
  hit.material = particles_;
  return true;
}

}  // namespace steradian::bench::books
