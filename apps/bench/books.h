#pragma once
/// Whole renders compared with a renderer written as in the books.
#include "steradian/apps/bench/options.h"

namespace steradian::bench {

/// Prints one row for each scene, as a table in Markdown or as JSON. Each scene is first rendered by both and compared
/// (last column). Scenes with features that the books lack are left out. Throws Error as makeScene() and render() do,
/// and Other, after the rows, if pictures differ that should be the same.
void runBooks(const BenchOptions& options);

}  // namespace steradian::bench
