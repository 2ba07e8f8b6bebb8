#include <memory>

#include "steradian/apps/bench/micro.h"
#include "steradian/apps/bench/micro_loop.h"
#include "steradian/apps/scenes/scenes.h"
#include "steradian/core/film/film.h"
#include "steradian/integrators/scene/scene.h"
#include "steradian/materials/bsdf.h"
#include "steradian/materials/fresnel.h"

namespace steradian::bench {
namespace {

const Rgb kReflectance{0.73f, 0.5f, 0.2f};
const Vec3f kUp{0.0f, 1.0f, 0.0f};

/// Directions of the upper hemisphere, from which light comes or goes.
std::vector<Vec3f> directionsAbove(std::uint32_t stream) {
  const UniformPoints points(stream);
  std::vector<Vec3f> directions;
  for (std::size_t i = 0; i < kInputs; ++i) {
    const Vec3f w = UniformHemisphere<float>::sample(points.at<float>(i));
    directions.push_back({w.x, w.z, w.y});
  }
  return directions;
}

void registerMaterial(const std::string& name, const Bsdf::Model& model) {
  const Bsdf bsdf(model, kUp, kUp);
  benchmark::RegisterBenchmark(("bsdf/" + name + "/sample").c_str(), [bsdf](benchmark::State& state) {
    const std::vector<Vec3f> wo = directionsAbove(0);
    const UniformPoints points(1);
    const std::vector<float> lobes = uniformNumbers(kInputs, 4);
    measureCalls(state, kInputs, 1, [&](std::size_t i) {
      return bsdf.sample(wo[i], {lobes[i], points.at<float>(i)}, Transport::Radiance);
    });
  });
  benchmark::RegisterBenchmark(("bsdf/" + name + "/eval").c_str(), [bsdf](benchmark::State& state) {
    const std::vector<Vec3f> wo = directionsAbove(0), wi = directionsAbove(1);
    measureCalls(state, kInputs, 1, [&](std::size_t i) { return bsdf.eval(wo[i], wi[i], Transport::Radiance); });
  });
}

/// Seen from a square of edge 2 `half` on the floor.
void registerLights(const std::string& name, Vec3f center, float half) {
  benchmark::RegisterBenchmark(("lights/" + name + "/sample").c_str(), [=](benchmark::State& state) {
    const Scene scene(makeScene(name));
    const std::vector<float> select = uniformNumbers(kInputs, 4);
    const UniformPoints points(0), places(1);
    measureCalls(state, kInputs, 1, [&](std::size_t i) {
      const Vec2f place = places.at<float>(i);
      const Vec3f offset{2.0f * place.x - 1.0f, 0.0f, 2.0f * place.y - 1.0f};
      return scene.lights().sample(ScatterPoint<float>{center + offset * half, {}, kUp},
                                   LightRandom<float>{select[i], points.at<float>(i)});
    });
  });
}

/// Adds samples in runs of this length, as passes of that length do.
void registerFilm(std::size_t run) {
  benchmark::RegisterBenchmark(("film/add-samples/" + std::to_string(run)).c_str(), [run](benchmark::State& state) {
    constexpr int kSide = 128;
    Film film({.width = kSide, .height = kSide});
    const std::vector<float> numbers = uniformNumbers(run, 0);
    std::vector<PixelSample> samples(run);
    for (std::size_t i = 0; i < run; ++i) {
      samples[i] = {.radiance = grey(numbers[i]), .albedo = kReflectance, .normal = kUp, .depth = 800.0f};
    }
    std::uint32_t pass = 0;
    measureCalls(state, kSide * kSide, run, [&](std::size_t i) {
      const int pixel = static_cast<int>(i);
      film.addSamples(pixel % kSide, pixel / kSide, pass * static_cast<std::uint32_t>(run), samples);
      if (pixel == kSide * kSide - 1) ++pass;
      return pass;
    });
  });
}

}  // namespace

void registerShadingBenchmarks() {
  constexpr float kEta = 1.5f;
  registerMaterial("lambert", Lambert<float>{kReflectance});
  registerMaterial("mirror", Mirror<float>{kReflectance});
  registerMaterial("fuzzy-metal", FuzzyMetal<float>{kReflectance, 0.3f});
  registerMaterial("dielectric", Dielectric<float>{kEta});
  const auto internal = static_cast<float>(1.0 - diffuseTransmittance(1.0 / static_cast<double>(kEta)));
  registerMaterial("coated", Coated<float>{kReflectance, kEta, internal});
  registerLights("cornell-box", {278.0f, 0.0f, 278.0f}, 200.0f);
  registerLights("simple-light", {0.0f, 0.0f, 0.0f}, 3.0f);
  for (const std::size_t run : {1u, 16u, 64u}) registerFilm(run);
}

}  // namespace steradian::bench
