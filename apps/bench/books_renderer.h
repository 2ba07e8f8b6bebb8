#pragma once
/// A renderer as in the books, for comparison with Steradian.
#include <cstdint>

#include "steradian/apps/bench/books_world.h"
#include "steradian/core/image/image.h"

namespace steradian::bench::books {

struct PictureSize {
  int width, height;
};

/// "The Next Week"'s camera loop: paths are scattered until they hit a light, reach the sky or are too long; lights are
/// not sampled. The only addition to the book: rows are distributed among the threads of the caller's arena. Channels
/// R, G, B, and StdErr.Y from the spread of the samples. Equal arguments give equal pictures.
Image render(const World& world, PictureSize size, std::uint32_t samplesPerPixel, std::uint32_t seed);

}  // namespace steradian::bench::books
