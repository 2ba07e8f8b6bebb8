#include "steradian/tests/apps/named_places.h"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

namespace steradian::test {
namespace {

TEST(NamedPlaces, WordsAreWhole) {
  EXPECT_TRUE(hasWord("struct Lambert {", "Lambert"));
  EXPECT_FALSE(hasWord("struct LambertMaterial {", "Lambert"));
  EXPECT_TRUE(hasWord("LambertMaterial, Lambert", "Lambert"));
}

TEST(NamedPlaces, ColumnsAreThoseOfTablesWithTheHead) {
  const std::string text =
      "| a | b |\n|---|---|\n| 1 | 2 |\n\n| what | where |\n|---|---|\n| 3 | 4 |\n| 5 | 6 |\nend\n";
  EXPECT_EQ(columnOf(text, "what", 1), (std::vector<std::string>{" 4 ", " 6 "}));
  EXPECT_EQ(columnOf(text, "a", 0), std::vector<std::string>{" 1 "});
}

TEST(NamedPlaces, WhatIsWrongFails) {
  expectPlaces("[core/math/vec.h](../math/vec.h): `Vec3`, `dot`; [core/math/ray.h](../math/ray.h): `Ray`", "core/film");
  EXPECT_NONFATAL_FAILURE(expectPlaces("[core/math/vec.h](core/math/vec.h): `Vec3`, `Vec`", ""), "Vec is not in");
  EXPECT_NONFATAL_FAILURE(expectPlaces("[core/math/vec.h](core/math/ray.h): `Vec3`", ""), "leads elsewhere");
  EXPECT_NONFATAL_FAILURE(
      expectPlaces("[core/math/vec.h](core/math/vec.h): `Vec3`; [core/math/ray.h](core/math/ray.h)", ""),
      "not understood");
  EXPECT_FATAL_FAILURE(expectPlaces("[core/gone.h](core/gone.h): `Vec3`", ""), "core/gone.h");
}

TEST(NamedPlaces, PathsInTextExist) {
  expectPathsExist("see `core/math/vec.h`, `core/math` and `materials/NAME.h`");
  EXPECT_NONFATAL_FAILURE(expectPathsExist("see `core/math/vec.h` and `core/gone.h`"), "core/gone.h");
}

}  // namespace
}  // namespace steradian::test
