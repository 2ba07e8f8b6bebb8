#include "steradian/materials/material_table.h"

#include <gtest/gtest.h>

#include "steradian/tests/materials/models.h"
#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

using F = Lanes<8>;
using test::randomDirection;
using test::randomNumbers;
using test::sameBits;

SceneDescription everyMaterial() {
  SceneDescription scene;
  const Id red = scene.addColour({0.8f, 0.1f, 0.1f}), green = scene.addColour({0.2f, 0.7f, 0.3f});
  const Id checker = scene.addTexture(CheckerTexture{red, green, 0.25f});
  scene.addMaterial("matte", LambertMaterial{red});
  scene.addMaterial("glass", DielectricMaterial{1.5f, false});
  scene.addMaterial("checkered", LambertMaterial{checker});
  scene.addMaterial("metal", MetalMaterial{green, 0.3f});
  scene.addMaterial("mirror", MetalMaterial{red, 0.0f});
  scene.addMaterial("varnish", CoatedMaterial{green, 1.4f});
  scene.addMaterial("book's glass", DielectricMaterial{1.3f, true});
  scene.addMaterial("black", AbsorberMaterial{});
  scene.addMaterial("uniform", UniformDiffuseMaterial{red});
  const Id marble = scene.addTexture(NoiseTexture{.scale = 3.0f});
  const Id cloud = scene.addTexture(NoiseTexture{.pattern = NoiseTexture::Pattern::Noise, .seed = 4});
  scene.addMaterial("marble", LambertMaterial{marble});
  scene.addMaterial("cloudy metal", MetalMaterial{cloud, 0.5f});
  scene.addMaterial("marble tiles", LambertMaterial{scene.addTexture(CheckerTexture{marble, red, 0.5f})});
  return scene;
}

SurfacePoint<float> pointOf(std::uint32_t material, std::uint32_t index) {
  SurfacePoint<float> point;
  point.valid = true;
  point.position = randomDirection(index + 1000);
  point.geometricNormal = randomDirection(index);
  point.shadingNormal = normalize(point.geometricNormal + randomDirection(index + 77) * 0.2f);
  point.material = material;
  return point;
}

/// Lane by lane the functions of Bsdf, bit for bit, for any mixture of materials in one vector.
TEST(MaterialTable, LanesAgreeWithBsdf) {
  const MaterialSet materials(everyMaterial());
  const MaterialTable table(materials);
  EXPECT_FALSE(table.readsUv());  // a checker in space
  for (std::uint32_t round = 0; round < 400; ++round) {
    SurfacePoint<F> points;
    Vec3<F> wo, wi;
    BsdfRandom<F> random;
    for (int i = 0; i < 8; ++i) {
      const std::uint32_t index = 8 * round + static_cast<std::uint32_t>(i);
      // A material that does not exist absorbs.
      setLane(points, i, pointOf(index % 14 == 13 ? kNone : (index * 7) % 13, index));
      setLane(wo, i, randomDirection(index + 3));
      setLane(wi, i, randomDirection(index + 5));
      const BsdfRandom<float> r = randomNumbers(index);
      setLane(random.lobe, i, r.lobe);
      setLane(random.direction, i, r.direction);
    }
    auto parameters = table.parameters(points, Mask<8>(true));
    for (int i = 0; i < 8; ++i) setLane(parameters.outsideEta, i, i % 3 == 0 ? 1.33f : 1.0f);
    const ShadingFrame<F> frame(points.geometricNormal,
                                usableShadingNormal(points.geometricNormal, points.shadingNormal, wo));
    BsdfSample<F> sample;
    BsdfValue<F> value;
    Spectrum<F> albedo;
    F dirac;
    Mask<8> sampled, seen(false);
    table.forEachModel(parameters, Mask<8>(true), [&](const auto& model, Mask<8> mine) {
      const Vec3<F> localWo = frame.toLocal(wo);
      const BsdfSample<F> s = frame.sample(model, wo, random, Transport::Radiance);
      const BsdfValue<F> v = frame.eval(model, wo, wi, Transport::Radiance);
      sample.weight = select(mine, s.weight, sample.weight);
      sample.wi = select(mine, s.wi, sample.wi);
      sample.pdf = select(mine, s.pdf, sample.pdf);
      sample.eta = select(mine, s.eta, sample.eta);
      value.value = select(mine, v.value, value.value);
      value.pdf = select(mine, v.pdf, value.pdf);
      albedo = select(mine, model.albedo(localWo), albedo);
      dirac = select(mine, model.diracProbability(localWo), dirac);
      sampled = select(mine, Mask<8>(suitsLightSampling(model, localWo)), sampled);
      EXPECT_FALSE(any(seen & mine));
      seen |= mine;
    });
    EXPECT_TRUE(all(seen));
    for (int i = 0; i < 8; ++i) {
      const Vec3f out = lane(wo, i);
      const Bsdf bsdf = materials.bsdf(lane(points, i), out, lane(parameters.outsideEta, i));
      const BsdfSample<float> s =
          bsdf.sample(out, {lane(random.lobe, i), lane(random.direction, i)}, Transport::Radiance);
      const BsdfValue<float> v = bsdf.eval(out, lane(wi, i), Transport::Radiance);
      EXPECT_TRUE(sameBits(s.pdf, sample.pdf[i]));
      if (s.pdf > 0.0f) {
        EXPECT_TRUE(sameBits(s.wi, lane(sample.wi, i)));
        EXPECT_TRUE(sameBits(s.weight.g, sample.weight.g[i]));
        EXPECT_TRUE(sameBits(s.eta, sample.eta[i]));
      }
      EXPECT_TRUE(sameBits(v.value.r, value.value.r[i]));
      EXPECT_TRUE(sameBits(v.pdf, value.pdf[i]));
      EXPECT_TRUE(sameBits(bsdf.albedo(out).b, albedo.b[i]));
      EXPECT_TRUE(sameBits(bsdf.diracProbability(out), dirac[i]));
      EXPECT_EQ(bsdf.suitsLightSampling(out), sampled[i]);
    }
  }
}

TEST(MaterialTable, WithoutMaterialsEverythingAbsorbs) {
  const MaterialSet none{SceneDescription{}};
  const MaterialTable table(none);
  EXPECT_FALSE(table.readsUv());
  SurfacePoint<F> points;
  int visits = 0;
  table.forEachModel(table.parameters(points, Mask<8>(true)), Mask<8>(true), [&](const auto& model, Mask<8> mine) {
    ++visits;
    EXPECT_TRUE(all(mine));
    EXPECT_TRUE(all(isBlack(model.albedo({F(0.0f), F(0.0f), F(1.0f)}))));
  });
  EXPECT_EQ(visits, 1);
}

}  // namespace
}  // namespace steradian
