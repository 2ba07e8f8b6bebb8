#include "steradian/apps/steradian/progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace steradian::app {
namespace {

/// What a display of that style writes while `steps` equal parts of the work are done, one second each.
std::string progressOf(ProgressDisplay::Style style, int steps) {
  testing::internal::CaptureStderr();
  {
    ProgressDisplay display(style);
    for (int i = 1; i <= steps; ++i) display.update(static_cast<double>(i) / steps, i, "note");
  }
  return testing::internal::GetCapturedStderr();
}

TEST(ProgressDisplay, LinesAreOnePerTenth) {
  const std::string text = progressOf(ProgressDisplay::Style::Lines, 40);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
  EXPECT_EQ(text.substr(0, text.find('\n')), " 10% 0:04 elapsed, 0:36 left, note");
  EXPECT_NE(text.find("100% 0:40 elapsed, 0:00 left, note\n"), std::string::npos);
}

TEST(ProgressDisplay, TheBarStaysInItsLineAndEndsIt) {
  const std::string text = progressOf(ProgressDisplay::Style::Bar, 4);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  EXPECT_EQ(text.back(), '\n');
  EXPECT_NE(text.find("\r[##########          ]  50% 0:02 elapsed, 0:02 left, note"), std::string::npos) << text;
}

TEST(ProgressDisplay, QuietIsSilent) {
  EXPECT_EQ(ProgressDisplay::styleFor(true), ProgressDisplay::Style::None);
  EXPECT_EQ(progressOf(ProgressDisplay::Style::None, 3), "");
}

TEST(ProgressDisplay, HoursAndNonsense) {
  testing::internal::CaptureStderr();
  ProgressDisplay display(ProgressDisplay::Style::Lines);
  display.update(-1.0, 0.0, "");
  display.update(0.5, 3600.0, "x");
  display.update(7.0, 3600.0, "y");
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            " 50% 1:00:00 elapsed, 1:00:00 left, x\n100% 1:00:00 elapsed, 0:00 left, y\n");
}

}  // namespace
}  // namespace steradian::app
