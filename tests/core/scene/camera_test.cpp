#include "steradian/core/scene/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "steradian/core/samplers/rng.h"

namespace steradian {
namespace {

constexpr int kWidth = 60, kHeight = 40;
constexpr float kDegree = 3.14159265f / 180.0f;

Ray<float> rayThrough(const Camera& camera, float x, float y, Vec2f lens = {0.5f, 0.5f}) {
  return camera.ray(CameraSample<float>{{x, y}, lens, 0.25f});
}

void expectNear(Vec3f a, Vec3f b, float tolerance) {
  EXPECT_LE(length(a - b), tolerance) << "(" << a.x << ", " << a.y << ", " << a.z << ") instead of (" << b.x << ", "
                                      << b.y << ", " << b.z << ")";
}

/// The image position of a world point by the matrix of the file, in pixels.
Vec2f project(const Matrix& worldToNdc, Vec3f p) {
  Imath::V3f ndc;
  worldToNdc.multVecMatrix(toImath(p), ndc);
  return {0.5f * (ndc.x + 1.0f) * kWidth, 0.5f * (1.0f - ndc.y) * kHeight};
}

PerspectiveCamera tilted() {
  return {.lookFrom = {13.0f, 2.0f, 3.0f},
          .lookAt = {0.0f, 0.5f, -1.0f},
          .up = {0.1f, 2.0f, 0.2f},
          .verticalFov = 30.0f,
          .defocusAngle = 5.0f,
          .focusDistance = 10.0f};
}

TEST(Camera, LooksAlongMinusZWithXToTheRightAndYUp) {
  const Camera camera(PerspectiveCamera{.verticalFov = 90.0f}, kWidth, kHeight);
  expectNear(rayThrough(camera, 30.0f, 20.0f).direction, {0.0f, 0.0f, -1.0f}, 1e-6f);
  // The corners of the plane at distance 1: half height tan 45 degrees, half width 1.5 of it.
  expectNear(rayThrough(camera, 0.0f, 0.0f).direction, normalize(Vec3f{-1.5f, 1.0f, -1.0f}), 1e-6f);
  expectNear(rayThrough(camera, 60.0f, 0.0f).direction, normalize(Vec3f{1.5f, 1.0f, -1.0f}), 1e-6f);
  expectNear(rayThrough(camera, 0.0f, 40.0f).direction, normalize(Vec3f{-1.5f, -1.0f, -1.0f}), 1e-6f);
  expectNear(rayThrough(camera, 60.0f, 40.0f).direction, normalize(Vec3f{1.5f, -1.0f, -1.0f}), 1e-6f);
}

TEST(Camera, RightIsUpCrossBackAsInTheBooks) {
  // The Cornell box: from z = -800 towards +z, x runs to the left of the picture.
  const Camera camera(
      PerspectiveCamera{.lookFrom = {278.0f, 278.0f, -800.0f}, .lookAt = {278.0f, 278.0f, 0.0f}, .verticalFov = 40.0f},
      600, 600);
  const Ray<float> right = camera.ray(CameraSample<float>{{600.0f, 300.0f}, {}, 0.0f});
  EXPECT_LT(right.direction.x, -0.3f);
  EXPECT_NEAR(right.direction.x / right.direction.z, -std::tan(20.0f * kDegree), 1e-6f);
  expectNear(right.origin, {278.0f, 278.0f, -800.0f}, 0.0f);
}

TEST(Camera, VerticalFieldOfViewSpansTheHeight) {
  const Camera camera(tilted(), kWidth, kHeight);
  const Vec3f top = rayThrough(camera, 30.0f, 0.0f).direction, bottom = rayThrough(camera, 30.0f, 40.0f).direction;
  EXPECT_NEAR(std::acos(dot(top, bottom)), 30.0f * kDegree, 1e-5f);
  const Vec3f left = rayThrough(camera, 0.0f, 20.0f).direction, right = rayThrough(camera, 60.0f, 20.0f).direction;
  EXPECT_NEAR(std::acos(dot(left, right)), 2.0f * std::atan(1.5f * std::tan(15.0f * kDegree)), 1e-5f);
}

TEST(Camera, AllLensRaysOfAFilmPointMeetInThePlaneOfFocus) {
  const PerspectiveCamera description = tilted();
  const Camera camera(description, kWidth, kHeight);
  const Vec3f forward = normalize(description.lookAt - description.lookFrom);
  const float radius = 10.0f * std::tan(2.5f * kDegree);
  RandomStream random(1, 2, 3, 4);
  for (const Vec2f film : {Vec2f{0.0f, 0.0f}, Vec2f{33.5f, 12.25f}, Vec2f{60.0f, 40.0f}}) {
    const auto inFocus = [&](const Ray<float>& r) {
      return r.at((10.0f - dot(r.origin - description.lookFrom, forward)) / dot(r.direction, forward));
    };
    const Vec3f focus = inFocus(rayThrough(camera, film.x, film.y));
    float farthest = 0.0f;
    for (int i = 0; i < 1000; ++i) {
      const float u = random.next(), v = random.next();
      const Ray<float> r = rayThrough(camera, film.x, film.y, {u, v});
      const Vec3f onLens = r.origin - description.lookFrom;
      expectNear(inFocus(r), focus, 2e-5f);
      EXPECT_NEAR(dot(onLens, forward), 0.0f, 2e-6f);
      EXPECT_NEAR(length(r.direction), 1.0f, 1e-6f);
      farthest = std::max(farthest, length(onLens));
    }
    EXPECT_LE(farthest, radius * 1.00001f);
    EXPECT_GE(farthest, radius * 0.98f);
  }
}

TEST(Camera, APinholeIgnoresTheLensAndTheFocusDistance) {
  PerspectiveCamera near = tilted(), far = tilted();
  near.defocusAngle = far.defocusAngle = 0.0f;
  far.focusDistance = 1e30f;
  const Ray<float> a = rayThrough(Camera(near, kWidth, kHeight), 7.0f, 5.0f, {0.1f, 0.9f});
  const Ray<float> b = rayThrough(Camera(far, kWidth, kHeight), 7.0f, 5.0f, {0.7f, 0.2f});
  expectNear(a.direction, b.direction, 0.0f);
  expectNear(a.origin, near.lookFrom, 0.0f);
  expectNear(b.origin, near.lookFrom, 0.0f);
}

TEST(Camera, OrthographicRaysAreParallel) {
  const Camera camera(OrthographicCamera{.lookFrom = {1.0f, 2.0f, 3.0f}, .lookAt = {1.0f, 2.0f, -7.0f}, .height = 8.0f},
                      kWidth, kHeight);
  for (const float x : {0.0f, 10.5f, 60.0f}) {
    for (const float y : {0.0f, 7.25f, 40.0f}) {
      const Ray<float> r = rayThrough(camera, x, y);
      expectNear(r.direction, {0.0f, 0.0f, -1.0f}, 0.0f);
      expectNear(r.origin, {1.0f + (x / kWidth - 0.5f) * 12.0f, 2.0f - (y / kHeight - 0.5f) * 8.0f, 3.0f}, 2e-6f);
    }
  }
}

TEST(Camera, SphericalHasLookAtInTheMiddleAndUpAtTheTop) {
  const Camera camera(SphericalCamera{}, kWidth, kHeight);
  expectNear(rayThrough(camera, 30.0f, 20.0f).direction, {0.0f, 0.0f, -1.0f}, 1e-6f);
  expectNear(rayThrough(camera, 45.0f, 20.0f).direction, {1.0f, 0.0f, 0.0f}, 1e-6f);
  expectNear(rayThrough(camera, 15.0f, 20.0f).direction, {-1.0f, 0.0f, 0.0f}, 1e-6f);
  expectNear(rayThrough(camera, 0.0f, 20.0f).direction, {0.0f, 0.0f, 1.0f}, 1e-6f);
  expectNear(rayThrough(camera, 11.0f, 0.0f).direction, {0.0f, 1.0f, 0.0f}, 1e-6f);
  expectNear(rayThrough(camera, 11.0f, 40.0f).direction, {0.0f, -1.0f, 0.0f}, 1e-6f);
}

/// Solid angle of the triangle of three unit vectors (Van Oosterom & Strackee 1983).
double solidAngle(Vec3f a, Vec3f b, Vec3f c) {
  const double numerator = std::abs(static_cast<double>(dot(a, cross(b, c))));
  return 2.0 * std::atan2(numerator, 1.0 + dot(a, b) + dot(b, c) + dot(c, a));
}

TEST(Camera, SphericalPixelsCoverTheSphereOnce) {
  const Camera camera(SphericalCamera{.lookFrom = {5.0f, 1.0f, 0.0f}, .lookAt = {1.0f, -2.0f, 3.0f}}, kWidth, kHeight);
  const auto direction = [&](int x, int y) {
    return rayThrough(camera, static_cast<float>(x), static_cast<float>(y)).direction;
  };
  double total = 0.0;
  for (int y = 0; y < kHeight; ++y) {
    const double top = std::cos(3.14159265358979 * y / kHeight),
                 bottom = std::cos(3.14159265358979 * (y + 1) / kHeight);
    const double expected = 2.0 * 3.14159265358979 / kWidth * (top - bottom);
    for (int x = 0; x < kWidth; x += 7) {
      const Vec3f a = direction(x, y), b = direction(x + 1, y), c = direction(x + 1, y + 1), d = direction(x, y + 1);
      // Great circles in place of circles of latitude: a difference of at most (pi / kWidth)^2 of the pixel.
      EXPECT_NEAR(solidAngle(a, b, c) + solidAngle(a, c, d), expected, 0.006 * expected) << x << " " << y;
    }
    for (int x = 0; x < kWidth; ++x) {
      const Vec3f a = direction(x, y), b = direction(x + 1, y), c = direction(x + 1, y + 1), d = direction(x, y + 1);
      total += solidAngle(a, b, c) + solidAngle(a, c, d);
    }
  }
  EXPECT_NEAR(total, 4.0 * 3.14159265358979, 1e-3);
}

TEST(Camera, MatricesProjectEveryRayBackToItsPixel) {
  PerspectiveCamera pinhole = tilted();
  pinhole.defocusAngle = 0.0f;
  const OrthographicCamera parallel{
      .lookFrom = {3.0f, 4.0f, 5.0f}, .lookAt = {0.0f, 1.0f, 1.0f}, .up = {1.0f, 1.0f, 0.0f}, .height = 6.0f};
  for (const CameraDescription& description : {CameraDescription(pinhole), CameraDescription(parallel)}) {
    const Camera camera(description, kWidth, kHeight);
    ASSERT_TRUE(camera.worldToNdc());
    for (const float x : {0.5f, 17.0f, 59.5f}) {
      for (const float y : {0.5f, 23.0f, 39.5f}) {
        const Vec3f point = rayThrough(camera, x, y).at(7.0f);
        const Vec2f pixel = project(*camera.worldToNdc(), point);
        EXPECT_NEAR(pixel.x, x, 1e-3f);
        EXPECT_NEAR(pixel.y, y, 1e-3f);
        const Vec3f inCamera = transformPoint(camera.worldToCamera(), point);
        EXPECT_GT(inCamera.z, 0.0f);
        EXPECT_EQ(inCamera.x > 0.0f, x > 30.0f);
        EXPECT_EQ(inCamera.y > 0.0f, y < 20.0f);
      }
    }
  }
  EXPECT_FALSE(Camera(SphericalCamera{}, kWidth, kHeight).worldToNdc());
}

TEST(Camera, OneLaneAndEightGiveTheSameBits) {
  const std::vector<CameraDescription> descriptions{tilted(), OrthographicCamera{.lookFrom = {1.0f, 2.0f, 3.0f}},
                                                    SphericalCamera{.lookFrom = {1.0f, 2.0f, 3.0f}}};
  RandomStream random(5, 6, 7, 8);
  for (const CameraDescription& description : descriptions) {
    const Camera camera(description, kWidth, kHeight);
    for (int round = 0; round < 50; ++round) {
      CameraSample<Lanes<8>> wide;
      for (int i = 0; i < 8; ++i) {
        setLane(wide.film, i, {random.next() * kWidth, random.next() * kHeight});
        setLane(wide.lens, i, {random.next(), random.next()});
        setLane(wide.time, i, random.next());
      }
      const Ray<Lanes<8>> rays = camera.ray(wide);
      for (int i = 0; i < 8; ++i) {
        const Ray<float> r =
            camera.ray(CameraSample<float>{lane(wide.film, i), lane(wide.lens, i), lane(wide.time, i)});
        expectNear(lane(rays.origin, i), r.origin, 0.0f);
        expectNear(lane(rays.direction, i), r.direction, 0.0f);
        EXPECT_EQ(lane(rays.time, i), r.time);
        EXPECT_EQ(lane(rays.tMin, i), 0.0f);
        EXPECT_EQ(lane(rays.tMax, i), kInfinity);
      }
    }
  }
}

TEST(Camera, StaysExactFarFromTheOrigin) {
  PerspectiveCamera far = tilted(), home = tilted();
  const Vec3f offset{1048576.0f, -2097152.0f, 524288.0f};
  far.lookFrom += offset;
  far.lookAt += offset;
  far.lookAt.y = far.lookFrom.y - 1.5f;
  home.lookAt.y = home.lookFrom.y - 1.5f;
  expectNear(rayThrough(Camera(far, kWidth, kHeight), 3.0f, 4.0f).direction,
             rayThrough(Camera(home, kWidth, kHeight), 3.0f, 4.0f).direction, 1e-6f);
}

std::string messageOf(const CameraDescription& description, int width = kWidth, int height = kHeight) {
  try {
    const Camera camera(description, width, height);
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

TEST(Camera, NamesEverythingThatIsWrong) {
  PerspectiveCamera bad;
  bad.lookAt = bad.lookFrom;
  bad.up = {};
  bad.verticalFov = 180.0f;
  bad.defocusAngle = -1.0f;
  bad.focusDistance = 0.0f;
  const std::string message = messageOf(bad);
  for (const char* part : {"same point", "up is zero", "field of view", "defocus angle", "focus distance"}) {
    EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
  }
  EXPECT_EQ(validate(CameraDescription(bad)).errorCount(), 5u);
  EXPECT_EQ(messageOf(PerspectiveCamera{}), "");
}

TEST(Camera, RefusesDegenerateInput) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(messageOf(SphericalCamera{.up = {0.0f, 0.0f, 3.0f}}).find("parallel"), std::string::npos);
  EXPECT_NE(messageOf(SphericalCamera{.lookFrom = {nan, 0.0f, 0.0f}}).find("not finite"), std::string::npos);
  EXPECT_NE(messageOf(SphericalCamera{.lookAt = {0.0f, kInfinity, 0.0f}}).find("not finite"), std::string::npos);
  EXPECT_NE(messageOf(SphericalCamera{.up = {0.0f, nan, 0.0f}}).find("not finite"), std::string::npos);
  for (const float fov : {0.0f, -3.0f, 180.0f, nan, kInfinity}) {
    EXPECT_NE(messageOf(PerspectiveCamera{.verticalFov = fov}).find("field of view"), std::string::npos) << fov;
  }
  for (const float height : {0.0f, -3.0f, nan, kInfinity}) {
    EXPECT_NE(messageOf(OrthographicCamera{.height = height}).find("height"), std::string::npos) << height;
  }
  EXPECT_NE(messageOf(PerspectiveCamera{}, 0, 5).find("0 x 5"), std::string::npos);
  EXPECT_NE(messageOf(PerspectiveCamera{}, 5, -1).find("5 x -1"), std::string::npos);
}

}  // namespace
}  // namespace steradian
