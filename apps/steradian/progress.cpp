#include "steradian/apps/steradian/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "steradian/apps/steradian/console.h"

namespace steradian::app {

namespace {

constexpr int kBarWidth = 20;
constexpr double kRefresh = 0.1;  ///< seconds between two drawings of the bar

std::string clock(double seconds) {
  const auto whole = static_cast<long>(std::lround(std::max(0.0, seconds)));
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

ProgressDisplay::Style ProgressDisplay::styleFor(bool quiet) {
  if (quiet) return Style::None;
  return isatty(STDERR_FILENO) != 0 ? Style::Bar : Style::Lines;
}

void ProgressDisplay::update(double fraction, double secondsElapsed, std::string_view note) {
  fraction = std::clamp(fraction, 0.0, 1.0);
  const double secondsLeft = fraction > 0.0 ? secondsElapsed * (1.0 - fraction) / fraction : 0.0;
  if (style_ == Style::Bar) {
    if (fraction < 1.0 && lastPrinted_ >= 0.0 && secondsElapsed - lastPrinted_ < kRefresh) return;
    lastPrinted_ = secondsElapsed;
    printBar(fraction, secondsElapsed, secondsLeft, note);
  } else if (style_ == Style::Lines) {
    const int tenth = static_cast<int>(fraction * 10.0);
    if (tenth <= lastTenth_) return;
    lastTenth_ = tenth;
    printErr(
        fmt::format("{:3}% {} elapsed, {} left, {}\n", tenth * 10, clock(secondsElapsed), clock(secondsLeft), note));
  }
}

void ProgressDisplay::printBar(double fraction, double secondsElapsed, double secondsLeft, std::string_view note) {
  const auto filled = static_cast<std::size_t>(fraction * kBarWidth);
  printErr(fmt::format("\r[{}{}] {:3}% {} elapsed, {} left, {}\x1b[K", std::string(filled, '#'),
                       std::string(kBarWidth - filled, ' '), static_cast<int>(fraction * 100.0), clock(secondsElapsed),
                       clock(secondsLeft), note));
  barOpen_ = true;
}

void ProgressDisplay::finish() {
  if (barOpen_) printErr("\n");
  barOpen_ = false;
}

}  // namespace steradian::app
