#pragma once
/// Textures and materials as in the books (see books_objects.h).
#include <array>
#include <memory>

#include "steradian/apps/bench/books_objects.h"
#include "steradian/core/scene/description.h"

namespace steradian::bench::books {

class Texture {
 public:
  virtual ~Texture() = default;
  virtual Colour value(const Hit& hit) const = 0;
};

class SolidColour final : public Texture {
 public:
  explicit SolidColour(Colour colour) : colour_(colour) {}
  Colour value(const Hit&) const override { return colour_; }

 private:
  Colour colour_;
};

/// `frequency`: cells per unit of space, or of the parameters.
class Checker final : public Texture {
 public:
  Checker(const Texture* even, const Texture* odd, double frequency, bool inSpace)
      : even_(even), odd_(odd), frequency_(frequency), inSpace_(inSpace) {}
  Colour value(const Hit& hit) const override;

 private:
  const Texture *even_, *odd_;
  double frequency_;
  bool inSpace_;
};

/// The pixel that the parameters fall into; the picture repeats.
class Picture final : public Texture {
 public:
  explicit Picture(const ImageTexture& texture) : texture_(texture) {}
  Colour value(const Hit& hit) const override;

 private:
  ImageTexture texture_;
};

/// Noise by tables of permutations and of random unit vectors: not Steradian's pattern, but of the same kind.
class Noise final : public Texture {
 public:
  explicit Noise(const NoiseTexture& texture);
  Colour value(const Hit& hit) const override;

 private:
  static constexpr int kVectors = 256;
  double noise(Vec p) const;
  double turbulence(Vec p) const;

  NoiseTexture texture_;
  std::array<Vec, kVectors> vectors_;
  std::array<std::array<int, kVectors>, 3> permutations_;
};

/// The scattered ray; its radiance is multiplied by `attenuation`.
struct Scattered {
  Colour attenuation{};
  Ray ray;
};

class Material {
 public:
  virtual ~Material() = default;
  virtual Colour emitted(const Hit&) const { return {}; }
  /// False: the ray is absorbed.
  virtual bool scatter(const Ray&, const Hit&, Scattered&, Random&) const { return false; }
};

/// Absorbs all.
class Black final : public Material {};

class Lambertian final : public Material {
 public:
  explicit Lambertian(const Texture* reflectance) : reflectance_(reflectance) {}
  bool scatter(const Ray& ray, const Hit& hit, Scattered& scattered, Random& random) const override;

 private:
  const Texture* reflectance_;
};

/// Scatters uniformly over the hemisphere.
class Hemispherical final : public Material {
 public:
  explicit Hemispherical(const Texture* reflectance) : reflectance_(reflectance) {}
  bool scatter(const Ray& ray, const Hit& hit, Scattered& scattered, Random& random) const override;

 private:
  const Texture* reflectance_;
};

class Metal final : public Material {
 public:
  Metal(const Texture* reflectance, double fuzz) : reflectance_(reflectance), fuzz_(fuzz) {}
  bool scatter(const Ray& ray, const Hit& hit, Scattered& scattered, Random& random) const override;

 private:
  const Texture* reflectance_;
  double fuzz_;
};

class Glass final : public Material {
 public:
  /// `schlick`: the books' reflectance; else Fresnel's, so that pictures can be compared with Steradian's.
  Glass(double eta, bool schlick) : eta_(eta), schlick_(schlick) {}
  bool scatter(const Ray& ray, const Hit& hit, Scattered& scattered, Random& random) const override;

 private:
  double eta_;
  bool schlick_;
};

class Light final : public Material {
 public:
  Light(Colour radiance, bool twoSided) : radiance_(radiance), twoSided_(twoSided) {}
  Colour emitted(const Hit& hit) const override { return twoSided_ || hit.front ? radiance_ : Colour{}; }

 private:
  Colour radiance_;
  bool twoSided_;
};

/// The particles of a medium.
class Isotropic final : public Material {
 public:
  explicit Isotropic(Colour albedo) : albedo_(albedo) {}
  bool scatter(const Ray& ray, const Hit& hit, Scattered& scattered, Random& random) const override;

 private:
  Colour albedo_;
};

}  // namespace steradian::bench::books
