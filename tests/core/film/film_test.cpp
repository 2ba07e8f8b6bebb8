#include "steradian/core/film/film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "steradian/core/base/diagnostics.h"
#include "steradian/core/samplers/rng.h"

namespace steradian {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr int kSide = 5;

FilmSettings small(std::uint32_t replicates = 1) { return {.width = kSide, .height = kSide, .replicates = replicates}; }

/// Sample i of a pixel: values of very different size, negative ones, misses, and some that are not finite.
PixelSample wildSample(int x, int y, std::uint32_t i) {
  RandomStream random(static_cast<std::uint32_t>(y * kSide + x), i, 1, 2);
  const auto value = [&](int range) {
    const float mantissa = random.next() - 0.2f;
    return std::ldexp(mantissa, static_cast<int>(random.next() * static_cast<float>(2 * range)) - range);
  };
  PixelSample s;
  s.radiance = {value(40), value(20), value(10)};
  s.alpha = random.next();
  s.albedo = {random.next(), random.next(), value(3)};
  s.normal = {random.next(), -random.next(), value(1)};
  s.depth = random.next() < 0.2f ? kInfinity : std::abs(value(36));
  if (random.next() < 0.01f) s.radiance.g = kNan;
  return s;
}

std::vector<PixelSample> wildRun(int x, int y, std::uint32_t first, std::uint32_t end) {
  std::vector<PixelSample> run;
  for (std::uint32_t i = first; i < end; ++i) run.push_back(wildSample(x, y, i));
  return run;
}

void addRange(Film& film, std::uint32_t first, std::uint32_t end) {
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) film.addSamples(x, y, first, wildRun(x, y, first, end));
  }
  film.ledger().add({0, first, end});
}

void expectSameBits(const Film& a, const Film& b) {
  const Image imageA = a.image(), imageB = b.image();
  ASSERT_EQ(imageA.values().size(), imageB.values().size());
  EXPECT_EQ(std::memcmp(imageA.values().data(), imageB.values().data(), imageA.values().size_bytes()), 0);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      EXPECT_EQ(a.luminanceEstimate(x, y).mean, b.luminanceEstimate(x, y).mean);
      EXPECT_EQ(a.luminanceEstimate(x, y).standardError, b.luminanceEstimate(x, y).standardError);
    }
  }
  EXPECT_EQ(a.dropped(), b.dropped());
  EXPECT_EQ(a.droppedCount(), b.droppedCount());
  EXPECT_EQ(a.ledger(), b.ledger());
}

TEST(Film, TheSameSamplesGiveTheSameBitsHoweverTheyAreCut) {
  constexpr std::uint32_t count = 200;
  for (const std::uint32_t replicates : {1u, 3u, 8u}) {
    Film whole(small(replicates));
    addRange(whole, 0, count);
    EXPECT_GT(whole.droppedCount(), 10u);
    RandomStream random(replicates, 2, 3, 4);
    for (int round = 0; round < 5; ++round) {
      Film cut(small(replicates));
      for (int pixel = kSide * kSide - 1; pixel >= 0; --pixel) {
        const int x = pixel % kSide, y = pixel / kSide;
        std::vector<std::uint32_t> cuts{0, count};
        for (int i = 0; i < 12; ++i) cuts.push_back(static_cast<std::uint32_t>(random.next() * count));
        std::sort(cuts.begin(), cuts.end());
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
          order.insert(order.begin() + static_cast<std::ptrdiff_t>(random.next() * static_cast<float>(i + 1)), i);
        }
        for (const std::size_t i : order) cut.addSamples(x, y, cuts[i], wildRun(x, y, cuts[i], cuts[i + 1]));
      }
      cut.ledger().add({0, 0, count});
      expectSameBits(cut, whole);
    }
  }
}

TEST(Film, ShardsMergeToTheSameBitsInAnyOrder) {
  Film whole(small());
  addRange(whole, 0, 130);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> shards{{0, 1}, {1, 37}, {37, 64}, {64, 101}, {101, 130}};
  for (int round = 0; round < 20; ++round) {
    Film total(small());
    for (const auto& [first, end] : shards) {
      Film shard(small());
      addRange(shard, first, end);
      total.merge(shard);
    }
    expectSameBits(total, whole);
    std::next_permutation(shards.begin(), shards.end());
  }
}

TEST(Film, ThreadsMayAddToDifferentPixels) {
  Film alone(small()), together(small());
  addRange(alone, 0, 64);
  std::vector<std::thread> threads;
  threads.reserve(kSide);
  for (int y = 0; y < kSide; ++y) {
    threads.emplace_back([&together, y] {
      for (int x = 0; x < kSide; ++x) together.addSamples(x, y, 0, wildRun(x, y, 0, 64));
    });
  }
  for (std::thread& t : threads) t.join();
  together.ledger().add({0, 0, 64});
  expectSameBits(together, alone);
}

TEST(Film, LongAndShortWaysGiveTheSameSums) {
  // One huge value excludes its whole run from the fast path; its own contribution is then subtracted from both sums.
  std::vector<PixelSample> run;
  for (std::uint32_t i = 0; i < 16; ++i) {
    run.push_back(wildSample(1, 1, i));
    run.back().radiance = {std::ldexp(1.0f + static_cast<float>(i), -60 + static_cast<int>(i) * 4), 0.1f, -3e-5f};
    run.back().depth = i % 3 == 0 ? kInfinity : 0.3f * static_cast<float>(i);
  }
  PixelSample huge;
  huge.radiance = {0x1p40f, 0.0f, 0.0f};
  huge.albedo.r = 0x1p20f;
  huge.depth = 0x1p40f;
  Film apart(small()), mixed(small());
  apart.addSamples(1, 1, 0, run);
  apart.addSamples(1, 1, 16, std::vector{huge});
  mixed.addSamples(1, 1, 0, std::span(run).first(8));
  std::vector<PixelSample> rest(run.begin() + 8, run.end());
  rest.push_back(huge);
  for (std::size_t i = 0; i < rest.size(); i += 3) {
    mixed.addSamples(1, 1, static_cast<std::uint32_t>(8 + i),
                     std::span(rest).subspan(i, std::min<std::size_t>(3, rest.size() - i)));
  }
  expectSameBits(mixed, apart);
}

TEST(Film, PixelsAreMeansOfTheirSamples) {
  Film film(small());
  std::vector<PixelSample> samples;
  for (int i = 0; i < 4; ++i) {
    const float f = static_cast<float>(i);
    samples.push_back({.radiance = {f, 2.0f * f, 4.0f},
                       .alpha = 1.0f,
                       .albedo = {0.25f, 0.5f, f},
                       .normal = {0, 1, -f},
                       .depth = 2.0f * f});
  }
  samples.push_back({.radiance = {9.0f, 4.0f, 4.0f}, .alpha = 0.0f});  // a miss
  film.addSamples(2, 3, 0, samples);
  const Image image = film.image();
  const auto at = [&](const char* channel) { return image.at(2, 3, image.channel(channel)); };
  EXPECT_FLOAT_EQ(at("R"), 3.0f);
  EXPECT_FLOAT_EQ(at("G"), 3.2f);
  EXPECT_FLOAT_EQ(at("B"), 4.0f);
  EXPECT_FLOAT_EQ(at("A"), 0.8f);
  EXPECT_FLOAT_EQ(at("Albedo.R"), 0.2f);
  EXPECT_FLOAT_EQ(at("Albedo.G"), 0.4f);
  EXPECT_FLOAT_EQ(at("Albedo.B"), 1.2f);
  EXPECT_FLOAT_EQ(at("N.X"), 0.0f);
  EXPECT_FLOAT_EQ(at("N.Y"), 0.8f);
  EXPECT_FLOAT_EQ(at("N.Z"), -1.2f);
  EXPECT_FLOAT_EQ(at("Z"), 3.0f);  // of the four hits
  EXPECT_EQ(at("Samples"), 5.0f);
  const MeanEstimate y = film.luminanceEstimate(2, 3);
  EXPECT_NEAR(y.mean, 0.2126 * 3.0 + 0.7152 * 3.2 + 0.0722 * 4.0, 1e-6);
  EXPECT_EQ(y.degreesOfFreedom, 4);
  EXPECT_FLOAT_EQ(at("StdErr.Y"), static_cast<float>(y.standardError));
  EXPECT_FLOAT_EQ(film.radiance(2, 3).g, 3.2f);
  EXPECT_EQ(film.sampleCount(2, 3), 5u);
  EXPECT_EQ(film.sampleCount(), 5u);
}

TEST(Film, APixelWithoutSamplesIsBlackAndOfUnknownError) {
  const Image image = Film(small()).image();
  for (const char* channel : {"R", "G", "B", "A", "N.X", "Albedo.R", "Samples"}) {
    EXPECT_EQ(image.at(0, 0, image.channel(channel)), 0.0f) << channel;
  }
  EXPECT_EQ(image.at(0, 0, image.channel("Z")), kInfinity);
  EXPECT_EQ(image.at(0, 0, image.channel("StdErr.Y")), kInfinity);
}

TEST(Film, OptionsChooseTheChannels) {
  const Film film(small());
  EXPECT_EQ(film.image().channelCount(), 13);
  EXPECT_EQ(film.image({.features = false, .errors = false}).channels(),
            (std::vector<std::string>{"R", "G", "B", "A"}));
  EXPECT_EQ(film.image({.features = false}).channels().back(), "Samples");
  EXPECT_EQ(film.image({.errors = false}).channels().back(), "Z");
}

TEST(Film, StoresItsCropOnly) {
  Film film({.width = 100, .height = 50, .crop = Crop{10, 13, 20, 22}});
  film.addSamples(12, 20, 0, std::vector{PixelSample{.radiance = {1.0f, 0.0f, 0.0f}}});
  const Image image = film.image();
  EXPECT_EQ(image.width(), 3);
  EXPECT_EQ(image.height(), 2);
  EXPECT_EQ(image.window(), (ImageWindow{10, 20, 100, 50}));
  EXPECT_EQ(image.at(2, 0, 0), 1.0f);
  EXPECT_EQ(image.at(1, 0, 0), 0.0f);
}

TEST(Film, DropsWhatIsNotFiniteAndRemembersTheFirst) {
  Film film(small());
  std::vector<PixelSample> bad(11);
  bad[0].radiance.r = kNan;
  bad[1].radiance.g = kInfinity;
  bad[2].radiance.b = -kInfinity;
  bad[3].alpha = kNan;
  bad[4].albedo.r = kNan;
  bad[5].albedo.b = kInfinity;
  bad[6].normal.x = kNan;
  bad[7].normal.z = kInfinity;
  bad[8].depth = kNan;
  bad[9].depth = -kInfinity;
  bad[10].radiance = {1.0f, 2.0f, 3.0f};  // the good one
  film.addSamples(4, 2, 100, bad);
  EXPECT_EQ(film.droppedCount(), 10u);
  EXPECT_EQ(film.sampleCount(4, 2), 1u);
  EXPECT_EQ(film.radiance(4, 2).g, 2.0f);
  // Earlier samples of other pixels come first, and no more than the capacity are kept.
  for (std::uint32_t i = 0; i < 3; ++i) film.addSamples(3, 1, 9 - 3 * i, std::span(bad).first(3));
  const std::vector<DroppedSample> dropped = film.dropped();
  EXPECT_EQ(film.droppedCount(), 19u);
  ASSERT_EQ(dropped.size(), Film::kRememberedDrops);
  EXPECT_EQ(dropped.front(), (DroppedSample{3, 3, 1}));
  EXPECT_EQ(dropped[9], (DroppedSample{100, 4, 2}));
  EXPECT_TRUE(std::is_sorted(dropped.begin(), dropped.end()));
}

TEST(Film, HugeSamplesAreKeptAndTheirErrorIsUnknown) {
  Film film(small());
  std::vector<PixelSample> samples(8, PixelSample{.radiance = {0x1p40f, 0x1p40f, 0x1p40f}});
  film.addSamples(0, 0, 0, samples);
  EXPECT_EQ(film.radiance(0, 0).r, 0x1p40f);
  const MeanEstimate y = film.luminanceEstimate(0, 0);
  EXPECT_FLOAT_EQ(static_cast<float>(y.mean), 0x1p40f);
  EXPECT_TRUE(std::isinf(y.standardError));
  EXPECT_EQ(y.degreesOfFreedom, 0);
}

TEST(Film, SubSequencesAreRunsThatGrowWithTheSequence) {
  std::vector<PixelSample> samples;
  for (int i = 0; i < 1000; ++i) {
    const float v = static_cast<float>(i * i % 17);
    samples.push_back({.radiance = {v, v, v}});
  }
  for (const std::size_t n : {1u, 5u, 8u, 9u, 16u, 17u, 64u, 100u, 1000u}) {
    const std::size_t run = n <= 8 ? 1 : std::bit_ceil(n) / 8;
    std::vector<double> sums(8);
    std::vector<std::uint32_t> counts(8);
    for (std::size_t i = 0; i < n; ++i) {
      sums[i / run] += samples[i].radiance.r;
      ++counts[i / run];
    }
    const MeanEstimate expected = meanFromGroups(sums, counts);
    Film film(small());  // the last sample first, then one by one
    film.addSamples(0, 0, static_cast<std::uint32_t>(n - 1), std::span(samples).subspan(n - 1, 1));
    for (std::size_t i = 0; i + 1 < n; ++i) {
      film.addSamples(0, 0, static_cast<std::uint32_t>(i), std::span(samples).subspan(i, 1));
    }
    const MeanEstimate y = film.luminanceEstimate(0, 0);
    EXPECT_EQ(y.degreesOfFreedom, expected.degreesOfFreedom) << n;
    EXPECT_NEAR(y.mean, expected.mean, 1e-5) << n;
    EXPECT_TRUE(n == 1 || std::abs(y.standardError - expected.standardError) < 1e-5) << n;
  }
}

TEST(Film, ReplicatesTakeSamplesInTurn) {
  Film film(small(3));
  std::vector<PixelSample> samples;
  for (int i = 0; i < 12; ++i) {  // replicate means 1, 4, 4
    const float v = i % 3 == 0 ? 1.0f : 4.0f;
    samples.push_back({.radiance = {v, v, v}});
  }
  film.addSamples(0, 0, 0, samples);
  const MeanEstimate y = film.luminanceEstimate(0, 0);
  EXPECT_EQ(film.groupCount(), 3u);
  EXPECT_EQ(y.degreesOfFreedom, 2);
  EXPECT_NEAR(y.mean, 3.0, 1e-6);
  EXPECT_NEAR(y.standardError, 1.0, 1e-6);  // sqrt(3 / 3)
}

template <class Function>
std::string messageOf(Function f, ErrorKind kind) {
  try {
    f();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), kind);
    return e.what();
  }
  return "no error";
}

TEST(Film, RefusesToMergeWhatDoesNotFit) {
  Film film(small());
  addRange(film, 0, 8);
  const Image before = film.image();
  const auto refuse = [&](const Film& other) { return messageOf([&] { film.merge(other); }, ErrorKind::Usage); };
  EXPECT_NE(refuse(Film({.width = 6, .height = kSide})).find("size"), std::string::npos);
  EXPECT_NE(refuse(Film({.width = kSide, .height = kSide, .crop = Crop{0, 4, 0, 5}})).find("crop"), std::string::npos);
  EXPECT_NE(refuse(Film(small(8))).find("replicates"), std::string::npos);
  EXPECT_NE(refuse(film).find("itself"), std::string::npos);
  Film overlapping(small());
  addRange(overlapping, 7, 9);
  EXPECT_NE(refuse(overlapping).find("overlap"), std::string::npos);
  const Image after = film.image();
  EXPECT_EQ(std::memcmp(before.values().data(), after.values().data(), before.values().size_bytes()), 0);
  EXPECT_EQ(film.ledger().text(), "0:0-7");
}

TEST(Film, RefusesAbsurdSettings) {
  const auto refuse = [](const FilmSettings& s, ErrorKind kind) { return messageOf([&] { Film film(s); }, kind); };
  EXPECT_NE(refuse({.width = 0, .height = 5}, ErrorKind::Usage).find("0 x 5"), std::string::npos);
  EXPECT_NE(refuse({.width = 5, .height = -1}, ErrorKind::Usage).find("5 x -1"), std::string::npos);
  EXPECT_NE(refuse({.width = 2000000, .height = 1}, ErrorKind::Usage).find("2000000"), std::string::npos);
  for (const Crop c : {Crop{0, 6, 0, 5}, {-1, 5, 0, 5}, {3, 3, 0, 5}, {0, 5, 4, 2}, {0, 5, 0, 6}, {0, 5, -1, 5}}) {
    EXPECT_NE(refuse({.width = 5, .height = 5, .crop = c}, ErrorKind::Usage).find("crop"), std::string::npos);
  }
  for (const std::uint32_t r : {0u, 257u})
    EXPECT_NE(refuse(small(r), ErrorKind::Usage).find("replicates"), std::string::npos);
  EXPECT_NE(refuse({.width = 1 << 20, .height = 1 << 20}, ErrorKind::Memory).find("MiB"), std::string::npos);
  EXPECT_NE(refuse({.width = 1000, .height = 1000, .memoryLimit = 1 << 20}, ErrorKind::Memory).find("limit of 1 MiB"),
            std::string::npos);
}

TEST(Film, TakesTheMemoryThatItSays) {
  EXPECT_EQ(Film::bytesPerPixel(1), 224u);
  EXPECT_EQ(Film::bytesPerPixel(8), 224u);
  EXPECT_EQ(Film::bytesPerPixel(16), 320u);
}

}  // namespace
}  // namespace steradian
