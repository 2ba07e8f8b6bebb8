#pragma once
/// The error of a picture, as estimated from its film: standard errors pooled over blocks of pixels.
#include <limits>
#include <vector>

#include "steradian/core/film/film.h"

namespace STERADIAN_API steradian {

/// Mean luminance of a block of pixels.
struct BlockEstimate {
  Crop pixels;
  double mean = 0.0;                                               ///< luminance
  double standardError = std::numeric_limits<double>::infinity();  ///< of the mean; +inf: not known
  double degreesOfFreedom = 0.0;                                   ///< Welch-Satterthwaite; 0: not known
};

/// The film in blocks of side x side pixels, row by row from the crop's corner; those at the right and lower edge may
/// be smaller. Pixels are taken as independent: samplers scramble each pixel's sequence on its own.
/// Degrees of freedom: Welch 1947 (Biometrika 34), Satterthwaite 1946 (Biometrics Bulletin 2).
std::vector<BlockEstimate> estimateBlocks(const Film& film, int side = 8);

/// The relative mean squared error that the standard errors predict: the mean over pixels of variance / (Y^2 + 0.01), Y
/// the luminance and the variance averaged over the pixel's 8x8 block, without the 0.1 % of pixels where it is largest
/// (an error whose estimate is infinite because it is not known is as large as any). +inf while it is not known.
double estimateRelMse(const Film& film);

}  // namespace steradian
