#pragma once
/// What all programs have in common.
#include <functional>

namespace steradian::app {

/// `main` of a program: makes the standard streams exist, turns a limit on file size and a closed pipe into errors,
/// runs `work` and returns its exit code; an exception is printed and becomes the exit code of its kind.
int runMain(const std::function<int()>& work) noexcept;

}  // namespace steradian::app
