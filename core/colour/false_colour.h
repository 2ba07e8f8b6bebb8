#pragma once
/// Numbers as colours: heat maps of differences, pictures of depth.
///
/// The colours are made in OKLab, where equal steps look equal (Ottosson 2020, "A perceptual color space for image
/// processing"). They are display-referred, encoded with the sRGB curve: they go into a PNG as they are, without a
/// display transform.
#include <array>
#include <string_view>

#include "steradian/core/image/image.h"

namespace STERADIAN_API steradian {

/// R, G, B in [0, 1].
using DisplayColour = std::array<float, 3>;

/// For magnitudes: from nearly black (t = 0) over blue, purple, red and orange to light yellow (t = 1); lightness grows
/// linearly, so that the ramp also reads in grey. t beyond [0, 1] is clamped; not a number is green, which the ramp
/// does not contain.
DisplayColour heatColour(float t);

/// For signed values: blue (t = -1) over near white (0) to red (1), equally dark at both ends. Clamped; not a number is
/// green.
DisplayColour divergingColour(float t);

struct ScalarRange {
  float low = 0.0f;
  float high = 1.0f;
};

/// The range of a channel's finite values, without the share `outliers` at the upper end, so that a few fireflies do
/// not make a map black. {0, 1} if no value is finite, and never empty: high > low.
ScalarRange rangeOf(const Image& image, std::string_view channel, double outliers = 0.0);

/// The channel as a heat map: `range.low` becomes heatColour(0), `range.high` heatColour(1). The result has the
/// channels R, G, B and "encoding" = "srgb". Throws `Error` (kind Usage) if there is no such channel.
Image falseColour(const Image& image, std::string_view channel, ScalarRange range);

}  // namespace steradian
