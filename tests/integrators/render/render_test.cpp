#include "steradian/integrators/render/render.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <set>
#include <thread>

#include "steradian/integrators/auxiliary/aov.h"
#include "steradian/integrators/path/path.h"
#include "steradian/tests/integrators/small_scenes.h"

namespace steradian {
namespace {

using test::settingsOf;

/// Glass, a coat, a rotated box and two kinds of light: everything that might depend on the order of work.
const Scene& busyRoom() {
  static const Scene scene([] {
    SceneDescription s = test::room();
    test::addSphere(s, {-0.4f, -0.6f, 0.2f}, 0.4f, s.addMaterial("glass", DielectricMaterial{1.5f, false}));
    const Id brown = s.addColour({0.5f, 0.3f, 0.1f});
    test::addBox(s, {0.45f, -0.5f, -0.3f}, {0.25f, 0.5f, 0.25f}, 20.0f,
                 s.addMaterial("coat", CoatedMaterial{brown, 1.5f}));
    s.addLight("bulb", PointLight{{0.0f, 0.2f, 0.8f}, grey(0.3f)});
    return s;
  }());
  return scene;
}

/// Every channel of the picture, bit for bit.
std::vector<std::uint32_t> bitsOfPicture(const Film& film) {
  const Image image = film.image();
  std::vector<std::uint32_t> bits;
  for (const float value : image.values()) bits.push_back(bitsOf(value));
  return bits;
}

Film renderWith(const RenderSettings& settings, int threads = 2) {
  tbb::task_arena arena(threads);
  return arena.execute([&] { return render(busyRoom(), PathIntegrator(), settings).film; });
}

TEST(Render, TheSameBitsForAnyNumberOfThreads) {
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 8);  // also on smaller machines
  const RenderSettings settings = settingsOf(31, 23, 6);
  const auto expected = bitsOfPicture(renderWith(settings, 1));
  for (const int threads : {2, 3, 8}) EXPECT_EQ(bitsOfPicture(renderWith(settings, threads)), expected) << threads;
}

TEST(Render, TheSameBitsForAnyTileSize) {
  RenderSettings settings = settingsOf(31, 23, 6);
  const auto expected = bitsOfPicture(renderWith(settings));
  for (const int size : {1, 7, 64}) {
    settings.tileSize = size;
    EXPECT_EQ(bitsOfPicture(renderWith(settings)), expected) << size;
  }
}

TEST(Render, ACropIsAPartOfTheFullPicture) {
  RenderSettings settings = settingsOf(31, 23, 6);
  const Film full = renderWith(settings);
  settings.crop = Crop{5, 17, 3, 20};
  const Film crop = renderWith(settings);
  for (int y = 3; y < 20; ++y) {
    for (int x = 5; x < 17; ++x) {
      EXPECT_EQ(bitsOf(crop.radiance(x, y).g), bitsOf(full.radiance(x, y).g)) << x << ' ' << y;
    }
  }
  const Image image = crop.image();
  EXPECT_EQ(image.width(), 12);
  EXPECT_EQ(image.window(), (ImageWindow{5, 3, 31, 23}));
}

TEST(Render, RangesOfSamplesAddUpToTheWhole) {
  const Film whole = renderWith(settingsOf(31, 23, 11));
  RenderSettings settings = settingsOf(31, 23, 4);
  Film sum = renderWith(settings);
  settings.firstSample = 4;
  settings.samplesPerPixel = 7;
  sum.merge(renderWith(settings));
  EXPECT_EQ(bitsOfPicture(sum), bitsOfPicture(whole));
  EXPECT_EQ(sum.ledger(), whole.ledger());
  EXPECT_EQ(whole.ledger().text(), "0:0-10");
}

TEST(Render, SizeAndSamplesComeFromTheSceneUnlessGiven) {
  SceneDescription description = test::floorPoint();
  description.defaults = {.width = 8, .height = 4, .samplesPerPixel = 3, .maxDepth = 1};
  const Scene scene(std::move(description));
  const RenderResult byScene = render(scene, PathIntegrator());
  EXPECT_EQ(byScene.film.settings().width, 8);
  EXPECT_EQ(byScene.film.settings().height, 4);
  EXPECT_EQ(byScene.film.sampleCount(0, 0), 3u);
  RenderSettings settings;
  settings.width = 4;
  EXPECT_EQ(render(scene, PathIntegrator(), settings).film.settings().height, 2);
}

TEST(Render, RefusesWhatMakesNoSense) {
  const auto kindOf = [](auto change) {
    RenderSettings settings = settingsOf(8, 8, 1);
    change(settings);
    try {
      render(busyRoom(), PathIntegrator(), settings);
    } catch (const Error& error) {
      return error.kind();
    }
    return ErrorKind::Other;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(kindOf([](auto&) {}), ErrorKind::Other);
  EXPECT_EQ(kindOf([](auto& s) { s.width = 0; }), ErrorKind::Usage);
  EXPECT_EQ(kindOf([](auto& s) { s.height = -5; }), ErrorKind::Usage);
  EXPECT_EQ(kindOf([](auto& s) { s.width = 5, s.height = 1 << 30; }), ErrorKind::Usage);
  EXPECT_EQ(kindOf([](auto& s) { s.samplesPerPixel = 0; }), ErrorKind::Usage);
  EXPECT_EQ(kindOf([](auto& s) { s.tileSize = 0; }), ErrorKind::Usage);
  EXPECT_EQ(kindOf([](auto& s) { s.execution.width = 5; }), ErrorKind::Usage);
  for (const Isa isa : {Isa::Baseline, Isa::Avx2, Isa::Avx512}) {
    const ErrorKind expected = isUsable(isa) ? ErrorKind::Other : ErrorKind::Usage;
    EXPECT_EQ(kindOf([&](auto& s) { s.execution.isa = isa; }), expected) << nameOf(isa);
  }
  EXPECT_EQ(kindOf([&](auto& s) { s.timeLimit = nan; }), ErrorKind::Usage);
  EXPECT_EQ(kindOf([](auto& s) { s.timeLimit = -1.0; }), ErrorKind::Usage);
  EXPECT_EQ(kindOf([](auto& s) { s.replicates = 0; }), ErrorKind::Usage);
  EXPECT_EQ(kindOf([](auto& s) { s.crop = Crop{0, 9, 0, 8}; }), ErrorKind::Usage);
  EXPECT_EQ(kindOf([](auto& s) { s.firstSample = 0xffffffffu; }), ErrorKind::Usage);
  for (const SamplerType type : kSamplerTypes) {
    const ErrorKind refused = needsSampleCount(type) ? ErrorKind::Usage : ErrorKind::Other;
    EXPECT_EQ(kindOf([&](auto& s) { s.sampler = type, s.timeLimit = 0.001, s.samplesPerPixel = std::nullopt; }),
              refused);
    EXPECT_EQ(kindOf([&](auto& s) { s.sampler = type, s.firstSample = 5; }), refused);
    EXPECT_EQ(kindOf([&](auto& s) { s.sampler = type, s.timeLimit = 0.001; }), ErrorKind::Other);
  }
  EXPECT_TRUE(needsSampleCount(SamplerType::Stratified) && needsSampleCount(SamplerType::BlueNoise));
  EXPECT_FALSE(needsSampleCount(SamplerType::Sobol));
}

TEST(Render, ProgressNeverFallsAndEndsAtOne) {
  double last = 0.0;
  std::atomic<int> inside = 0;
  bool monotone = true, alone = true;
  const RenderResult result =
      render(busyRoom(), PathIntegrator(), settingsOf(40, 40, 5), {}, [&](const RenderProgress& progress) {
        alone = alone && ++inside == 1;
        monotone = monotone && progress.fraction >= last;
        last = progress.fraction;
        --inside;
      });
  EXPECT_TRUE(monotone);
  EXPECT_TRUE(alone);
  EXPECT_EQ(last, 1.0);
  EXPECT_FALSE(result.stopped);
  EXPECT_EQ(result.statistics.samples, 40u * 40u * 5u);
}

TEST(Render, AStopKeepsWholePassesOfWholeTiles) {
  std::stop_source source;
  const RenderSettings settings = settingsOf(48, 32, 1000);
  const RenderResult stopped =
      render(busyRoom(), PathIntegrator(), settings, source.get_token(), [&](const RenderProgress& p) {
        if (p.samples > 48 * 32 * 5) source.request_stop();
      });
  EXPECT_TRUE(stopped.stopped);
  EXPECT_EQ(stopped.film.sampleCount(), stopped.statistics.samples);
  std::set<std::uint32_t> counts;
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 48; ++x) counts.insert(stopped.film.sampleCount(x, y));
  }
  ASSERT_LE(counts.size(), 2u);
  EXPECT_EQ(*counts.begin(), stopped.film.ledger().completeCount());
  // Each pixel is the one that a render of so many samples has.
  for (const std::uint32_t count : counts) {
    const Film expected = renderWith(settingsOf(48, 32, count));
    for (int y = 0; y < 32; ++y) {
      for (int x = 0; x < 48; ++x) {
        if (stopped.film.sampleCount(x, y) != count) continue;
        ASSERT_EQ(bitsOf(stopped.film.radiance(x, y).r), bitsOf(expected.radiance(x, y).r)) << x << ' ' << y;
      }
    }
  }
}

TEST(Render, AStopBeforeTheStartGivesAnEmptyFilm) {
  std::stop_source source;
  source.request_stop();
  const RenderResult result = render(busyRoom(), PathIntegrator(), settingsOf(8, 8, 4), source.get_token());
  EXPECT_TRUE(result.stopped);
  EXPECT_EQ(result.film.sampleCount(), 0u);
  EXPECT_EQ(result.film.ledger().text(), "");
}

TEST(Render, WhatTheCallbackThrowsEndsTheRender) {
  EXPECT_THROW(render(busyRoom(), PathIntegrator(), settingsOf(32, 32, 4), {},
                      [](const RenderProgress&) { throw Error(ErrorKind::Other, "enough"); }),
               Error);
}

TEST(Render, ATimeLimitStopsAtWholePasses) {
  RenderSettings settings = settingsOf(16, 16, 1);
  settings.samplesPerPixel = std::nullopt;
  settings.timeLimit = 0.05;
  settings.replicates = 4;
  const RenderResult result = render(busyRoom(), PathIntegrator(), settings);
  EXPECT_FALSE(result.stopped);
  const std::uint32_t count = result.film.sampleCount(0, 0);
  EXPECT_GE(count, 4u);
  EXPECT_EQ(count % 4, 0u);
  EXPECT_EQ(result.film.sampleCount(), 256ull * count);
  EXPECT_EQ(result.film.ledger().completeCount(), count);
}

TEST(Render, SeveralRendersAtOnceInArenasOfTheirOwn) {
  const PathIntegrator integrator;
  const auto expectedA = bitsOfPicture(renderWith(settingsOf(24, 24, 8, 1), 1));
  const auto expectedB = bitsOfPicture(renderWith(settingsOf(20, 28, 8, 2), 1));
  std::vector<std::uint32_t> a, b;
  std::mutex mutex;
  std::set<std::thread::id> threads;
  const auto run = [&](const RenderSettings& settings, std::vector<std::uint32_t>& bits) {
    tbb::task_arena arena(1);
    arena.execute([&] {
      bits = bitsOfPicture(render(busyRoom(), integrator, settings, {}, [&](const RenderProgress&) {
                             const std::lock_guard lock(mutex);
                             threads.insert(std::this_thread::get_id());
                           }).film);
    });
  };
  std::thread first([&] { run(settingsOf(24, 24, 8, 1), a); });
  std::thread second([&] { run(settingsOf(20, 28, 8, 2), b); });
  const std::set<std::thread::id> own{first.get_id(), second.get_id()};
  first.join();
  second.join();
  EXPECT_EQ(a, expectedA);
  EXPECT_EQ(b, expectedB);
  EXPECT_EQ(threads, own);  // arenas of one thread: no other thread took part
}

/// One sample in eight of the left half is not a number or infinite.
class Faulty final : public RadianceIntegrator {
 public:
  Rgb radiance(const Scene&, const Ray<float>& ray, const Sampler<float>& sampler) const override {
    if (ray.direction.x > 0.0f || sampler.sample() % 8 != 3) return grey(0.5f);
    return sampler.pixel() % 2 == 0 ? grey(std::numeric_limits<float>::quiet_NaN()) : Rgb{1.0f, kInfinity, 1.0f};
  }
};

TEST(Render, NonFiniteSamplesAreDroppedAndCounted) {
  RenderSettings settings = settingsOf(16, 16, 16);
  const RenderResult result = render(busyRoom(), Faulty(), settings);
  EXPECT_EQ(result.statistics.samples, 16u * 16u * 16u);
  EXPECT_EQ(result.statistics.nonFiniteSamples, 2u * 8u * 16u);
  EXPECT_EQ(result.film.sampleCount(), 16u * 16u * 16u - 2u * 8u * 16u);
  EXPECT_EQ(result.film.radiance(0, 0).r, 0.5f);
  EXPECT_EQ(result.film.radiance(15, 0).r, 0.5f);
}

TEST(Render, StatisticsCountRaysAndPathLengths) {
  PathSettings settings;
  settings.strategy = Strategy::Light;
  settings.rouletteStrength = 0.0f;
  settings.maxDepth = 2;
  settings.lightSamples = 3;
  const Scene scene(test::furnace(0.5f, 1.0f));
  const RenderStatistics s = render(scene, PathIntegrator(settings), settingsOf(8, 8, 4)).statistics;
  EXPECT_EQ(s.paths.cameraRays, 256u);
  EXPECT_EQ(s.paths.bounceRays, 512u);
  EXPECT_EQ(s.paths.pathLengths[2], 256u);
  EXPECT_EQ(s.paths.pathLengths[1], 0u);
  // At most three per vertex; a light sample on the vertex's own wall needs none.
  EXPECT_LE(s.paths.shadowRays, 2u * 3u * 256u);
  EXPECT_GT(s.paths.shadowRays, 3u * 256u);
  EXPECT_GT(s.sampleSeconds, 0.0);
}

TEST(TilesOf, CoverTheCropOnce) {
  const Crop crop{3, 20, 5, 12};
  std::vector<int> hits(32 * 32, 0);
  for (const Crop& tile : tilesOf(crop, 8)) {
    // Of one square of the picture, wherever the crop begins.
    EXPECT_EQ(tile.x0 / 8, (tile.x1 - 1) / 8);
    EXPECT_EQ(tile.y0 / 8, (tile.y1 - 1) / 8);
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int x = tile.x0; x < tile.x1; ++x) ++hits[static_cast<std::size_t>(y) * 32 + static_cast<std::size_t>(x)];
    }
  }
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      ASSERT_EQ(hits[static_cast<std::size_t>(y * 32 + x)], crop.contains(x, y) ? 1 : 0) << x << ' ' << y;
    }
  }
}

}  // namespace
}  // namespace steradian
