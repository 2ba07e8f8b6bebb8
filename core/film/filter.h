#pragma once
/// Reconstruction filters, used by importance sampling: a camera sample is placed around the pixel centre with density
/// proportional to |f|, and weighted by the sign of f; the pixel is the plain mean (Ernst, Stamminger & Greiner 2006,
/// "Filter importance sampling").
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "steradian/core/sampling/distribution.h"

namespace STERADIAN_API steradian {

enum class FilterType { Box, Triangle, Gaussian, Mitchell, BlackmanHarris };
/// "box", "triangle", "gaussian", "mitchell", "blackman-harris"; nothing for any other name.
std::optional<FilterType> filterTypeOf(std::string_view name);
std::string_view nameOf(FilterType type);
/// The radius that the filter is usually given, pixels: 0.5, 1, 1.5, 2, 1.5.
float defaultRadius(FilterType type);

template <class F>
struct FilterSample {
  Vec2<F> offset;  ///< from the centre of the pixel, pixels; |x| and |y| at most the radius
  F weight;        ///< f / pdf with f normalised to integral 1: its mean is 1, and it is +-constant
};

/// A product f(x) f(y) with f even and 0 beyond the radius. With t = |x| / radius:
///
///     box               1
///     triangle          1 - t
///     gaussian          exp(-x^2 / 2 s^2) - exp(-radius^2 / 2 s^2), s = radius / 3
///     mitchell          Mitchell & Netravali 1988 with B = C = 1/3, stretched to the radius; has negative lobes
///     blackman-harris   0.35875 + 0.48829 cos(pi t) + 0.14128 cos(2 pi t) + 0.01168 cos(3 pi t)  (Harris 1978)
///
/// Box and triangle are sampled in closed form, the others from a table of 1024 bins per axis.
class Filter {
 public:
  /// Throws `Error` (kind Usage) unless the radius is in (0, 64] pixels.
  Filter(FilterType type, float radius);
  explicit Filter(FilterType type) : Filter(type, defaultRadius(type)) {}

  FilterType type() const { return type_; }
  float radius() const { return radius_; }
  /// f(x) of one axis, not normalised.
  float value(float x) const;

  template <class F>
  FilterSample<F> sample(Vec2<F> u) const {
    switch (type_) {
      case FilterType::Box: {
        const F r(radius_);
        return {{F(2.0f) * u.x * r - r, F(2.0f) * u.y * r - r}, F(1.0f)};
      }
      case FilterType::Triangle:
        return {{tent(u.x) * F(radius_), tent(u.y) * F(radius_)}, F(1.0f)};
      default:
        break;
    }
    const auto x = table_->density.sample(u.x), y = table_->density.sample(u.y);
    return {{x.x, y.x}, gather(table_->weights.data(), x.bin) * gather(table_->weights.data(), y.bin)};
  }

 private:
  struct Table {
    PiecewiseConstant1D density;  ///< of |f| on [-radius, radius]
    std::vector<float> weights;   ///< per bin: f / density, normalised
  };
  static Table tabulate(const Filter& filter);

  /// Inverse of the cumulative integral of 1 - |x|.
  template <class F>
  static F tent(F u) {
    const MaskOf<F> left = u < F(0.5f);
    const F distance = F(1.0f) - squareRoot(F(2.0f) * select(left, u, F(1.0f) - u));
    return select(left, -distance, distance);
  }

  FilterType type_;
  float radius_;
  std::shared_ptr<const Table> table_;
};

/// The filter of that name; no radius: its default one. Throws `Error` (kind Usage), with a suggestion, for an unknown
/// name or an impossible radius.
Filter filterOf(std::string_view name, std::optional<float> radius = std::nullopt);

}  // namespace steradian
