#include "steradian/core/film/filter.h"

#include <fmt/format.h>

#include <array>

#include "steradian/core/base/diagnostics.h"

namespace steradian {

namespace {

constexpr std::array<FilterType, 5> kTypes{FilterType::Box, FilterType::Triangle, FilterType::Gaussian,
                                           FilterType::Mitchell, FilterType::BlackmanHarris};
constexpr std::size_t kBins = 1024;  // even: the zeros of Mitchell's filter lie between bins
constexpr float kMaxRadius = 64.0f;

/// Mitchell & Netravali's cubic with B = C = 1/3, for |x| = 2t, times 18.
float mitchell(float t) {
  const float x = 2.0f * t;
  if (x < 1.0f) return (21.0f * x - 36.0f) * x * x + 16.0f;
  return ((-7.0f * x + 36.0f) * x - 60.0f) * x + 32.0f;
}

float blackmanHarris(float t) {
  const auto cosine = [t](float k) { return sinCosTwoPi(0.5f * k * t).cos; };
  return 0.35875f + 0.48829f * cosine(1.0f) + 0.14128f * cosine(2.0f) + 0.01168f * cosine(3.0f);
}

}  // namespace

std::optional<FilterType> filterTypeOf(std::string_view name) {
  for (const FilterType type : kTypes) {
    if (name == nameOf(type)) return type;
  }
  return std::nullopt;
}

std::string_view nameOf(FilterType type) {
  switch (type) {
    case FilterType::Box:
      return "box";
    case FilterType::Triangle:
      return "triangle";
    case FilterType::Gaussian:
      return "gaussian";
    case FilterType::Mitchell:
      return "mitchell";
    case FilterType::BlackmanHarris:
      break;
  }
  return "blackman-harris";
}

float defaultRadius(FilterType type) {
  switch (type) {
    case FilterType::Box:
      return 0.5f;
    case FilterType::Triangle:
      return 1.0f;
    case FilterType::Mitchell:
      return 2.0f;
    case FilterType::Gaussian:
    case FilterType::BlackmanHarris:
      break;
  }
  return 1.5f;
}

Filter::Filter(FilterType type, float radius) : type_(type), radius_(radius) {
  if (!(radius > 0.0f && radius <= kMaxRadius)) {
    throw Error(ErrorKind::Usage,
                fmt::format("the radius of the {} filter is {}: it must be above 0 and at most {} pixels", nameOf(type),
                            radius, kMaxRadius));
  }
  if (type != FilterType::Box && type != FilterType::Triangle) table_ = std::make_shared<const Table>(tabulate(*this));
}

float Filter::value(float x) const {
  // Our own polynomials, not libm: the table must be the same everywhere.
  const float t = absolute(x) / radius_;
  if (!(t < 1.0f)) return 0.0f;
  switch (type_) {
    case FilterType::Box:
      return 1.0f;
    case FilterType::Triangle:
      return 1.0f - t;
    case FilterType::Gaussian:
      return exponential(-4.5f * t * t) - exponential(-4.5f);
    case FilterType::Mitchell:
      return mitchell(t);
    case FilterType::BlackmanHarris:
      break;
  }
  return blackmanHarris(t);
}

Filter::Table Filter::tabulate(const Filter& filter) {
  std::vector<float> values, magnitudes;
  for (std::size_t i = 0; i < kBins; ++i) {
    const float centre = (static_cast<float>(i) + 0.5f) / static_cast<float>(kBins);
    values.push_back(filter.value((2.0f * centre - 1.0f) * filter.radius_));
    magnitudes.push_back(absolute(values.back()));
  }
  PiecewiseConstant1D density(magnitudes, -filter.radius_, filter.radius_);
  double signedSum = 0.0;  // of the probabilities with the sign of f: what the mean weight would be
  for (std::size_t i = 0; i < kBins; ++i) {
    signedSum += values[i] < 0.0f ? -density.probability(i) : density.probability(i);
  }
  std::vector<float> weights;
  weights.reserve(values.size());
  for (const float f : values) weights.push_back(static_cast<float>((f < 0.0f ? -1.0 : 1.0) / signedSum));
  return {std::move(density), std::move(weights)};
}

Filter filterOf(std::string_view name, std::optional<float> radius) {
  const auto type = filterTypeOf(name);
  if (!type) {
    std::vector<std::string_view> names;
    names.reserve(kTypes.size());
    for (const FilterType known : kTypes) names.push_back(nameOf(known));
    throw Error(ErrorKind::Usage,
                Diagnostic{Severity::Error, {}, fmt::format("unknown filter \"{}\"", name), didYouMean(name, names)});
  }
  return Filter(*type, radius.value_or(defaultRadius(*type)));
}

}  // namespace steradian
