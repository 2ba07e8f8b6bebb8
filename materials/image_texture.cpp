#include "steradian/materials/image_texture.h"

#include <cmath>

namespace steradian {
namespace {

using Wrap = ImageTexture::Wrap;

/// Where a parameter falls in the picture's range, as far as one period goes.
float wrapped(float t, Wrap wrap) {
  if (wrap == Wrap::Repeat) return t - std::floor(t);
  if (wrap != Wrap::Mirror) return t;
  const float folded = t - 2.0f * std::floor(0.5f * t);
  return folded > 1.0f ? 2.0f - folded : folded;
}

/// Two neighbours along one axis, and whether each of them is in the picture.
struct Span {
  ColourImage::Neighbours<float> at;
  bool firstInside, secondInside;
};

Span spanOf(float parameter, Wrap wrap, ImageTexture::Filter filter, std::uint32_t size) {
  const auto count = static_cast<float>(size), last = static_cast<float>(size - 1);
  const bool nearest = filter == ImageTexture::Filter::Nearest;
  // Beyond a pixel's width outside of the picture nothing changes; NaN becomes the low end.
  const float place = clamp(wrapped(parameter, wrap) * count - (nearest ? 0.0f : 0.5f), -2.0f, count + 1.0f);
  const float first = std::floor(place), second = first + (nearest ? 0.0f : 1.0f);
  const auto index = [&](float i) {
    if (wrap == Wrap::Repeat) i = i < 0.0f ? i + count : i > last ? i - count : i;
    return static_cast<std::uint32_t>(clamp(i, 0.0f, last));
  };
  const auto inside = [&](float i) { return wrap != Wrap::Black || (i >= 0.0f && i <= last); };
  return {{index(first), index(second), place - first}, inside(first), inside(second)};
}

Rgb clamped(Rgb c) { return {clamp(c.r, 0.0f, 1.0f), clamp(c.g, 0.0f, 1.0f), clamp(c.b, 0.0f, 1.0f)}; }

}  // namespace

ImageTextureLookup::ImageTextureLookup(const ImageTexture& texture)
    : picture_(texture.image),
      wrapU_(texture.wrapU),
      wrapV_(texture.wrapV),
      filter_(texture.filter),
      repeatU_(texture.repeatU),
      repeatV_(texture.repeatV) {}

Rgb ImageTextureLookup::value(Vec2f uv) const {
  const Span x = spanOf(uv.x * repeatU_, wrapU_, filter_, picture_.width());
  const Span y = spanOf(uv.y * repeatV_, wrapV_, filter_, picture_.height());
  const std::uint32_t bottom = picture_.height() - 1;
  const auto texel = [&](std::uint32_t column, bool columnInside, std::uint32_t row, bool rowInside) {
    return columnInside && rowInside ? picture_.texel<float>(column, bottom - row) : Rgb{};
  };
  const auto along = [&](std::uint32_t row, bool rowInside) {
    const Rgb first = texel(x.at.first, x.firstInside, row, rowInside);
    if (filter_ == ImageTexture::Filter::Nearest) return first;
    return first * (1.0f - x.at.between) + texel(x.at.second, x.secondInside, row, rowInside) * x.at.between;
  };
  const Rgb lower = along(y.at.first, y.firstInside);
  if (filter_ == ImageTexture::Filter::Nearest) return clamped(lower);
  return clamped(lower * (1.0f - y.at.between) + along(y.at.second, y.secondInside) * y.at.between);
}

}  // namespace steradian
