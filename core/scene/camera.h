#pragma once
/// Cameras: from a place on the film to a ray into the scene.
///
/// Film positions are in pixels: (0, 0) is the upper left corner of the picture, y runs downwards, the centre of the
/// first pixel is (0.5, 0.5). The camera looks along -w, has its right at u and its top at v, where, as in the books,
/// w = lookFrom - lookAt, u = up x w, v = w x u, each of unit length ("Ray Tracing in One Weekend", 12 and 13).
#include <optional>

#include "steradian/core/math/ray.h"
#include "steradian/core/sampling/warp.h"
#include "steradian/core/scene/description.h"

namespace STERADIAN_API steradian {

/// Everything that a camera ray depends on.
template <class F>
struct CameraSample {
  Vec2<F> film;  ///< pixels, y down
  Vec2<F> lens;  ///< random numbers in [0, 1)^2; a pinhole does not look at them
  F time{0.0f};  ///< in [0, 1): fraction of the shutter interval
};

class Camera {
 public:
  /// Throws `Error`: Scene with everything that is wrong with the description (see `validate`), Usage if the picture
  /// has no pixels.
  Camera(const CameraDescription& description, int width, int height);

  /// A sample of a pixel's radiance is the radiance along the ray, with weight 1: every camera sees the plain mean over
  /// the pixel's area on the film.
  ///
  /// Perspective: through one point of the plane of focus, from the whole lens; distances along the axis. Orthographic:
  /// parallel, from the plane through lookFrom. Spherical: longitude along x, colatitude from v along y.
  template <class F>
  Ray<F> ray(const CameraSample<F>& sample) const;

  /// Rays depend on CameraSample::lens.
  bool hasLens() const { return lensRadius_ > 0.0f; }

  /// From the world to camera space as EXR files have it (RenderMan's): x right, y up, z forwards.
  const Matrix& worldToCamera() const { return worldToCamera_; }
  /// From the world to the picture: after division by w, x and y run from -1 to 1, left to right and bottom to top, as
  /// Nuke's camera scripts expect of "worldToNDC"; z is 1 - 1 / distance for the perspective camera, the distance along
  /// the axis for the orthographic one. None for the spherical camera: no matrix projects a sphere.
  const std::optional<Matrix>& worldToNdc() const { return worldToNdc_; }

 private:
  enum class Kind { Perspective, Orthographic, Spherical };

  template <class F>
  Vec3<F> filmPoint(Vec2<F> film) const {
    return broadcast<F>(corner_) + broadcast<F>(acrossPixel_) * film.x + broadcast<F>(downPixel_) * film.y;
  }

  Kind kind_ = Kind::Perspective;
  Vec3f origin_;     // lookFrom
  Vec3f u_, v_, w_;  // right, top, back: orthonormal
  // The picture: at distance 1 (perspective) or 0 (orthographic) of lookFrom, its origin.
  Vec3f corner_;                   // upper left
  Vec3f acrossPixel_, downPixel_;  // one pixel to the right and down
  float lensRadius_ = 0.0f;
  float lensSlope_ = 0.0f;  // lensRadius_ / focus distance
  float inverseWidth_ = 1.0f, inverseTwiceHeight_ = 0.5f;
  Matrix worldToCamera_;
  std::optional<Matrix> worldToNdc_;
};

/// Everything that is wrong with a camera: values that are not finite, lookFrom = lookAt, up parallel to the view or
/// zero, a field of view outside (0, 180), a defocus angle outside [0, 180), a focus distance or height not above 0.
Diagnostics validate(const CameraDescription& camera);

template <class F>
Ray<F> Camera::ray(const CameraSample<F>& sample) const {
  Ray<F> ray;
  ray.time = sample.time;
  switch (kind_) {
    case Kind::Perspective: {
      ray.origin = broadcast<F>(origin_);
      ray.direction = filmPoint(sample.film);
      if (lensRadius_ > 0.0f) {
        const Vec2<F> disk = UniformDisk<F>::sample(sample.lens);
        const Vec3<F> onLens = broadcast<F>(u_) * disk.x + broadcast<F>(v_) * disk.y;
        ray.origin += onLens * F(lensRadius_);
        ray.direction -= onLens * F(lensSlope_);
      }
      ray.direction = normalize(ray.direction);
      break;
    }
    case Kind::Orthographic:
      ray.origin = broadcast<F>(origin_) + filmPoint(sample.film);
      ray.direction = broadcast<F>(-w_);
      break;
    case Kind::Spherical: {
      const SinCos<F> longitude = sinCosTwoPi(sample.film.x * F(inverseWidth_) - F(0.5f));
      const SinCos<F> colatitude = sinCosTwoPi(sample.film.y * F(inverseTwiceHeight_));
      ray.origin = broadcast<F>(origin_);
      ray.direction =
          normalize(broadcast<F>(u_) * (colatitude.sin * longitude.sin) + broadcast<F>(v_) * colatitude.cos -
                    broadcast<F>(w_) * (colatitude.sin * longitude.cos));
      break;
    }
  }
  return ray;
}

}  // namespace steradian
