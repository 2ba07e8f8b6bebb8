#include "steradian/lights/environment_map.h"

#include <cmath>
#include <vector>

namespace steradian {
namespace {

constexpr double kPiDouble = 3.14159265358979323846;

/// The clamped colour of a pixel times the scale.
Rgb colourAt(const ColourImage& picture, Rgb scale, std::uint32_t column, std::uint32_t row) {
  const Rgb c = picture.texel<float>(column, row);
  return scale * Rgb{maximum(c.r, 0.0f), maximum(c.g, 0.0f), maximum(c.b, 0.0f)};
}

/// What the interpolated rows share of the integral of sin(theta) over theta: that of row j, whose hat is 1 at its
/// centre, 0 at those of its neighbours, and 1 as far as the pole where there is none. In closed form.
std::vector<double> rowIntegrals(std::uint32_t rows) {
  const double step = kPiDouble / rows;
  // Of the half hat from theta on.
  const auto half = [&](double theta) { return std::cos(theta) - (std::sin(theta + step) - std::sin(theta)) / step; };
  std::vector<double> integrals(rows);
  for (std::uint32_t j = 0; j < rows; ++j) {
    const double theta = (j + 0.5) * step, mirrored = kPiDouble - theta;
    const double above = j > 0 ? half(mirrored) : 1.0 - std::cos(theta);
    const double below = j + 1 < rows ? half(theta) : 1.0 - std::cos(mirrored);
    integrals[j] = above + below;
  }
  return integrals;
}

/// The integral of the radiance over all directions.
Rgb integralOf(const ColourImage& picture, Rgb scale) {
  const std::vector<double> weights = rowIntegrals(picture.height());
  double red = 0.0, green = 0.0, blue = 0.0;
  for (std::uint32_t row = 0; row < picture.height(); ++row) {
    for (std::uint32_t column = 0; column < picture.width(); ++column) {
      const Rgb c = colourAt(picture, scale, column, row);
      red += weights[row] * static_cast<double>(c.r);
      green += weights[row] * static_cast<double>(c.g);
      blue += weights[row] * static_cast<double>(c.b);
    }
  }
  const double width = 2.0 * kPiDouble / picture.width();
  return {static_cast<float>(width * red), static_cast<float>(width * green), static_cast<float>(width * blue)};
}

/// Per pixel the mean of the interpolated luminance (an eighth of both neighbours, along each axis) times the mean
/// sine.
std::vector<float> weightsOf(const ColourImage& picture, Rgb scale) {
  const std::uint32_t width = picture.width(), height = picture.height();
  const std::size_t columns = width;
  std::vector<float> along(columns * height);
  for (std::uint32_t row = 0; row < height; ++row) {
    const auto value = [&](std::uint32_t column) { return luminance(colourAt(picture, scale, column, row)); };
    for (std::uint32_t column = 0; column < width; ++column) {
      const std::uint32_t left = column > 0 ? column - 1 : width - 1, right = column + 1 < width ? column + 1 : 0;
      along[row * columns + column] = 0.75f * value(column) + 0.125f * (value(left) + value(right));
    }
  }
  std::vector<float> weights(columns * height);
  const double step = kPiDouble / height;
  for (std::uint32_t row = 0; row < height; ++row) {
    const std::uint32_t above = row > 0 ? row - 1 : row, below = row + 1 < height ? row + 1 : row;
    const auto sine = static_cast<float>((std::cos(row * step) - std::cos((row + 1.0) * step)) / step);
    for (std::size_t column = 0; column < columns; ++column) {
      const auto at = [&](std::uint32_t r) { return along[r * columns + column]; };
      weights[row * columns + column] = sine * (0.75f * at(row) + 0.125f * (at(above) + at(below)));
    }
  }
  return weights;
}

float turnOf(float degrees) {
  const double turns = static_cast<double>(degrees) / 360.0;
  return minimum(static_cast<float>(turns - std::floor(turns)), kOneMinusEpsilon);
}

}  // namespace

EnvironmentMap::EnvironmentMap(const ImageSky& sky, bool sampled)
    : picture_(sky.image), scale_(sky.scale), total_(integralOf(picture_, scale_)), turn_(turnOf(sky.rotation)) {
  if (sampled) makeTable();
}

EnvironmentMap::EnvironmentMap(const EnvironmentMap& map, bool sampled) : EnvironmentMap(map) {
  if (sampled && !table_) makeTable();
}

void EnvironmentMap::makeTable() {
  if (!(luminance(total_) > 0.0f)) return;
  table_ =
      std::make_shared<const PiecewiseConstant2D>(weightsOf(picture_, scale_), picture_.width(), picture_.height());
}

}  // namespace steradian
