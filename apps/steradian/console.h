#pragma once
/// The program's two streams.
#include <string_view>

namespace steradian::app {

/// To standard output, at once. Throws Error (Output) if it cannot be written.
void printOut(std::string_view text);

/// To standard error. Failures are ignored: a full disk behind the log must not cost the picture.
void printErr(std::string_view text) noexcept;

/// Makes descriptors 0 to 2 exist. Without this a program started with a closed stream opens its next file in that
/// place, and messages end up in the picture. Writing to a stream that was closed still fails.
void openMissingStreams();

}  // namespace steradian::app
