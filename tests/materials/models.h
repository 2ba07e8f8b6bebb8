#pragma once
/// The models under test, and what all of them must satisfy.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "steradian/core/samplers/rng.h"
#include "steradian/materials/absorber.h"
#include "steradian/materials/coated.h"
#include "steradian/materials/dielectric.h"
#include "steradian/materials/fuzzy_metal.h"
#include "steradian/materials/lambert.h"
#include "steradian/materials/mirror.h"
#include "steradian/materials/uniform_diffuse.h"

namespace steradian::test {

inline constexpr Rgb kColour{0.8f, 0.5f, 0.1f};

template <class F>
Coated<F> coated(Rgb reflectance, float eta) {
  const auto internal = static_cast<float>(1.0 - diffuseTransmittance(1.0 / static_cast<double>(eta)));
  return {broadcast<F>(reflectance), F(eta), F(internal)};
}

/// Calls visit(name, model at width 1, the same model at width 8) for every model.
template <class Visitor>
void forEachModel(Visitor&& visit) {
  using F = float;
  using L = Lanes<8>;
  visit("absorber", Absorber<F>{}, Absorber<L>{});
  visit("lambert", Lambert<F>{kColour}, Lambert<L>{broadcast<L>(kColour)});
  visit("uniform diffuse", UniformDiffuse<F>{kColour}, UniformDiffuse<L>{broadcast<L>(kColour)});
  visit("mirror", Mirror<F>{kColour}, Mirror<L>{broadcast<L>(kColour)});
  for (const float fuzz : {0.001f, 0.1f, 0.6f, 0.98f, 1.0f}) {
    visit("metal of fuzz " + std::to_string(fuzz), FuzzyMetal<F>{kColour, fuzz},
          FuzzyMetal<L>{broadcast<L>(kColour), L(fuzz)});
  }
  for (const float eta : {1.5f, 0.75f, 1.0f}) {
    const std::string index = std::to_string(eta);
    visit("dielectric of index " + index, Dielectric<F>{eta}, Dielectric<L>{L(eta)});
    visit("dielectric by Schlick of index " + index, SchlickDielectric<F>{eta}, SchlickDielectric<L>{L(eta)});
    visit("coat of index " + index, coated<F>(kColour, eta), coated<L>(kColour, eta));
  }
  visit("coat over white", coated<F>(grey(1.0f), 1.5f), coated<L>(grey(1.0f), 1.5f));
  visit("coat over black", coated<F>(grey(0.0f), 1.5f), coated<L>(grey(0.0f), 1.5f));
}

/// Three numbers in [0, 1) and a unit vector, by index.
inline BsdfRandom<float> randomNumbers(std::uint32_t index) {
  const auto w = randomWords<std::uint32_t>(index, 1u, 2u, 3u);
  return {toUnitFloat<float>(w[0]), {toUnitFloat<float>(w[1]), toUnitFloat<float>(w[2])}};
}
inline Vec3f randomDirection(std::uint32_t index) {
  const auto w = randomWords<std::uint32_t>(index, 5u, 6u, 7u);
  return UniformSphere<float>::sample({toUnitFloat<float>(w[0]), toUnitFloat<float>(w[1])});
}
/// The direction at an angle from the normal (degrees; beyond 90: from below).
inline Vec3f fromNormal(double degrees, double azimuth = 25.0) {
  const double t = degrees * M_PI / 180.0, phi = azimuth * M_PI / 180.0;
  return {static_cast<float>(std::sin(t) * std::cos(phi)), static_cast<float>(std::sin(t) * std::sin(phi)),
          static_cast<float>(std::cos(t))};
}

}  // namespace steradian::test
