#include "steradian/core/sampling/weighted_reservoir.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

TEST(WeightedReservoir, KeepsTheFirstAndReplacesBySharesOfTheTotal) {
  WeightedReservoir<float, std::string> r;
  EXPECT_TRUE(r.empty());
  EXPECT_EQ(r.probability(), 0.0f);
  EXPECT_TRUE(r.add("a", 2.0f, kOneMinusEpsilon));
  EXPECT_EQ(r.item(), "a");
  EXPECT_EQ(r.probability(), 1.0f);
  // b has a share of 6 / 8.
  EXPECT_FALSE(r.add("b", 6.0f, 0.75f));
  EXPECT_EQ(r.item(), "a");
  EXPECT_EQ(r.probability(), 0.25f);
  EXPECT_TRUE(r.add("c", 8.0f, 0.49f));
  EXPECT_EQ(r.item(), "c");
  EXPECT_EQ(r.weight(), 8.0f);
  EXPECT_EQ(r.total(), 16.0f);
  EXPECT_EQ(r.count(), 3u);
}

TEST(WeightedReservoir, WhatHasNoWeightIsNeverChosen) {
  WeightedReservoir<float, int> r;
  for (const float weight : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_FALSE(r.add(1, weight, 0.0f)) << weight;
    EXPECT_TRUE(r.empty());
  }
  EXPECT_EQ(r.total(), 0.0f);
  EXPECT_EQ(r.count(), 3u);
  EXPECT_TRUE(r.add(2, 1e-45f, kOneMinusEpsilon)) << "however small it is";
  EXPECT_FALSE(r.add(3, 0.0f, 0.0f));
  EXPECT_EQ(r.item(), 2);
}

TEST(WeightedReservoir, LongStreamsKeepTheirTotal) {
  // A float alone would stop at 2^24 thirds.
  WeightedReservoir<float, int> r;
  for (int i = 0; i < 3000000; ++i) r.add(i, 0.1f, 0.5f);
  EXPECT_NEAR(r.total() / (3e6 * static_cast<double>(0.1f)), 1.0, 1e-7);
}

TEST(WeightedReservoir, MergesAsIfOneStreamHadFollowed) {
  WeightedReservoir<float, int> a, b, none;
  a.add(1, 3.0f, 0.0f);
  b.add(2, 1.0f, 0.0f);
  b.add(3, 4.0f, 0.1f);
  EXPECT_FALSE(a.merge(none, 0.0f));
  EXPECT_TRUE(none.merge(a, kOneMinusEpsilon));
  EXPECT_EQ(none.item(), 1);
  EXPECT_FALSE(a.merge(b, 0.625f));  // b has 5 of 8
  EXPECT_EQ(a.item(), 1);
  EXPECT_EQ(a.probability(), 3.0f / 8.0f);
  EXPECT_TRUE(none.merge(b, 0.6249f));
  EXPECT_EQ(none.item(), 3);
  EXPECT_EQ(none.weight(), 4.0f);
  EXPECT_EQ(none.total(), 8.0f);
  EXPECT_EQ(none.count(), 3u);
}

TEST(WeightedReservoir, LanesAgreeWithScalars) {
  const auto us = test::unitNumbers(256), vs = test::unitNumbers(256, 1), ws = test::numbers(256, -0.5f, 1.0f, 2);
  const auto stream = [](auto u, auto v, auto w) {
    using F = decltype(u);
    WeightedReservoir<F, F> a, b;
    a.add(F(1.0f), w, u);
    a.add(F(2.0f), v, u);
    b.add(F(3.0f), u, v);
    b.add(F(4.0f), w, v);
    a.merge(b, select(w > F(0.0f), w, v));
    return Vec3<F>{a.item(), a.weight() + a.total(), a.probability()};
  };
  EXPECT_TRUE(test::sameInLanes<8>(stream, us, vs, ws));
  EXPECT_TRUE(test::sameInLanes<16>(stream, us, vs, ws));
}

}  // namespace
}  // namespace steradian
