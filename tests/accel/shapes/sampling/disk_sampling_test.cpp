#include "steradian/accel/shapes/sampling/disk_sampling.h"

#include "steradian/tests/accel/shapes/target_check.h"

namespace steradian::test {
namespace {

const Disk<float> kDisk{{1.0f, 2.0f, 3.0f}, {0.6f, 0.0f, 0.8f}, 0.5f};

TEST(DiskSampling, PositionsLieOnTheDisk) {
  EXPECT_FLOAT_EQ(area(kDisk), 0.78539816f);
  for (const Vec2f u : unitPoints(100)) {
    const PositionSample<float> p = samplePosition(kDisk, u);
    EXPECT_LE(length(p.position - kDisk.center), 0.5f + 1e-6f);
    EXPECT_NEAR(dot(p.position - kDisk.center, kDisk.normal), 0.0, 1e-6);
    EXPECT_FLOAT_EQ(p.pdf, 1.2732395f);
    EXPECT_EQ(p.pdf, pdfPosition(kDisk));
    EXPECT_EQ(dot(p.normal, normalAt(kDisk, p.position)), dot(kDisk.normal, kDisk.normal));
  }
}

TEST(DiskSampling, SamplesAreSound) {
  for (const float side : {1.0f, -1.0f}) {
    for (const float distance : {5000.0f, 50.0f, 2.0f, 0.1f, 0.01f}) {
      expectSoundTarget(kDisk, kDisk.center + kDisk.normal * (side * distance), {.pdfTolerance = 1e-3});
    }
  }
  const Vec3f grazing = kDisk.center + Vec3f{0.8f, 0.0f, -0.6f} * 2.0f + kDisk.normal * 0.02f;
  expectSoundTarget(kDisk, grazing, {.pdfTolerance = 0.01});
}

TEST(DiskSampling, NothingIsSeenFromItsPlane) {
  const Disk<float> disk{{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, 1.0f};
  for (const Vec3f from : {Vec3f{2.0f, 0.0f, 0.0f}, Vec3f{0.2f, 0.3f, 0.0f}, Vec3f{0.0f, 0.0f, 0.0f}}) {
    expectSoundTarget(disk, from, {.noSample = -1.0});
    EXPECT_EQ(sampleDirection(disk, from, {0.3f, 0.6f}).pdf, 0.0f);
    EXPECT_EQ(pdfDirection(disk, from, {1.0f, 0.0f, 0.0f}), 0.0f);
    EXPECT_EQ(pdfDirection(disk, from, {0.0f, 0.0f, 1.0f}), 0.0f);
  }
}

TEST(DiskSampling, NoDensityIsInfinite) {
  // So close to the plane, the density of a direction is beyond the floats; infinity would mean a Dirac sample.
  const Disk<float> disk{{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, 1.0f};
  for (const float height : {1e-37f, 1e-39f, -1e-44f}) {
    for (const Vec2f u : unitPoints(20)) {
      const DirectionSample<float> s = sampleDirection(disk, {3.0f, 0.0f, height}, u);
      EXPECT_TRUE(isFinite(s.pdf + s.wi.x + s.wi.z + s.distance)) << height;
      EXPECT_TRUE(isFinite(pdfDirection(disk, {3.0f, 0.0f, height}, s.wi))) << height;
    }
  }
}

TEST(DiskSampling, DensityByArea) {
  const Disk<float> disk{{0.0f, 0.0f, 2.0f}, {0.0f, 0.0f, -1.0f}, 0.5f};
  EXPECT_FLOAT_EQ(pdfDirection(disk, {}, {0.0f, 0.0f, 1.0f}), 4.0f / 0.78539816f);
  EXPECT_EQ(pdfDirection(disk, {}, {0.0f, 0.0f, -1.0f}), 0.0f);
  EXPECT_EQ(pdfDirection(disk, {}, normalize(Vec3f{0.51f, 0.0f, 2.0f})), 0.0f);
  const Vec3f wi = normalize(Vec3f{0.49f, 0.0f, 2.0f});
  EXPECT_NEAR(pdfDirection(disk, {}, wi), 4.2401f / (0.78539816f * wi.z), 1e-4);
}

TEST(DiskSampling, IrradianceOfACoaxialDisk) {
  for (const float side : {1.0f, -1.0f}) {
    const Disk<float> disk{{0.0f, 2.0f, 0.0f}, {0.0f, side, 0.0f}, 0.5f};
    EXPECT_NEAR(irradiance(disk, {}, {0.0f, 1.0f, 0.0f}), 0.184800, 2e-6);
  }
}

TEST(DiskSampling, SameAtAllWidths) {
  expectSameAtAllWidths<Disk>([](std::uint32_t i) {
    return Disk<float>{randomVector(i, 1) * 10.0f, normalize(randomVector(i, 2)), 0.01f + 10.0f * randomFloat(i, 20)};
  });
}

}  // namespace
}  // namespace steradian::test
