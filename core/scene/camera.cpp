#include "steradian/core/scene/camera.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "steradian/core/image/image.h"

namespace steradian {
namespace {

using Vector = Imath::V3d;

constexpr double kDegree = 3.14159265358979323846 / 180.0;
/// Below this sine of the angle between up and the view, "up" says nothing.
constexpr double kParallel = 1e-6;

Vector toDouble(Vec3f v) { return {v.x, v.y, v.z}; }
Vec3f toFloat(const Vector& v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }
bool finite(Vec3f v) { return isFinite(v.x) && isFinite(v.y) && isFinite(v.z); }
std::string text(Vec3f v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

/// The camera's axes: right, top, back.
struct Axes {
  Vector u, v, w;
};

template <class Description>
Axes axesOf(const Description& d) {
  const Vector w = (toDouble(d.lookFrom) - toDouble(d.lookAt)).normalized();
  const Vector u = toDouble(d.up).normalized().cross(w).normalized();
  return {u, w.cross(u), w};
}

template <class Description>
void checkPlacement(const Description& d, Diagnostics& out) {
  const bool places = finite(d.lookFrom) && finite(d.lookAt);
  if (!finite(d.lookFrom)) out.error({}, "the camera's lookFrom " + text(d.lookFrom) + " is not finite");
  if (!finite(d.lookAt)) out.error({}, "the camera's lookAt " + text(d.lookAt) + " is not finite");
  if (!finite(d.up)) out.error({}, "the camera's up " + text(d.up) + " is not finite");
  const Vector back = toDouble(d.lookFrom) - toDouble(d.lookAt), up = toDouble(d.up);
  if (places && back.length() == 0.0) {
    out.error({}, "the camera's lookFrom and lookAt are the same point " + text(d.lookFrom));
  }
  if (finite(d.up) && up.length() == 0.0) out.error({}, "the camera's up is zero");
  if (places && finite(d.up) && back.length() > 0.0 && up.length() > 0.0 &&
      up.normalized().cross(back.normalized()).length() < kParallel) {
    out.error({}, "the camera's up " + text(d.up) + " is parallel to the direction of view");
  }
}

void checkOptics(const PerspectiveCamera& d, Diagnostics& out) {
  if (!(d.verticalFov > 0.0f && d.verticalFov < 180.0f)) {
    out.error({}, fmt::format("the camera's vertical field of view must lie between 0 and 180 degrees, not be {}",
                              d.verticalFov));
  }
  if (!(d.defocusAngle >= 0.0f && d.defocusAngle < 180.0f)) {
    out.error(
        {}, fmt::format("the camera's defocus angle must be at least 0 and below 180 degrees, not {}", d.defocusAngle));
  }
  if (!(d.focusDistance > 0.0f && isFinite(d.focusDistance))) {
    out.error({}, fmt::format("the camera's focus distance must be finite and above 0, not {}", d.focusDistance));
  }
}
void checkOptics(const OrthographicCamera& d, Diagnostics& out) {
  if (!(d.height > 0.0f && isFinite(d.height))) {
    out.error({}, fmt::format("the camera's height must be finite and above 0, not {}", d.height));
  }
}
void checkOptics(const SphericalCamera&, Diagnostics&) {}

Matrix worldToCameraOf(const Axes& a, Vec3f lookFrom) {
  const Vector eye = toDouble(lookFrom), forward = -a.w;
  const auto f = [](double x) { return static_cast<float>(x); };
  return {f(a.u.x), f(a.v.x), f(forward.x), 0.0f, f(a.u.y),         f(a.v.y),         f(forward.y),         0.0f,
          f(a.u.z), f(a.v.z), f(forward.z), 0.0f, f(-eye.dot(a.u)), f(-eye.dot(a.v)), f(-eye.dot(forward)), 1.0f};
}

/// Camera space to the picture; halfWidth and halfHeight of the picture at distance 1, or of the parallel beam.
Matrix perspectiveToNdc(double halfWidth, double halfHeight) {
  Matrix m;
  m.makeIdentity();
  m[0][0] = static_cast<float>(1.0 / halfWidth);
  m[1][1] = static_cast<float>(1.0 / halfHeight);
  m[2][3] = 1.0f;
  m[3][2] = -1.0f;
  m[3][3] = 0.0f;
  return m;
}
Matrix orthographicToNdc(double halfWidth, double halfHeight) {
  Matrix m;
  m.makeIdentity();
  m[0][0] = static_cast<float>(1.0 / halfWidth);
  m[1][1] = static_cast<float>(1.0 / halfHeight);
  return m;
}

}  // namespace

Diagnostics validate(const CameraDescription& camera) {
  Diagnostics diagnostics;
  std::visit(
      [&](const auto& d) {
        checkPlacement(d, diagnostics);
        checkOptics(d, diagnostics);
      },
      camera);
  return diagnostics;
}

Camera::Camera(const CameraDescription& description, int width, int height) {
  if (width < 1 || height < 1 || width > Image::maxSide || height > Image::maxSide) {
    throw Error(ErrorKind::Usage, fmt::format("a picture cannot have {} x {} pixels: each side must lie in [1, {}]",
                                              width, height, Image::maxSide));
  }
  validate(description).throwIfErrors(ErrorKind::Scene);

  const Axes axes = std::visit([](const auto& d) { return axesOf(d); }, description);
  origin_ = std::visit([](const auto& d) { return d.lookFrom; }, description);
  u_ = toFloat(axes.u);
  v_ = toFloat(axes.v);
  w_ = toFloat(axes.w);
  worldToCamera_ = worldToCameraOf(axes, origin_);
  inverseWidth_ = 1.0f / static_cast<float>(width);
  inverseTwiceHeight_ = 0.5f / static_cast<float>(height);

  /// Puts the picture into the plane at `distance`.
  const auto placeFilm = [&](double distance, double filmHeight) {
    const double pixel = filmHeight / height;
    acrossPixel_ = toFloat(axes.u * pixel);
    downPixel_ = toFloat(axes.v * -pixel);
    corner_ = toFloat(axes.w * -distance - axes.u * (0.5 * pixel * width) + axes.v * (0.5 * filmHeight));
  };
  const double aspect = static_cast<double>(width) / height;
  if (const auto* d = std::get_if<PerspectiveCamera>(&description)) {
    kind_ = Kind::Perspective;
    const double halfHeight = std::tan(0.5 * kDegree * d->verticalFov);
    const double slope = std::tan(0.5 * kDegree * d->defocusAngle);
    placeFilm(1.0, 2.0 * halfHeight);
    lensSlope_ = static_cast<float>(slope);
    lensRadius_ = static_cast<float>(slope * d->focusDistance);
    worldToNdc_ = worldToCamera_ * perspectiveToNdc(halfHeight * aspect, halfHeight);
  } else if (const auto* o = std::get_if<OrthographicCamera>(&description)) {
    kind_ = Kind::Orthographic;
    placeFilm(0.0, o->height);
    worldToNdc_ = worldToCamera_ * orthographicToNdc(0.5 * o->height * aspect, 0.5 * o->height);
  } else {
    kind_ = Kind::Spherical;
  }
}

}  // namespace steradian
