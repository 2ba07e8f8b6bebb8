#include "steradian/core/film/filter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "steradian/tests/support/proof.h"

namespace steradian {
namespace {

using namespace test;

/// A filter as a density of offsets: |f(x) f(y)| over its integral. The sample's pdf comes from its weight, which is
/// f / pdf with f of integral 1.
class FilterDensity {
 public:
  explicit FilterDensity(const Filter& filter) : filter_(filter), integral_(lineIntegral(false)) {
    normalisation_ = lineIntegral(true) / integral_;
  }

  template <class F>
  struct Sample {
    Vec2<F> point;
    F pdf;
  };
  Sample<float> sample(Vec2f u) const {
    const FilterSample<float> s = filter_.sample(u);
    const float f = filter_.value(s.offset.x) * filter_.value(s.offset.y);
    const double normalised = static_cast<double>(f) / (integral_ * integral_ * normalisation_ * normalisation_);
    return {s.offset, static_cast<float>(normalised / static_cast<double>(s.weight))};
  }
  float pdf(Vec2f p) const {
    const double f = std::abs(static_cast<double>(filter_.value(p.x)) * static_cast<double>(filter_.value(p.y)));
    return static_cast<float>(f / (integral_ * integral_));
  }

 private:
  /// Of |f|, or of f.
  double lineIntegral(bool withSign) const {
    const double r = static_cast<double>(filter_.radius());
    return integrate(
        [&](double x) {
          const auto f = static_cast<double>(filter_.value(static_cast<float>(x)));
          return withSign ? f : std::abs(f);
        },
        -r, r);
  }

  Filter filter_;
  double integral_;       ///< of |f| along one axis
  double normalisation_;  ///< the integral of f over that of |f|
};

TEST(FilterStatistics, OffsetsHaveTheDensityOfTheFilter) {
  for (const FilterType type : {FilterType::Box, FilterType::Triangle, FilterType::Gaussian, FilterType::Mitchell,
                                FilterType::BlackmanHarris}) {
    const Filter filter(type);
    const double r = static_cast<double>(filter.radius());
    CheckOptions options;
    options.domain = {-r, r, -r, r};
    options.noSample = std::nullopt;  // on the rim, where the filter is 0
    options.quadratureTolerance = 1e-6;
    options.edgeShare = 0.05;  // a table of 1024 bins near the zeros of the filter
    options.pdfTolerance = 0.02;
    options.inverse = options.lanes = false;
    EXPECT_TRUE(prove(FilterDensity(filter), options)) << nameOf(type);
  }
}

}  // namespace
}  // namespace steradian
