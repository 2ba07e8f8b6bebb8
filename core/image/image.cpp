#include "steradian/core/image/image.h"

#include <algorithm>
#include <cstdint>
#include <new>
#include <utility>

#include "steradian/core/base/diagnostics.h"

namespace steradian {
namespace {

/// More bytes than any 64-bit processor of today can address.
constexpr std::uint64_t addressableBytes = std::uint64_t{1} << 47;

void checkShape(int width, int height, const std::vector<std::string>& channels, const ImageWindow& window) {
  if (width < 1 || height < 1 || width > Image::maxSide || height > Image::maxSide) {
    throw Error(ErrorKind::Usage, "an image cannot have " + std::to_string(width) + " x " + std::to_string(height) +
                                      " pixels: each side must lie in [1, " + std::to_string(Image::maxSide) + "]");
  }
  if (window.fullWidth < 1 || window.fullHeight < 1) {
    throw Error(ErrorKind::Usage, "the full picture of an image cannot have " + std::to_string(window.fullWidth) +
                                      " x " + std::to_string(window.fullHeight) + " pixels");
  }
  if (channels.empty()) throw Error(ErrorKind::Usage, "an image needs at least one channel");
  std::vector<std::string> sorted = channels;
  std::sort(sorted.begin(), sorted.end());
  if (sorted.front().empty()) throw Error(ErrorKind::Usage, "a channel of an image has no name");
  const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
  if (twin != sorted.end()) throw Error(ErrorKind::Usage, "an image has two channels named \"" + *twin + "\"");
}

std::vector<float> allocate(int width, int height, std::size_t channels) {
  const auto pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  try {
    if (channels > addressableBytes / sizeof(float) / pixels) throw std::bad_alloc();
    return std::vector<float>(static_cast<std::size_t>(pixels) * channels);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::Memory, "not enough memory for an image of " + std::to_string(width) + " x " +
                                       std::to_string(height) + " pixels with " + std::to_string(channels) +
                                       " channels");
  }
}

}  // namespace

Image::Image(int width, int height, std::vector<std::string> channels, std::optional<ImageWindow> window)
    : width_(width),
      height_(height),
      channels_(std::move(channels)),
      window_(window.value_or(ImageWindow{0, 0, width, height})) {
  checkShape(width_, height_, channels_, window_);
  data_ = allocate(width_, height_, channels_.size());
}

std::optional<int> Image::findChannel(std::string_view name) const {
  const auto found = std::find(channels_.begin(), channels_.end(), name);
  if (found == channels_.end()) return std::nullopt;
  return static_cast<int>(found - channels_.begin());
}

int Image::channel(std::string_view name) const {
  if (const auto found = findChannel(name)) return *found;
  std::string known;
  for (const std::string& c : channels_) known += (known.empty() ? "" : ", ") + c;
  throw Error(ErrorKind::Usage, Diagnostic{Severity::Error,
                                           {},
                                           "the image has no channel \"" + std::string(name) + "\"; it has " + known,
                                           didYouMean(name, channels_)});
}

std::optional<std::array<int, 3>> Image::findRgb() const {
  const auto r = findChannel("R"), g = findChannel("G"), b = findChannel("B");
  if (!r || !g || !b) return std::nullopt;
  return std::array<int, 3>{*r, *g, *b};
}

}  // namespace steradian
