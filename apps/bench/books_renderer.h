#pragma once
/// The books' way to render, as what Steradian is measured against.
#include <cstdint>

#include "steradian/apps/bench/books_world.h"
#include "steradian/core/image/image.h"

namespace steradian::bench::books {

struct PictureSize {
  int width, height;
};

/// "The Next Week"'s camera loop: paths follow what surfaces scatter until they meet light or the sky or are too long;
/// lights are not sampled. The rows are shared out among the threads of the caller's arena; that is all that the book
/// does not do. Channels R, G, B, and StdErr.Y from the spread of the samples. Equal arguments give equal pictures.
Image render(const World& world, PictureSize size, std::uint32_t samplesPerPixel, std::uint32_t seed);

}  // namespace steradian::bench::books
