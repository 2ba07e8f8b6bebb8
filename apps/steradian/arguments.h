#pragma once
/// Collects what is wrong with a command line, so that a user sees all mistakes at once.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "steradian/core/base/diagnostics.h"
#include "steradian/core/film/film.h"

namespace steradian::app {

struct Size {
  int width, height;
};

/// Each parser reports a bad text, naming the option, and then returns some value in range.
class Arguments {
 public:
  /// A whole number in [low, high].
  std::uint32_t whole(std::string_view option, const std::string& text, std::uint32_t low, std::uint32_t high);
  /// A finite number in [low, high].
  double number(std::string_view option, const std::string& text, double low, double high);
  /// "WxH", sides from 1 to 65536 and at most 2^28 pixels.
  Size size(std::string_view option, const std::string& text);
  /// "x0,x1,y0,y1" within a picture of the given size, not empty.
  Crop crop(std::string_view option, const std::string& text, Size within);
  /// A positive time of at most 10^9 seconds with an optional unit: "90", "90s", "1.5m", "2h", "500ms".
  double seconds(std::string_view option, const std::string& text);

  /// `suggestion`: the word that the user may have meant, or nothing.
  void problem(std::string message, std::string suggestion = {});
  /// Adds a problem for each unknown word, but not for the values of unknown options. `known`: candidates for
  /// suggestions.
  void unexpected(const std::vector<std::string>& words, const std::vector<std::string>& known);
  /// Throws Error (Usage) if there was any problem.
  void throwIfProblems() const { problems_.throwIfErrors(ErrorKind::Usage); }

 private:
  Diagnostics problems_;
};

}  // namespace steradian::app
