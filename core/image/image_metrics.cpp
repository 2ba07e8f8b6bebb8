#include "steradian/core/image/image_metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "steradian/core/base/diagnostics.h"
#include "steradian/core/statistics/student_t.h"

namespace steradian {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double relativeOffset = 0.01;
constexpr std::size_t pixelsPerDropped = 1000;
constexpr std::array<double, 3> luminanceWeights{0.2126, 0.7152, 0.0722};

std::array<int, 3> colourOf(const Image& image) {
  if (const auto rgb = image.findRgb()) return *rgb;
  if (image.channelCount() == 1) return {0, 0, 0};
  throw Error(ErrorKind::Usage, "only images with the channels R, G and B, or with one channel, can be compared");
}

void checkSameShape(const Image& a, const Image& b) {
  if (a.width() == b.width() && a.height() == b.height() && a.window() == b.window()) return;
  const auto describe = [](const Image& image) {
    return std::to_string(image.width()) + " x " + std::to_string(image.height()) + " at (" +
           std::to_string(image.window().x0) + ", " + std::to_string(image.window().y0) + ")";
  };
  throw Error(ErrorKind::Usage, "images of different size cannot be compared: " + describe(a) + " and " + describe(b));
}

/// The colour of pixel i in the order of rows.
class Colours {
 public:
  explicit Colours(const Image& image)
      : values_(image.values()), stride_(static_cast<std::size_t>(image.channelCount())), channels_(colourOf(image)) {}
  std::array<double, 3> operator[](std::size_t i) const {
    std::array<double, 3> rgb{};
    for (std::size_t c = 0; c < 3; ++c) rgb[c] = values_[i * stride_ + static_cast<std::size_t>(channels_[c])];
    return rgb;
  }

 private:
  std::span<const float> values_;
  std::size_t stride_;
  std::array<int, 3> channels_;
};

double squaredRelativeError(const std::array<double, 3>& x, const std::array<double, 3>& r) {
  double sum = 0.0;
  for (std::size_t c = 0; c < 3; ++c) sum += (x[c] - r[c]) * (x[c] - r[c]) / (r[c] * r[c] + relativeOffset);
  return std::isfinite(sum) ? sum / 3.0 : infinity;
}

double luminanceOf(const std::array<double, 3>& rgb) {
  return luminanceWeights[0] * rgb[0] + luminanceWeights[1] * rgb[1] + luminanceWeights[2] * rgb[2];
}

/// What the luminance of each pixel adds to the variance of sums over pixels; 0 for a null image.
class LuminanceErrors {
 public:
  /// The sum of g fully correlated pixels has g times the variance that independent ones would give it, and the degrees
  /// of freedom of one pixel.
  LuminanceErrors(const Image* image, double degreesOfFreedom, double correlatedPixels)
      : image_(image), correlatedPixels_(correlatedPixels), dof_(degreesOfFreedom / correlatedPixels) {
    if (!image_) return;
    auto channel = image_->findChannel("StdErr.Y");
    if (!channel) channel = image_->findChannel("Y");
    if (channel) {
      channels_ = {*channel, *channel, *channel};
    } else {
      channels_ = colourOf(*image_);
    }
  }
  double variance(std::size_t i) const {
    if (!image_) return 0.0;
    double sum = 0.0;  // standard error
    const auto stride = static_cast<std::size_t>(image_->channelCount());
    for (std::size_t c = 0; c < 3; ++c) {
      sum += luminanceWeights[c] * image_->values()[i * stride + static_cast<std::size_t>(channels_[c])];
    }
    return sum * sum * correlatedPixels_;
  }
  double degreesOfFreedom() const { return dof_; }

 private:
  const Image* image_;
  double correlatedPixels_, dof_;
  std::array<int, 3> channels_{};
};

/// Sums over a set of pixels.
struct Pool {
  double a = 0.0, b = 0.0;   ///< luminance
  double variance = 0.0;     ///< of a - b
  double uncertainty = 0.0;  ///< sum of variance^2 / degrees of freedom

  void add(const Pool& o) {
    a += o.a;
    b += o.b;
    variance += o.variance;
    uncertainty += o.uncertainty;
  }
};

struct Score {
  double z = 0.0;
  double p = 1.0;
  double degreesOfFreedom = infinity;
};

Score scoreOf(const Pool& pool, double floor) {
  const double difference = pool.a - pool.b;
  if (!std::isfinite(difference)) return {infinity, 0.0, infinity};
  const double roundOff = floor * 0.5 * (std::abs(pool.a) + std::abs(pool.b));
  const double variance = pool.variance + roundOff * roundOff;
  if (std::isnan(variance)) return {infinity, 0.0, infinity};
  if (std::isinf(variance) || difference == 0.0) return {};
  if (variance == 0.0) return {std::copysign(infinity, difference), 0.0, infinity};
  const double dof = pool.uncertainty > 0.0 ? variance * variance / pool.uncertainty : infinity;
  const double z = difference / std::sqrt(variance);
  return {z, studentTwoSidedP(z, dof), dof};
}

struct Comparison {
  const Colours a, b;
  const LuminanceErrors aErrors, bErrors;
  const int width, height;

  Pool poolBlock(int x0, int y0, int size) const {
    Pool pool;
    for (int y = y0; y < std::min(y0 + size, height); ++y) {
      for (int x = x0; x < std::min(x0 + size, width); ++x) {
        const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
        const double va = aErrors.variance(i), vb = bErrors.variance(i);
        pool.add({luminanceOf(a[i]), luminanceOf(b[i]), va + vb,
                  va * va / aErrors.degreesOfFreedom() + vb * vb / bErrors.degreesOfFreedom()});
      }
    }
    return pool;
  }
};

void checkSettings(const ZTestSettings& s) {
  const bool good = s.blockSize >= 1 && s.alpha > 0.0 && s.alpha < 1.0 && s.roundOffFloor >= 0.0 &&
                    s.degreesOfFreedomA > 0.0 && s.degreesOfFreedomB > 0.0 && s.correlatedPixelsA >= 1.0 &&
                    s.correlatedPixelsB >= 1.0;
  if (!good) throw Error(ErrorKind::Usage, "the settings of a Z-test are out of range");
}

}  // namespace

double relMSE(const Image& x, const Image& reference, const Image* referenceStdErr) {
  checkSameShape(x, reference);
  if (referenceStdErr) checkSameShape(reference, *referenceStdErr);
  const Colours xs(x), rs(reference);
  std::vector<double> errors(x.pixelCount());
  for (std::size_t i = 0; i < errors.size(); ++i) errors[i] = squaredRelativeError(xs[i], rs[i]);

  std::vector<std::size_t> order(errors.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const std::size_t kept = order.size() - order.size() / pixelsPerDropped;
  // Ties by index: the same pixels are dropped by every standard library.
  if (kept < order.size()) {
    std::nth_element(
        order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept), order.end(),
        [&](std::size_t i, std::size_t j) { return errors[i] != errors[j] ? errors[i] < errors[j] : i < j; });
  }
  std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept));

  double sum = 0.0;
  for (std::size_t k = 0; k < kept; ++k) sum += errors[order[k]];
  if (referenceStdErr) {
    const Colours se(*referenceStdErr);
    for (std::size_t k = 0; k < kept; ++k) {
      const auto s = se[order[k]], r = rs[order[k]];
      for (std::size_t c = 0; c < 3; ++c) sum -= s[c] * s[c] / (r[c] * r[c] + relativeOffset) / 3.0;
    }
  }
  return sum / static_cast<double>(kept);
}

double mse(const Image& x, const Image& reference) {
  checkSameShape(x, reference);
  const Colours xs(x), rs(reference);
  double sum = 0.0;
  for (std::size_t i = 0; i < x.pixelCount(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) sum += (xs[i][c] - rs[i][c]) * (xs[i][c] - rs[i][c]);
  }
  return sum / static_cast<double>(3 * x.pixelCount());
}

double maxAbsDifference(const Image& x, const Image& reference) {
  checkSameShape(x, reference);
  const Colours xs(x), rs(reference);
  double largest = 0.0;
  for (std::size_t i = 0; i < x.pixelCount(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double difference = std::abs(xs[i][c] - rs[i][c]);
      largest = std::isfinite(difference) ? std::max(largest, difference) : infinity;
    }
  }
  return largest;
}

std::array<double, 3> channelMeans(const Image& x) {
  const Colours xs(x);
  std::array<double, 3> sums{};
  for (std::size_t i = 0; i < x.pixelCount(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) sums[c] += xs[i][c];
  }
  for (double& sum : sums) sum /= static_cast<double>(x.pixelCount());
  return sums;
}

std::size_t countNonFinite(const Image& x) {
  const Colours xs(x);
  std::size_t count = 0;
  for (std::size_t i = 0; i < x.pixelCount(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) count += std::isfinite(xs[i][c]) ? 0 : 1;
  }
  return count;
}

Image relativeErrorMap(const Image& x, const Image& reference) {
  checkSameShape(x, reference);
  const Colours xs(x), rs(reference);
  Image result(x.width(), x.height(), {"RelSE"}, x.window());
  for (std::size_t i = 0; i < x.pixelCount(); ++i) {
    result.values()[i] = static_cast<float>(squaredRelativeError(xs[i], rs[i]));
  }
  return result;
}

Image ZTestResult::map(int width, int height, int blockSize) const {
  Image result(width, height, {"Z.score"});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int column = std::min(x / blockSize, columns - 1), row = std::min(y / blockSize, rows - 1);
      const std::size_t block =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
      result.at(x, y, 0) = static_cast<float>(std::abs(z[block]));
    }
  }
  return result;
}

ZTestResult zTest(const Image& a, const Image* aStdErr, const Image& b, const Image* bStdErr,
                  const ZTestSettings& settings) {
  checkSettings(settings);
  checkSameShape(a, b);
  if (!aStdErr && !bStdErr) throw Error(ErrorKind::Usage, "a Z-test needs the standard errors of at least one image");
  if (aStdErr) checkSameShape(a, *aStdErr);
  if (bStdErr) checkSameShape(b, *bStdErr);
  const Comparison comparison{Colours(a),
                              Colours(b),
                              LuminanceErrors(aStdErr, settings.degreesOfFreedomA, settings.correlatedPixelsA),
                              LuminanceErrors(bStdErr, settings.degreesOfFreedomB, settings.correlatedPixelsB),
                              a.width(),
                              a.height()};
  ZTestResult result;
  result.columns = (a.width() + settings.blockSize - 1) / settings.blockSize;
  result.rows = (a.height() + settings.blockSize - 1) / settings.blockSize;
  Pool whole;
  Score worst{.z = 0.0, .p = 2.0, .degreesOfFreedom = infinity};
  for (int row = 0; row < result.rows; ++row) {
    for (int column = 0; column < result.columns; ++column) {
      const Pool pool = comparison.poolBlock(column * settings.blockSize, row * settings.blockSize, settings.blockSize);
      const Score score = scoreOf(pool, settings.roundOffFloor);
      whole.add(pool);
      result.z.push_back(score.z);
      if (!std::isinf(pool.variance)) ++result.knownBlocks;
      if (score.p >= worst.p) continue;
      worst = score;
      result.worstBlock = row * result.columns + column;
    }
  }
  const Score image = scoreOf(whole, settings.roundOffFloor);
  const double tests = result.blockCount() + 1;
  result.worstZ = worst.z;
  result.imageZ = image.z;
  const double alphaEach = -std::expm1(std::log1p(-settings.alpha) / tests);
  result.threshold = studentTwoSidedQuantile(alphaEach, worst.degreesOfFreedom);
  const double p = std::min(worst.p, image.p);
  result.pValue = p >= 1.0 ? 1.0 : -std::expm1(tests * std::log1p(-p));
  result.passed = result.pValue >= settings.alpha;
  return result;
}

}  // namespace steradian
