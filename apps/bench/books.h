#pragma once
/// Whole renders beside the books' way to render: what Steradian is for somebody who comes from there.
#include "steradian/apps/bench/options.h"

namespace steradian::bench {

/// Prints one row for each scene, as a table in Markdown or as JSON. Each scene is first rendered by both and compared:
/// the last column. Scenes with what the books do not have are left out. Throws Error as makeScene() and render() do,
/// and Other, after the rows, if pictures differ that should be the same.
void runBooks(const BenchOptions& options);

}  // namespace steradian::bench
