#include "steradian/core/base/execution_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace steradian {

void check(const ExecutionSettings& settings, Diagnostics& wrong) {
  try {
    requireUsable(settings.isa);
  } catch (const Error& error) {
    for (const Diagnostic& d : error.diagnostics()) wrong.add(d);
  }
  constexpr std::array<std::uint32_t, 5> widths{0, 1, 4, 8, 16};
  if (std::find(widths.begin(), widths.end(), settings.width) == widths.end()) {
    wrong.error({}, fmt::format("the width must be 1, 4, 8 or 16, or 0 for the widest, not {}", settings.width));
  }
}

void requireUsable(const ExecutionSettings& settings) {
  Diagnostics wrong;
  check(settings, wrong);
  wrong.throwIfErrors(ErrorKind::Usage);
}

}  // namespace steradian
