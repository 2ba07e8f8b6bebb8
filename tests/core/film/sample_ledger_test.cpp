#include "steradian/core/film/sample_ledger.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "steradian/core/base/diagnostics.h"

namespace steradian {
namespace {

TEST(SampleLedger, JoinsNeighboursInAnyOrder) {
  std::vector<SampleRange> ranges{{0, 0, 16}, {0, 16, 32}, {0, 48, 64}, {0, 32, 48}};
  std::sort(ranges.begin(), ranges.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  do {
    SampleLedger ledger;
    for (const SampleRange& r : ranges) ledger.add(r);
    EXPECT_EQ(ledger.text(), "0:0-63");
    EXPECT_EQ(ledger.completeCount(), 64u);
  } while (std::next_permutation(ranges.begin(), ranges.end(),
                                 [](const auto& a, const auto& b) { return a.first < b.first; }));
}

TEST(SampleLedger, KeepsSeedsAndStoppedPassesApart) {
  SampleLedger ledger;
  ledger.add({7, 0, 8});
  ledger.add({3, 8, 16});
  ledger.add({7, 8, 16, false});
  ledger.add({7, 16, 17});
  EXPECT_EQ(ledger.text(), "3:8-15 7:0-7 ~7:8-15 7:16-16");
  EXPECT_EQ(ledger.completeCount(), 17u);
  EXPECT_EQ(ledger.ranges().size(), 4u);
}

TEST(SampleLedger, RefusesOverlapsAndEmptyRanges) {
  SampleLedger ledger;
  ledger.add({0, 16, 32});
  for (const SampleRange& bad :
       {SampleRange{0, 0, 17}, {0, 31, 40}, {0, 20, 21}, {0, 0, 64}, {0, 16, 32, false}, {0, 5, 5}, {0, 6, 5}}) {
    EXPECT_THROW(ledger.add(bad), Error);
    EXPECT_EQ(ledger.text(), "0:16-31");
  }
  ledger.add({1, 16, 32});  // another seed: other samples
}

TEST(SampleLedger, MergesAllOrNothing) {
  SampleLedger a, b;
  a.add({0, 0, 16});
  b.add({0, 16, 32});
  b.add({0, 8, 9});
  EXPECT_THROW(a.merge(b), Error);
  EXPECT_EQ(a.text(), "0:0-15");
  SampleLedger c;
  c.add({0, 16, 32});
  a.merge(c);
  EXPECT_EQ(a.text(), "0:0-31");
}

}  // namespace
}  // namespace steradian
