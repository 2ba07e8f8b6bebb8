#pragma once
/// A map of a planet like ours, made of noise: the picture of the scene `earth` where no file is given.
#include "steradian/core/image/image.h"

namespace steradian::scenes {

/// Equirectangular, north at the top: linear reflectances in R, G and B. The same bits on every machine. Each pixel is
/// a function of the point p of the unit sphere that the books' u, v put there ("The Next Week", 4.4), so that the map
/// has neither a seam nor poles. `width` must be a multiple of 4.
Image earthPicture(int width = 1024, int height = 512);

}  // namespace steradian::scenes
