#pragma once
/// The reference that the error of a picture is measured against.
#include "steradian/core/image/image.h"

namespace steradian::app {

/// The mean of two independent pictures and the standard error of that mean: half their difference.
struct Reference {
  Image mean, standardError;

  Reference(const Image& a, const Image& b);
  /// As `steradian diff` has it, less the reference's own noise (core/image/image_metrics.h).
  double relMseOf(const Image& picture) const;
};

}  // namespace steradian::app
