#include "steradian/core/colour/colour_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "steradian/core/base/diagnostics.h"
#include "steradian/core/colour/display.h"
#include "steradian/core/image/image_io.h"

namespace steradian {
namespace {

/// The grey channel, whichever other channels there are.
std::optional<int> findGrey(const Image& image) {
  if (image.channelCount() == 1) return 0;
  return image.findChannel("Y");
}

Image coloursOf(const Image& image, const std::string& name) {
  const auto rgb = image.findRgb();
  const auto grey = findGrey(image);
  if (!rgb && !grey) {
    throw Error(ErrorKind::Scene,
                fmt::format("\"{}\" is no picture: it has neither the channels R, G and B nor Y, but {}", name,
                            fmt::join(image.channels(), ", ")));
  }
  const std::vector<int> from = rgb ? std::vector<int>(rgb->begin(), rgb->end()) : std::vector<int>{*grey};
  Image colours(image.width(), image.height(),
                rgb ? std::vector<std::string>{"R", "G", "B"} : std::vector<std::string>{"Y"});
  colours.metadata() = image.metadata();
  auto to = colours.values().begin();
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      for (const int channel : from) *to++ = image.at(x, y, channel);
    }
  }
  return colours;
}

}  // namespace

ColourImage::ColourImage(std::shared_ptr<const Image> image) : image_(std::move(image)) {
  if (image_ == nullptr) throw Error(ErrorKind::Usage, "a picture needs an image");
  const auto rgb = image_->findRgb();
  if (!rgb && image_->channelCount() != 1) {
    throw Error(ErrorKind::Usage, "a picture needs the channels R, G and B, or a single one");
  }
  if (image_->values().size() > std::size_t{std::numeric_limits<std::int32_t>::max()}) {
    throw Error(ErrorKind::Usage, "a picture has at most 2^31 - 1 values");
  }
  width_ = static_cast<std::uint32_t>(image_->width());
  height_ = static_cast<std::uint32_t>(image_->height());
  stride_ = static_cast<std::uint32_t>(image_->channelCount());
  const std::array<int, 3> channels = rgb.value_or(std::array<int, 3>{0, 0, 0});
  const float* first = image_->values().data();
  red_ = first + channels[0];
  green_ = first + channels[1];
  blue_ = first + channels[2];
}

std::shared_ptr<const Image> readColourImage(const std::filesystem::path& path) {
  const std::string name = path.string();
  const Image file = readImage(path);
  if (file.isCropped()) {
    throw Error(ErrorKind::Scene, fmt::format("\"{}\" holds a part of a larger picture; a whole one is needed", name));
  }
  Image colours = coloursOf(file, name);
  linearise(colours);
  const auto values = colours.values();
  const auto bad = std::find_if(values.begin(), values.end(), [](float x) { return !std::isfinite(x); });
  if (bad != values.end()) {
    const auto pixel =
        static_cast<std::size_t>(bad - values.begin()) / static_cast<std::size_t>(colours.channelCount());
    const auto width = static_cast<std::size_t>(colours.width());
    throw Error(ErrorKind::Scene,
                fmt::format("\"{}\": the colour of pixel ({}, {}) is not finite", name, pixel % width, pixel / width));
  }
  return std::make_shared<const Image>(std::move(colours));
}

}  // namespace steradian
