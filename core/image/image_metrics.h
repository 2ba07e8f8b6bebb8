#pragma once
/// How far two pictures differ, and whether their noise explains it.
///
/// Pictures have the channels R, G and B, or one channel, which counts as grey. All functions throw `Error` (kind
/// Usage) if two pictures have different sizes or windows, or neither set of channels.
#include <array>
#include <cstddef>
#include <vector>

#include "steradian/core/image/image.h"

namespace STERADIAN_API steradian {

/// Mean over pixels of the mean over R, G, B of (x - r)^2 / (r^2 + 0.01), r the reference; the 0.1 % of pixels (rounded
/// down) with the largest error are left out. If the standard errors of the reference are given (channels R, G, B),
/// the part of the error that is the reference's own noise, se^2 / (r^2 + 0.01), is subtracted from the pixels that
/// are kept, so the result may be slightly negative. A pixel that is not finite counts as infinitely wrong.
double relMSE(const Image& x, const Image& reference, const Image* referenceStdErr = nullptr);

/// Mean over pixels and R, G, B of (x - r)^2, all pixels.
double mse(const Image& x, const Image& reference);

/// Largest |x - r| over pixels and R, G, B; infinite if a value is not finite.
double maxAbsDifference(const Image& x, const Image& reference);

/// Means of R, G, B.
std::array<double, 3> channelMeans(const Image& x);

/// Number of values among R, G, B that are not finite.
std::size_t countNonFinite(const Image& x);

/// The terms of `relMSE` before anything is dropped or subtracted: an image with the one channel "RelSE".
Image relativeErrorMap(const Image& x, const Image& reference);

struct ZTestSettings {
  int blockSize = 8;
  double alpha = 0.01;  ///< probability that equal pictures fail, over all blocks and the whole picture together
  /// Relative difference that is put down to rounding and to filters that are not quite equal: a standard error of this
  /// share of a block's mean luminance, added in quadrature.
  double roundOffFloor = 0.002;
  /// Degrees of freedom of the standard errors of one pixel: 7 for the spread of eight parts. May be infinite.
  double degreesOfFreedomA = 7.0;
  double degreesOfFreedomB = 7.0;
  /// The largest number of correlated pixels, in blocks that share paths. Variances of means are those of independent
  /// pixels times this: the largest that such errors allow.
  double correlatedPixelsA = 1.0;
  double correlatedPixelsB = 1.0;
};

struct ZTestResult {
  int columns = 0;         ///< blocks in a row; those at the right and the lower edge may be smaller
  int rows = 0;            ///< rows of blocks
  std::vector<double> z;   ///< per block, row by row: difference of means over its standard error, a - b
  int worstBlock = 0;      ///< the block with the smallest p
  double worstZ = 0.0;     ///< its z
  double threshold = 0.0;  ///< the |z| at which that block would fail
  double imageZ = 0.0;     ///< z of the whole picture, which counts as one more block
  double pValue = 1.0;     ///< probability of anything as bad or worse between equal pictures, over all blocks
  bool passed = false;     ///< pValue >= alpha

  int knownBlocks = 0;  ///< those whose standard error is known (finite): only they can fail

  int blockCount() const { return columns * rows; }
  /// The |z| of each pixel's block, for a heat map of that size: one channel "Z.score".
  Image map(int width, int height, int blockSize) const;
};

/// Tests in luminance (.2126 R + .7152 G + .0722 B) whether two pictures are estimates of the same one: per block, the
/// difference of means against the pooled standard errors of its pixels, which are taken as independent but for
/// `correlatedPixels`.
///
/// Standard errors are those of the pixels' means: an image with a channel "StdErr.Y" (a render itself will do) or "Y";
/// else R, G, B, which are then taken as fully correlated, the largest error that they allow. Null: that picture is
/// exact; at least one must be given. An infinite standard error means "not known": its block cannot fail. A block with
/// a pixel that is not finite fails.
///
/// The pooled variance has the degrees of freedom of Welch (Biometrika 34, 1947) and Satterthwaite (Biometrics
/// Bulletin 2, 1946), so z follows Student's t; blocks are many tests at once, corrected after Sidak (Journal of the
/// American Statistical Association 62, 1967).
ZTestResult zTest(const Image& a, const Image* aStdErr, const Image& b, const Image* bStdErr,
                  const ZTestSettings& settings = {});

}  // namespace steradian
