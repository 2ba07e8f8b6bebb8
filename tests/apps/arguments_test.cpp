#include "steradian/apps/steradian/arguments.h"

#include <gtest/gtest.h>

namespace steradian::app {
namespace {

/// The reader's value; fails the test if it complains.
template <class Read>
auto good(Read read) {
  Arguments arguments;
  const auto value = read(arguments);
  EXPECT_NO_THROW(arguments.throwIfProblems());
  return value;
}

double seconds(const std::string& text) {
  return good([&](Arguments& a) { return a.seconds("--time", text); });
}

TEST(Arguments, SecondsWithAndWithoutUnits) {
  EXPECT_EQ(seconds("90"), 90.0);
  EXPECT_EQ(seconds("0.5s"), 0.5);
  EXPECT_EQ(seconds("1.5m"), 90.0);
  EXPECT_EQ(seconds("2h"), 7200.0);
  EXPECT_EQ(seconds("500ms"), 0.5);
  EXPECT_EQ(seconds("1e3"), 1000.0);
}

TEST(Arguments, WholeNumbersIncludeBothEnds) {
  EXPECT_EQ(good([](Arguments& a) { return a.whole("--n", "1", 1, 5); }), 1u);
  EXPECT_EQ(good([](Arguments& a) { return a.whole("--n", "5", 1, 5); }), 5u);
  EXPECT_EQ(good([](Arguments& a) { return a.whole("--n", "4294967295", 0, 0xffffffffu); }), 0xffffffffu);
}

TEST(Arguments, Numbers) {
  EXPECT_EQ(good([](Arguments& a) { return a.number("--x", "-2.5", -4.0, 4.0); }), -2.5);
  EXPECT_EQ(good([](Arguments& a) { return a.number("--x", "4", -4.0, 4.0); }), 4.0);
}

TEST(Arguments, SizesWithEitherCross) {
  const Size size = good([](Arguments& a) { return a.size("--size", "65536X4096"); });
  EXPECT_EQ(size.width, 65536);
  EXPECT_EQ(size.height, 4096);
}

TEST(Arguments, CropsReachTheEdge) {
  const Crop crop = good([](Arguments& a) { return a.crop("--crop", "0,4,2,3", {4, 3}); });
  EXPECT_EQ(crop, (Crop{0, 4, 2, 3}));
}

TEST(Arguments, ComplainsOnceAboutEachAndGoesOnInRange) {
  Arguments arguments;
  EXPECT_EQ(arguments.whole("--n", "9", 2, 5), 2u);
  EXPECT_GT(arguments.seconds("--time", "-1"), 0.0);
  EXPECT_GE(arguments.size("--size", "0x0").width, 1);
  arguments.problem("no such word", "such");
  try {
    arguments.throwIfProblems();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Usage);
    EXPECT_EQ(error.diagnostics().size(), 4u);
    EXPECT_STREQ(error.what(),
                 "error: --n needs a whole number from 2 to 5, not \"9\"\n"
                 "error: --time needs a time such as 90s, 1.5m, 2h or 500ms, not \"-1\"\n"
                 "error: --size needs WIDTHxHEIGHT, sides from 1 to 65536 and at most 268435456 pixels, not \"0x0\"\n"
                 "error: no such word (did you mean \"such\"?)");
  }
}

}  // namespace
}  // namespace steradian::app
