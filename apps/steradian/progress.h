#pragma once
/// Progress of long work on standard error: a bar on a terminal, a line for every tenth elsewhere.
#include <string_view>

namespace steradian::app {

class ProgressDisplay {
 public:
  enum class Style { None, Lines, Bar };
  /// Bar if standard error is a terminal, otherwise Lines; None if `quiet`.
  static Style styleFor(bool quiet);

  explicit ProgressDisplay(Style style) : style_(style) {}
  ~ProgressDisplay() { finish(); }
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// `fraction` in [0, 1]; `note` is shown behind the times.
  void update(double fraction, double secondsElapsed, std::string_view note);
  /// Ends the bar's line.
  void finish();

 private:
  void printBar(double fraction, double secondsElapsed, double secondsLeft, std::string_view note);

  Style style_;
  int lastTenth_ = 0;
  double lastPrinted_ = -1.0;
  bool barOpen_ = false;
};

}  // namespace steradian::app
