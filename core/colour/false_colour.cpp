#include "steradian/core/colour/false_colour.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "steradian/core/colour/display.h"

namespace steradian {
namespace {

constexpr DisplayColour notANumber{0.0f, 0.8f, 0.2f};

double cube(double x) { return x * x * x; }

/// OKLab in polar form (lightness, chroma, hue in degrees) to sRGB. The matrices are Ottosson's.
DisplayColour fromOklch(double lightness, double chroma, double hue) {
  const double a = chroma * std::cos(hue * std::numbers::pi / 180.0);
  const double b = chroma * std::sin(hue * std::numbers::pi / 180.0);
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  const std::array<double, 3> rgb{4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                                  -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                                  -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
  DisplayColour result{};
  for (std::size_t c = 0; c < 3; ++c) result[c] = srgbEncode(static_cast<float>(std::clamp(rgb[c], 0.0, 1.0)));
  return result;
}

}  // namespace

DisplayColour heatColour(float t) {
  if (std::isnan(t)) return notANumber;
  // Linear in lightness, a turn from blue over red to yellow in hue, and as much chroma as sRGB has there.
  const double x = std::clamp(t, 0.0f, 1.0f);
  return fromOklch(0.10 + 0.86 * x, 0.03 + 0.60 * x * (1.0 - x), 280.0 + 185.0 * x);
}

DisplayColour divergingColour(float t) {
  if (std::isnan(t)) return notANumber;
  const double x = std::clamp(t, -1.0f, 1.0f), size = std::abs(x);
  return fromOklch(0.97 - 0.50 * size, 0.02 + 0.13 * size, x < 0.0 ? 255.0 : 27.0);
}

ScalarRange rangeOf(const Image& image, std::string_view channel, double outliers) {
  const auto first = static_cast<std::size_t>(image.channel(channel));
  const auto stride = static_cast<std::size_t>(image.channelCount());
  std::vector<float> values;
  for (std::size_t i = first; i < image.values().size(); i += stride) {
    if (std::isfinite(image.values()[i])) values.push_back(image.values()[i]);
  }
  if (values.empty()) return {};
  const double share = std::clamp(1.0 - outliers, 0.0, 1.0);
  const auto last = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + last, values.end());
  const float high = values[static_cast<std::size_t>(last)];
  const float low = *std::min_element(values.begin(), values.end());
  if (high > low) return {low, high};
  return {low, low + std::max(std::abs(low), 1.0f)};
}

Image falseColour(const Image& image, std::string_view channel, ScalarRange range) {
  const int source = image.channel(channel);
  Image result(image.width(), image.height(), {"R", "G", "B"}, image.window());
  result.metadata().insert_or_assign("encoding", std::string("srgb"));
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const DisplayColour colour = heatColour((image.at(x, y, source) - range.low) / (range.high - range.low));
      std::copy(colour.begin(), colour.end(), result.pixel(x, y).begin());
    }
  }
  return result;
}

}  // namespace steradian
