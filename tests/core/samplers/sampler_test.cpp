#include "steradian/core/samplers/sampler.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "steradian/core/statistics/standard_error.h"
#include "steradian/tests/support/lanes_check.h"
#include "steradian/tests/support/nets.h"

namespace steradian {
namespace {

using Word = std::uint32_t;
using test::isNet;
using test::isStratified;

TEST(Sampler, TypesHaveNames) {
  for (const SamplerType type : kSamplerTypes) EXPECT_EQ(samplerTypeOf(nameOf(type)), type);
  EXPECT_EQ(samplerTypeOf("sobol"), SamplerType::Sobol);
  EXPECT_EQ(samplerTypeOf("pmj02"), SamplerType::Pmj02);
  EXPECT_FALSE(samplerTypeOf("Sobol"));
  EXPECT_FALSE(samplerTypeOf(""));
}

TEST(Sampler, DimensionsOfBouncesAndPurposesDiffer) {
  std::vector<Word> seen;
  for (Word bounce = 0; bounce < 5; ++bounce) {
    for (Word p = 0; p < kPurposeCount; ++p) seen.push_back(dimensionOf(bounce, static_cast<Purpose>(p)));
  }
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(std::unique(seen.begin(), seen.end()), seen.end());
  const Sampler<float> sampler({}, 3u, 5u);
  EXPECT_EQ(sampler.get1D(2u, Purpose::Roulette), sampler.get1D(dimensionOf(2u, Purpose::Roulette)));
  for (const Purpose purpose : {Purpose::Film, Purpose::Lens, Purpose::BsdfDirection, Purpose::LightPosition}) {
    for (const Word bounce : {0u, 1u})
      EXPECT_TRUE(test::sameBits(sampler.get2D(bounce, purpose), sampler.get2D(dimensionOf(bounce, purpose))));
  }
}

/// Of `type`, the 2^m samples of the block.
void expectNet(SamplerType type, Word pixel, Word dimension, int m, Word block, bool pairsAreNets) {
  std::vector<Vec2f> pairs;
  std::vector<float> singles, seconds;
  for (Word i = 0; i < (1u << m); ++i) {
    const Sampler<float> sampler({type, 9u, 256u, 1u}, pixel, (block << m) + i);
    pairs.push_back(sampler.get2D(dimension));
    seconds.push_back(pairs.back().y);
    singles.push_back(sampler.get1D(dimension));
  }
  EXPECT_TRUE(isNet(pairs) || !pairsAreNets) << nameOf(type) << ' ' << m << ' ' << block;
  EXPECT_TRUE(isStratified(singles)) << nameOf(type) << ' ' << m << ' ' << block;
  EXPECT_TRUE(isStratified(seconds)) << nameOf(type) << ' ' << m << ' ' << block;
}

TEST(Sampler, BlocksAreNetsInEveryDimension) {
  for (const SamplerType type :
       {SamplerType::Sobol, SamplerType::SobolFull, SamplerType::BlueNoise, SamplerType::Pmj02}) {
    for (const Word pixel : {0u, 1u, 4000000000u}) {
      for (const Word dimension : {0u, 1u, 4u, 127u, 300u}) {
        for (int m = 0; m <= 8; ++m) {
          // 1000: beyond the table of Pmj02 and the 256 samples of BlueNoise.
          for (const Word block : {0u, 1u, 3u, 1000u}) {
            expectNet(type, pixel, dimension, m, block, type != SamplerType::SobolFull || dimension == 0u);
          }
        }
      }
    }
  }
}

/// Of the film's coordinates and another pair, in the first 256 samples.
int leastTWithFilm(Word bounce, Purpose other) {
  std::vector<std::array<float, 4>> points;
  for (Word i = 0; i < 256; ++i) {
    const Sampler<float> sampler({}, 77u, i);
    const Vec2f film = sampler.get2D(0u, Purpose::Film), p = sampler.get2D(bounce, other);
    points.push_back({film.x, film.y, p.x, p.y});
  }
  return test::leastT(points);
}

TEST(Sampler, FilmLensAndFirstDirectionAreStratifiedTogether) {
  EXPECT_LE(leastTWithFilm(0u, Purpose::BsdfDirection), 3);
  EXPECT_LE(leastTWithFilm(0u, Purpose::Lens), 4);
  EXPECT_GT(leastTWithFilm(1u, Purpose::BsdfDirection), 4);  // one by itself
  EXPECT_GT(leastTWithFilm(0u, Purpose::LightPosition), 4);
}

TEST(Sampler, SubSequencesOfTheFilmAreNets) {
  for (Word count = 8; count <= 1024; count *= 2) {
    std::array<std::vector<Vec2f>, kSubSequences> parts;
    for (Word i = 0; i < count; ++i) {
      const Sampler<float> sampler({}, 77u, i);
      parts.at(i >> subSequenceShift(count - 1)).push_back(sampler.get2D(0u, Purpose::Film));
    }
    for (const auto& part : parts) {
      EXPECT_EQ(part.size(), count / kSubSequences);
      EXPECT_TRUE(isNet(part)) << count;
    }
  }
}

TEST(Sampler, ReplicatesAreDifferentNets) {
  constexpr Word replicates = 3;
  std::array<std::vector<Vec2f>, replicates> sequences;
  std::array<std::vector<float>, replicates> strata;
  for (Word i = 0; i < 64 * replicates; ++i) {
    sequences[i % replicates].push_back(Sampler<float>({SamplerType::Sobol, 0u, 1u, replicates}, 5u, i).get2D(7u));
    strata[i % replicates].push_back(
        Sampler<float>({SamplerType::Stratified, 0u, 64 * replicates, replicates}, 5u, i).get1D(7u));
  }
  for (Word r = 0; r < replicates; ++r) {
    EXPECT_TRUE(isNet(sequences[r]));
    EXPECT_TRUE(isStratified(strata[r]));
    int equal = 0;
    for (std::size_t i = 0; i < 64; ++i) equal += sequences[r][i].x == sequences[(r + 1) % replicates][i].x;
    EXPECT_LE(equal, 1);
  }
}

TEST(Sampler, StratifiedFillsEveryStratumOnce) {
  for (const Word count : {1u, 2u, 4u, 9u, 64u, 100u}) {
    for (const Word grid : {0u, 1u, 5u}) {
      std::vector<float> singles;
      std::vector<bool> cells(count, false);
      const auto side = static_cast<Word>(std::sqrt(static_cast<double>(count)));
      const Word columns = side, rows = (count + side - 1) / side;
      cells.resize(columns * rows, false);
      for (Word i = 0; i < count; ++i) {
        // Samples beyond the count begin another grid.
        const Sampler<float> sampler({SamplerType::Stratified, 1u, count, 1u}, 12u, grid * count + i);
        singles.push_back(sampler.get1D(3u));
        const Vec2f p = sampler.get2D(2u);
        const auto cell = static_cast<std::size_t>(p.y * static_cast<float>(rows)) * columns +
                          static_cast<std::size_t>(p.x * static_cast<float>(columns));
        EXPECT_FALSE(cells[cell]) << count;
        cells[cell] = true;
      }
      EXPECT_TRUE(isStratified(singles)) << count;
    }
  }
}

TEST(Sampler, StratifiedGridsHaveOrdersOfTheirOwn) {
  // Sample i of one grid lies in the stratum of sample i of the next about once in 64.
  const auto stratum = [](Word sample) {
    return static_cast<int>(64.0f * Sampler<float>({SamplerType::Stratified, 1u, 64u, 1u}, 12u, sample).get1D(3u));
  };
  int equal = 0;
  for (Word i = 0; i < 64; ++i) equal += stratum(i) == stratum(64 + i);
  EXPECT_LE(equal, 8);
}

TEST(Sampler, EveryPartOfTheCoordinateMatters) {
  for (const SamplerType type : kSamplerTypes) {
    const auto draw = [&](Word seed, Word pixel, Word sample, Word dimension) {
      return Sampler<float>({type, seed, 64u, 1u}, pixel, sample).get2D(dimension);
    };
    std::array<int, 4> equal{};
    for (Word i = 0; i < 200; ++i) {
      const Vec2f p = draw(i, i + 1, i % 32, i + 3);
      equal[0] += p.x == draw(i + 1, i + 1, i % 32, i + 3).x;
      equal[1] += p.x == draw(i, i + 2, i % 32, i + 3).x;
      equal[2] += p.x == draw(i, i + 1, i % 32 + 1, i + 3).x;
      equal[3] += p.x == draw(i, i + 1, i % 32, i + 4).x;
      EXPECT_TRUE(p.x >= 0.0f && p.x < 1.0f && p.y >= 0.0f && p.y < 1.0f);
      EXPECT_TRUE(test::sameBits(p, draw(i, i + 1, i % 32, i + 3))) << "a pure function of its coordinate";
    }
    for (const int count : equal) EXPECT_LE(count, 1) << nameOf(type);
  }
}

template <class F>
void expectLanesAgree(const SamplerSettings& settings) {
  for (Word trial = 0; trial < 20; ++trial) {
    UintOf<F> pixel(trial), sample(trial), dimension(trial);
    for (int i = 0; i < widthOf<F>; ++i) {
      const auto words = randomWords(trial, static_cast<Word>(i), 3u, 4u);
      setLane(pixel, i, words[0] % 1000000u);
      setLane(sample, i, trial % 2 == 0 ? words[1] % 300u : words[1]);
      setLane(dimension, i, words[2] % (trial % 3 == 0 ? 5u : 100u));  // those that are stratified together, or not
    }
    const Sampler<F> wide(settings, pixel, sample);
    const auto pairs = wide.get2D(dimension);
    const auto singles = wide.get1D(dimension);
    for (int i = 0; i < widthOf<F>; ++i) {
      const Sampler<float> narrow(settings, lane(pixel, i), lane(sample, i));
      EXPECT_TRUE(test::sameBits(lane(pairs, i), narrow.get2D(lane(dimension, i)))) << nameOf(settings.type);
      EXPECT_EQ(lane(singles, i), narrow.get1D(lane(dimension, i))) << nameOf(settings.type);
    }
  }
}

TEST(Sampler, LanesAgreeWithScalars) {
  for (const SamplerType type : kSamplerTypes) {
    for (const Word replicates : {1u, 3u}) {
      expectLanesAgree<Lanes<4>>({type, 17u, 60u, replicates});
      expectLanesAgree<Lanes<8>>({type, 17u, 60u, replicates});
    }
  }
}

TEST(Sampler, DegenerateSettingsWork) {
  for (const SamplerType type : kSamplerTypes) {
    const Vec2f p = Sampler<float>({type, 0u, 0u, 0u}, 1u, 1u).get2D(0u);
    EXPECT_TRUE(p.x >= 0.0f && p.x < 1.0f);
    const float x = Sampler<float>({type, 0u, 0xffffffffu, 1u}, 0xffffffffu, 0xffffffffu).get1D(0xffffffffu);
    EXPECT_TRUE(x >= 0.0f && x < 1.0f);
    const Vec2f q = Sampler<float>({type, 0u, 0xffffffffu, 1u}, 0xffffffffu, 0xffffffffu).get2D(0xffffffffu);
    EXPECT_TRUE(q.x >= 0.0f && q.x < 1.0f && q.y >= 0.0f && q.y < 1.0f);
  }
}

/// Beyond its coordinates the full sequence begins again. With the same order of samples in all blocks, the first
/// digits of a coordinate would determine those of its counterpart: 64 samples would fall into 8 cells of 8 x 8.
TEST(Sampler, BlocksOfTheFullSequenceAreUntied) {
  const SamplerSettings settings{.type = SamplerType::SobolFull, .samplesPerPixel = 64};
  for (std::uint32_t dimension = 0; dimension < 20; ++dimension) {
    std::set<int> cells;
    for (std::uint32_t i = 0; i < 64; ++i) {
      const Sampler<float> sampler(settings, 5u, i);
      const float x = sampler.get2D(dimension).x, y = sampler.get2D(dimension + kSobolCoordinates / 2).x;
      cells.insert(static_cast<int>(8.0f * x) * 8 + static_cast<int>(8.0f * y));
    }
    EXPECT_GT(cells.size(), 16u) << dimension;
  }
}

}  // namespace
}  // namespace steradian
