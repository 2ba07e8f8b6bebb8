/// The one header of the sampling layer: that it suffices, that it brings no scene and no ray tracer, and that nothing
/// in it breaks for sizes, distances and angles far from usual ones.
#include "steradian/accel/shapes/sampling/sampling.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "steradian/tests/accel/shapes/target_check.h"

namespace steradian::test {
namespace {

TEST(Sampling, OneHeaderSuffices) {
  const Vec3f n{0.0f, 0.0f, 1.0f}, from{};
  const SampledShape light(Quad<float>{{-1.0f, -1.0f, 2.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 2.0f, 0.0f}});
  const MixturePdf mixture(std::array{0.5f, 0.5f}, HittablePdf(light, from), CosinePdf<float>(n));
  // A mean of cos / pdf: the integral of the cosine over the hemisphere is pi.
  double sum = 0.0;
  constexpr std::uint32_t samples = 4096;
  for (std::uint32_t i = 0; i < samples; ++i) {
    const Sampler<float> sampler(SamplerSettings{}, 0, i);
    const auto s = mixture.sample(sampler.get1D(0), sampler.get2D(1));
    if (s.pdf > 0.0f) sum += static_cast<double>(maximum(s.wi.z, 0.0f) / s.pdf);
  }
  EXPECT_NEAR(sum / samples, 3.14159, 0.05);
  // Uses something of each part, so that it must link.
  const std::array<float, 4> weights{1.0f, 2.0f, 3.0f, 4.0f};
  EXPECT_GT(PiecewiseConstant2D(weights, 2, 2).sample(Vec2f{0.3f, 0.4f}).pdf, 0.0f);
  EXPECT_GT(HierarchicalWarp(weights, 2, 2).sample(Vec2f{0.3f, 0.4f}).pdf, 0.0f);
  EXPECT_EQ(AliasTable(weights).size(), 4u);
  EXPECT_EQ(SampledInverseCdf(std::array{WeightedPlace{0.5f, 1.0f}}, 0.0f, 1.0f).halfway(), 0.5f);
  EXPECT_GT(HenyeyGreenstein<float>{0.5f}.pdf(n), 0.0f);
  EXPECT_GT((GgxVisibleNormals<float>{{0.5f, 0.5f}, n}.pdf(n)), 0.0f);
  EXPECT_GT((LinearDensity<float>{0.0f, 1.0f, 0.0f, 1.0f}.sample(0.5f)), 0.0f);
  WeightedReservoir<float, int> reservoir;
  EXPECT_TRUE(reservoir.add(1, 1.0f, 0.5f));
  EXPECT_EQ(misWeight(1.0f, 1.0f), 0.5f);
  EXPECT_GT(sampleDirection(Sphere<float>{{0.0f, 0.0f, 3.0f}, 1.0f}, from, {0.3f, 0.4f}).pdf, 0.0f);
  EXPECT_GT(sampleDirection(Disk<float>{{0.0f, 0.0f, 3.0f}, n, 1.0f}, from, {0.3f, 0.4f}).pdf, 0.0f);
}

/// The files of ours that a file includes, and so on.
void collectIncludes(const std::string& path, std::set<std::string>& found, std::set<std::string>& foreign) {
  if (!found.insert(path).second) return;
  std::ifstream file(std::filesystem::path(STERADIAN_SOURCE_DIR) / path);
  ASSERT_TRUE(file) << path;
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("#include ")) continue;
    const std::string name = line.substr(10, line.find_first_of(">\"", 10) - 10);
    if (name.starts_with("steradian/")) {
      collectIncludes(name.substr(10), found, foreign);
    } else {
      foreign.insert(name);
    }
  }
}

TEST(Sampling, BringsNoSceneAndNoRayTracer) {
  std::set<std::string> found, foreign;
  collectIncludes("accel/shapes/sampling/sampling.h", found, foreign);
  EXPECT_GT(found.size(), 25u);
  for (const std::string& path : found) {
    EXPECT_TRUE(path.starts_with("core/") || path.starts_with("accel/shapes/")) << path;
    for (const char* scene : {"description", "camera", "film", "image", "display", "cluster", "shape_at"}) {
      EXPECT_EQ(path.find(scene), path.npos) << path;
    }
  }
  for (const std::string& name : foreign) {
    // Nothing but the standard library, and Imath for matrices.
    EXPECT_TRUE(name.find('/') == name.npos || name.starts_with("Imath/")) << name;
    EXPECT_EQ(name.find("rtcore"), name.npos) << name;
  }
  // The check itself works: it finds the scene in a header that includes one.
  std::set<std::string> other;
  collectIncludes("accel/shapes/primitives/shape_at.h", other, foreign);
  EXPECT_EQ(other.count("core/scene/description.h"), 1u);
}

// --- Far from usual sizes ---------------------------------------------------------------------------------------

/// A sample is finite and of unit length with a positive float as density, or it is no sample; densities and inverses
/// of it and of other directions are in range.
template <class S>
void expectNothingBreaks(const S& shape, Vec3f from, const std::string& where) {
  static const std::vector<Vec2f> points = unitPoints(20);
  for (const Vec2f u : points) {
    const DirectionSample<float> s = sampleDirection(shape, from, u);
    ASSERT_TRUE(s.pdf >= 0.0f && isFinite(s.pdf)) << where << ": pdf " << s.pdf << " at " << u.x << ", " << u.y;
    ASSERT_NEAR(length(s.wi), 1.0, 1e-5) << where << " at " << u.x << ", " << u.y;
    ASSERT_TRUE(isFinite(s.distance) && s.distance >= 0.0f) << where << ": distance " << s.distance;
    for (const Vec3f w : {s.wi, -s.wi, UniformSphere<float>::sample(u)}) {
      const float pdf = pdfDirection(shape, from, w);
      ASSERT_TRUE(pdf >= 0.0f && isFinite(pdf)) << where << ": pdf() " << pdf << " at " << u.x << ", " << u.y;
    }
    if (s.pdf > 0.0f) {
      const Vec2f back = invertDirection(shape, from, s.wi);
      ASSERT_TRUE(back.x >= 0.0f && back.x < 1.0f && back.y >= 0.0f && back.y < 1.0f)
          << where << ": inverse " << back.x << ", " << back.y << " at " << u.x << ", " << u.y;
    }
  }
}

/// Scales of scenes, for all of which the tests below run.
constexpr std::array<float, 5> kScales{1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f};
/// Distances from a surface in units of the shape: on it, next to it, far from it.
constexpr std::array<float, 9> kGaps{0.0f, 1e-7f, -1e-7f, 1e-5f, 1e-3f, -0.3f, 1.0f, 1e4f, 1e8f};

TEST(Sampling, SpheresOfAllSizesNeverBreak) {
  const Vec3f towards = normalize(Vec3f{0.3f, -0.5f, 0.2f});
  for (const float radius : {1e-12f, 1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f, 1e12f}) {
    for (const float gap : kGaps) {
      const std::string where = "radius " + std::to_string(radius) + ", gap " + std::to_string(gap);
      expectNothingBreaks(Sphere<float>{{}, radius}, towards * (radius * (1.0f + gap)), where);
      // Away from the origin, where the place of the surface is rounded.
      const Vec3f center{3.0f * radius, -20.0f * radius, 7.0f * radius};
      expectNothingBreaks(Sphere<float>{center, radius}, center + towards * (radius * (1.0f + gap)), where);
    }
    expectNothingBreaks(Sphere<float>{{}, radius}, {}, "the centre");
  }
}

TEST(Sampling, FlatShapesOfAllSizesNeverBreak) {
  for (const float scale : kScales) {
    for (const float aspect : {1.0f, 1e-3f, 1e-6f}) {
      const Frame<float> axes = Frame<float>::fromZ(normalize(Vec3f{0.2f, -0.7f, 0.4f}));
      const Vec3f u = axes.x * scale, v = axes.y * (scale * aspect), corner = axes.z * (2.0f * scale);
      const Quad<float> quad{corner, u, v}, skew{corner, u, v + u * 0.7f};
      const Triangle<float> triangle{corner, corner + u, corner + v + u * 0.3f};
      const Disk<float> disk{corner, axes.z, scale * aspect};
      // Above the middle, an edge, a corner and beside: what grazes is seen there.
      for (const Vec2f place : {Vec2f{0.4f, 0.3f}, Vec2f{0.5f, 0.0f}, Vec2f{0.0f, 0.0f}, Vec2f{2.0f, 0.5f}}) {
        for (const float gap : kGaps) {
          const std::string where =
              "scale " + std::to_string(scale) + ", aspect " + std::to_string(aspect) + ", gap " + std::to_string(gap);
          const Vec3f from = corner + u * place.x + v * place.y + axes.z * (gap * scale);
          expectNothingBreaks(quad, from, "quad, " + where);
          expectNothingBreaks(skew, from, "skew quad, " + where);
          expectNothingBreaks(triangle, from, "triangle, " + where);
          expectNothingBreaks(disk, from, "disk, " + where);
        }
      }
    }
  }
}

TEST(Sampling, BoxesOfAllSizesNeverBreak) {
  for (const float scale : kScales) {
    for (const float aspect : {1.0f, 1e-3f, 1e-6f}) {
      const Frame<float> axes = Frame<float>::fromZ(normalize(Vec3f{0.2f, -0.7f, 0.4f}));
      const Box<float> box{{scale, -2.0f * scale, 0.0f}, {scale, scale * aspect, 0.3f * scale}, axes};
      for (const Vec3f place : {Vec3f{0.4f, 1.0f, 0.3f}, Vec3f{1.0f, 1.0f, 0.0f}, Vec3f{1.0f, 1.0f, 1.0f},
                                Vec3f{0.0f, 0.0f, 1.0f}, Vec3f{0.0f, 0.0f, 0.0f}}) {
        for (const float gap : kGaps) {
          const Vec3f from = box.center + axes.toWorld(place * box.half * (1.0f + gap));
          expectNothingBreaks(
              box, from,
              "scale " + std::to_string(scale) + ", aspect " + std::to_string(aspect) + ", gap " + std::to_string(gap));
        }
      }
    }
  }
}

}  // namespace
}  // namespace steradian::test
