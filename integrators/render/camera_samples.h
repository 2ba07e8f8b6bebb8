#pragma once
/// Camera rays for several paths at once.
#include <cstdint>

#include "steradian/core/samplers/sampler.h"
#include "steradian/integrators/render/render_job.h"

namespace STERADIAN_API steradian {

/// The samples pass.first, ..., pass.end - 1 of all pixels of a tile, pixel by pixel, with their camera rays. Rays are
/// computed for as many samples at once as there are lanes, and handed out one by one.
template <class F>
class CameraSamples {
 public:
  static constexpr int width = widthOf<F>;

  CameraSamples(const RenderJob& job, const Crop& tile, PassRange pass)
      : job_(job), tile_(tile), first_(pass.first), perPixel_(pass.count()) {
    const auto pixels = static_cast<std::uint32_t>((tile.x1 - tile.x0) * (tile.y1 - tile.y0));
    count_ = pixels * perPixel_;
    column_ = tile.x0;
    row_ = tile.y0;
    pixelKey_ = RenderJob::pixelKey(column_, row_);
  }

  /// How many there are; they are numbered from 0.
  std::uint32_t count() const { return count_; }
  bool empty() const { return next_ == count_; }

  struct Start {
    Ray<float> ray;
    float weight;
    std::uint32_t pixel, sample;
    std::uint32_t number;
  };
  /// The next one; there must be one.
  Start take() {
    const int i = static_cast<int>(next_ % width);
    if (i == 0) prepare();
    return {lane(rays_.ray, i), lane(rays_.weight, i), lane(pixel_, i), lane(sample_, i), next_++};
  }

 private:
  /// Computes the camera rays of the next samples, one per lane. (Rays beyond the last sample are never taken.)
  void prepare() {
    F x, y;
    for (int i = 0; i < width; ++i) {
      setLane(x, i, static_cast<float>(column_));
      setLane(y, i, static_cast<float>(row_));
      setLane(pixel_, i, pixelKey_);
      setLane(sample_, i, first_ + inPixel_);
      if (++inPixel_ == perPixel_) nextPixel();
    }
    rays_ = job_.cameraRay(x, y, Sampler<F>(job_.samplerSettings, pixel_, sample_));
  }
  void nextPixel() {
    inPixel_ = 0;
    if (++column_ == tile_.x1) {
      column_ = tile_.x0;
      if (++row_ == tile_.y1) --row_;
    }
    pixelKey_ = RenderJob::pixelKey(column_, row_);
  }

  const RenderJob& job_;
  Crop tile_;
  std::uint32_t first_, perPixel_, count_, next_ = 0;
  // The first sample whose camera ray is not yet computed.
  int column_, row_;
  std::uint32_t pixelKey_, inPixel_ = 0;
  WeightedRay<F> rays_;
  UintOf<F> pixel_, sample_;
};

}  // namespace steradian
