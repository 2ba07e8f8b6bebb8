#include "steradian/core/samplers/sobol_full.h"

#include <gtest/gtest.h>

#include <set>

#include "steradian/core/samplers/sobol.h"
#include "steradian/core/samplers/sobol_directions.h"
#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

using Word = std::uint32_t;

/// Whether x generates all 2^s - 1 non-zero polynomials modulo this one.
bool isPrimitive(Word polynomial, Word degree) {
  Word power = 1, order = 0;
  do {
    power <<= 1;
    if ((power >> degree) & 1u) power ^= polynomial;
    ++order;
  } while (power != 1 && order <= 1u << degree);
  return order == (1u << degree) - 1u;
}

TEST(SobolFull, TheDirectionNumbersAreValid) {
  std::set<Word> polynomials;
  for (const SobolDirection& d : kSobolDirections) {
    const Word degree = d.degree, polynomial = (1u << degree) | (Word{d.coefficients} << 1) | 1u;
    EXPECT_TRUE(isPrimitive(polynomial, degree)) << polynomial;
    EXPECT_TRUE(polynomials.empty() || polynomial > *polynomials.rbegin()) << "all different, in order";
    polynomials.insert(polynomial);
    for (Word i = 0; i < d.initial.size(); ++i) {
      EXPECT_EQ(d.initial[i] & 1u, i < degree ? 1u : 0u);
      EXPECT_LT(d.initial[i], 2u << i);
    }
  }
}

TEST(SobolFull, TheRecurrenceIsThatOfThePaper) {
  // x^3 + x + 1 with m = 1, 3, 7, the example of Joe & Kuo's notes and of Bratley & Fox, goes on with 5, 7.
  const auto v = directionNumbers({3, 1, {1, 3, 7}});
  EXPECT_EQ(v[3], 5u << 28);
  EXPECT_EQ(v[4], 7u << 27);
}

TEST(SobolFull, EachCoordinateHasAMatrixOfItsOwn) {
  // A point whose index has one bit is the direction number of that bit.
  for (Word c = 1; c < kSobolCoordinates; ++c) {
    const auto v = directionNumbers(kSobolDirections[c - 1]);
    for (Word bit = 0; bit < 32; ++bit) {
      EXPECT_EQ(reverseBits(sobolDigits(1u << bit, c - 1u)[1]), v.at(bit)) << c;
    }
  }
  // m_11 = 983 is the last number of the last coordinate of the table.
  EXPECT_EQ(reverseBits(sobolDigits(1u << 10, 254u)[1]), 983u << 21);
}

TEST(SobolFull, TheFirstTwoCoordinatesAreThoseOfTheSequence) {
  for (Word i = 0; i < 2000; ++i) {
    const Word index = i < 1000 ? i : mixBits(i);
    const auto digits = sobolDigits(index, 0u);
    EXPECT_EQ(reverseBits(digits[0]), sobolBitsX(index));
    EXPECT_EQ(reverseBits(digits[1]), sobolBitsY(index));
  }
}

TEST(SobolFull, BlocksAreStratifiedInEveryCoordinate) {
  for (Word c = 0; c < kSobolCoordinates; c += 2) {
    for (const Word first : {0u, 256u, 0xffffff00u}) {
      std::array<std::set<Word>, 2> cells;
      for (Word i = 0; i < 256; ++i) {
        const auto digits = sobolDigits(first + i, c);
        for (const std::size_t axis : {0u, 1u}) cells.at(axis).insert(digits.at(axis) & 255u);
      }
      EXPECT_EQ(cells[0].size(), 256u) << c;
      EXPECT_EQ(cells[1].size(), 256u) << c;
    }
  }
}

TEST(SobolFull, LanesAgreeWithScalars) {
  for (Word trial = 0; trial < 100; ++trial) {
    UintOf<Lanes<8>> index(trial), coordinate(trial);
    for (int i = 0; i < 8; ++i) {
      const Word word = mixBits(8 * trial + static_cast<Word>(i));
      setLane(index, i, word >> (trial % 32));
      setLane(coordinate, i, mixBits(word) % 255u);
    }
    const auto wide = sobolDigits(index, coordinate);
    for (int i = 0; i < 8; ++i) {
      const auto narrow = sobolDigits(lane(index, i), lane(coordinate, i));
      EXPECT_EQ(lane(wide[0], i), narrow[0]);
      EXPECT_EQ(lane(wide[1], i), narrow[1]);
    }
  }
}

}  // namespace
}  // namespace steradian
