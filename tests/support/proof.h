#pragma once
/// The whole ladder of proof for a warp, a density or a distribution, in one line:
///
///     EXPECT_TRUE(prove([](auto f) { return UniformCone<decltype(f)>{0.3f}; }));
///     EXPECT_TRUE(prove(PiecewiseConstant2D(weights, 5, 3), {.edgeShare = 1e-4}));
///     EXPECT_TRUE(prove(mixture, {.inverse = false, .lanes = false}));
///
/// It takes the sampler under test as a function of a number of type F, which makes it for F = float and for F =
/// Lanes<N>; or as a value, which is then used at every width (as tables are; `lanes = false` for width 1 alone). What
/// is proved:
/// - normalisation, chi-square, "the pdf of a sample is pdf() of its place", range and finiteness over adversarial
///   random numbers: checkDirectionSampler or a similar check, chosen by what sample() returns;
/// - invert(sample(u)) is u, or a preimage of the same sample (poles and seams have several), and in [0, 1)^2;
/// - width 1 and width N give the same bits: samples, densities of them and of other places, inverses.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

#include "steradian/tests/support/lanes_check.h"
#include "steradian/tests/support/statistics.h"

namespace steradian::test {

namespace proof {

/// One draw, in any of the forms that samplers have: a direction (Vec3), a point (Vec2), a number (F) or an index
/// (UintOf<F>).
template <class X, class F>
struct Drawn {
  X value;
  F pdf;
};

template <class T, class F>
concept DrawsAt = requires(const T& sampler, F choice) {
  sampler.sample(choice);
}
|| requires(const T& sampler, Vec2<F> u) { sampler.sample(u); }
|| requires(const T& sampler, F choice, Vec2<F> u) { sampler.sample(choice, u); };

template <class F, class T, class S>
auto drawnOf(const T& sampler, const S& s) {
  if constexpr (requires { s.wi; }) {
    return Drawn<Vec3<F>, F>{s.wi, s.pdf};
  } else if constexpr (requires { s.probability; }) {
    return Drawn<UintOf<F>, F>{s.index, s.probability};
  } else if constexpr (requires { s.point; }) {
    return Drawn<Vec2<F>, F>{s.point, s.pdf};
  } else if constexpr (requires { s.pdf; }) {
    return Drawn<F, F>{s.x, s.pdf};
  } else {
    return Drawn<S, F>{s, sampler.pdf(s)};
  }
}

template <class F, class T>
auto draw(const T& sampler, F choice, Vec2<F> u) {
  if constexpr (requires { sampler.sample(u.x); }) {
    return drawnOf<F>(sampler, sampler.sample(u.x));
  } else if constexpr (requires { sampler.sample(u); }) {
    return drawnOf<F>(sampler, sampler.sample(u));
  } else {
    return drawnOf<F>(sampler, sampler.sample(choice, u));
  }
}

/// The numbers of one draw.
struct Numbers {
  float choice;
  Vec2f u;
};
/// All pairs of awkward numbers, then random ones.
inline std::vector<Numbers> numbersOfDraws() {
  std::vector<Numbers> all;
  constexpr std::array<float, 7> awkward{0.0f, 0x1p-24f, 0.25f, 0.5f, 0x1.000002p-1f, 0x1.fffffcp-1f, kOneMinusEpsilon};
  for (const float x : awkward) {
    for (const float y : awkward) all.push_back({0.5f * (x + y), {x, y}});
  }
  const auto us = unitNumbers(1999, 2), vs = unitNumbers(1999, 3), choices = unitNumbers(1999, 4);
  for (std::size_t i = 0; i < us.size(); ++i) all.push_back({choices[i], {us[i], vs[i]}});
  return all;
}

inline std::string textOf(const Numbers& n) {
  return "random numbers (" + testing::PrintToString(n.choice) + "; " + testing::PrintToString(n.u.x) + ", " +
         testing::PrintToString(n.u.y) + ")";
}

/// 0 for an index, whose probability has a function of its own.
template <class T, class X>
double densityAt(const T& sampler, X x) {
  if constexpr (requires { sampler.pdf(x); }) {
    return static_cast<double>(sampler.pdf(x));
  } else {
    return 0.0;
  }
}

// --- The rungs of statistics ------------------------------------------------------------------------------------

template <class T>
testing::AssertionResult checkSampling(const T& sampler, const CheckOptions& options) {
  using X = decltype(draw<float>(sampler, 0.0f, {}).value);
  const auto drawOne = [&](float choice, Vec2f u) { return draw<float>(sampler, choice, u); };
  const auto pdf = [&](X x) { return densityAt(sampler, x); };
  if constexpr (std::is_same_v<X, Vec3f>) {
    const auto sample = [&](float choice, Vec2f u) {
      const auto d = drawOne(choice, u);
      return DirectionSample<float>{d.value, d.pdf};
    };
    return checkDirectionSampler(sample, pdf, options);
  } else if constexpr (std::is_same_v<X, Vec2f>) {
    const auto sample = [&](float choice, Vec2f u) {
      const auto d = drawOne(choice, u);
      return PlaneSample{d.value, d.pdf};
    };
    return checkPlaneSampler(sample, pdf, options);
  } else if constexpr (std::is_same_v<X, float>) {
    const auto sample = [&](float choice, Vec2f u) {
      const auto d = drawOne(choice, u);
      return LineSample{d.value, d.pdf};
    };
    return checkLineSampler(sample, pdf, options);
  } else {
    const auto sample = [&](float choice, Vec2f u) {
      const auto d = drawOne(choice, u);
      return IndexSample{d.value, d.pdf};
    };
    std::vector<double> probabilities;
    for (std::size_t i = 0; i < sampler.size(); ++i) probabilities.push_back(sampler.probability(i));
    return checkIndexSampler(sample, probabilities, options);
  }
}

// --- The rung of the inverse ------------------------------------------------------------------------------------

inline double difference(float a, float b) { return std::abs(static_cast<double>(a) - b); }
inline double difference(Vec2f a, Vec2f b) { return std::max(difference(a.x, b.x), difference(a.y, b.y)); }
inline double difference(Vec3f a, Vec3f b) {
  return std::max({difference(a.x, b.x), difference(a.y, b.y), difference(a.z, b.z)});
}
inline bool isUnitNumber(float u) { return u >= 0.0f && u < 1.0f; }
inline bool isUnitNumber(Vec2f u) { return isUnitNumber(u.x) && isUnitNumber(u.y); }

/// The unit of differences between samples.
template <class X>
double sizeOfDomain(const CheckOptions& options) {
  const Rectangle& r = options.domain;
  if constexpr (std::is_same_v<X, Vec3f>) {
    return std::min(1.0, options.grid.focus);
  } else if constexpr (std::is_same_v<X, Vec2f>) {
    return std::min(r.x1 - r.x0, r.y1 - r.y0);
  } else {
    return r.x1 - r.x0;
  }
}

template <class T>
testing::AssertionResult checkInverse(const T& sampler, const CheckOptions& options) {
  for (const Numbers& n : numbersOfDraws()) {
    const auto d = draw<float>(sampler, n.choice, n.u);
    if (!(d.pdf > 0.0f)) continue;
    const auto back = sampler.invert(d.value);
    const auto used = [&] {
      if constexpr (std::is_same_v<decltype(back), const float>) {
        return n.u.x;
      } else {
        return n.u;
      }
    }();
    if (!isUnitNumber(back)) return testing::AssertionFailure() << textOf(n) << ": invert() leaves [0, 1)";
    if (difference(back, used) <= options.inverseTolerance) continue;
    Vec2f again = n.u;
    if constexpr (std::is_same_v<decltype(back), const float>) {
      again.x = back;
    } else {
      again = back;
    }
    const double size = sizeOfDomain<std::remove_const_t<decltype(d.value)>>(options);
    const double apart = difference(draw<float>(sampler, n.choice, again).value, d.value);
    if (!(apart <= options.inverseTolerance * size)) {
      return testing::AssertionFailure() << textOf(n) << ": invert() gives (" << again.x << ", " << again.y
                                         << "), whose sample is " << apart << " apart";
    }
  }
  return testing::AssertionSuccess();
}

// --- The rung of the lanes --------------------------------------------------------------------------------------

/// Any place of the domain, and around it.
template <class X>
X placeAt(Vec2f u, const CheckOptions& options) {
  const auto within = [](double low, double high, float t) {
    return static_cast<float>(low + (high - low) * (1.2 * t - 0.1));
  };
  const Rectangle& r = options.domain;
  if constexpr (std::is_same_v<X, Vec3f>) {
    const float z = 1.0f - 2.0f * u.x, s = safeSqrt(1.0f - z * z);
    const SinCos<float> phi = sinCosTwoPi(u.y);
    return {s * phi.cos, s * phi.sin, z};
  } else if constexpr (std::is_same_v<X, Vec2f>) {
    return {within(r.x0, r.x1, u.x), within(r.y0, r.y1, u.y)};
  } else {
    return within(r.x0, r.x1, u.x);
  }
}

template <int N, class T, class Wide>
testing::AssertionResult checkLanes(const T& sampler, const Wide& wideSampler, const CheckOptions& options) {
  using W = Lanes<N>;
  using X = decltype(draw<float>(sampler, 0.0f, {}).value);
  using WideX = decltype(draw<W>(wideSampler, W(0.0f), {}).value);
  const std::vector<Numbers> all = numbersOfDraws();
  for (std::size_t start = 0; start + N <= all.size(); start += N) {
    W choice(0.0f);
    Vec2<W> u{W(0.0f), W(0.0f)};
    WideX place{};
    for (int i = 0; i < N; ++i) {
      const Numbers& n = all[start + static_cast<std::size_t>(i)];
      setLane(choice, i, n.choice);
      setLane(u, i, n.u);
      if constexpr (!std::is_same_v<X, std::uint32_t>) setLane(place, i, placeAt<X>(n.u, options));
    }
    const auto wide = draw<W>(wideSampler, choice, u);
    const auto same = [&](const auto& values, const auto& one) {
      for (int i = 0; i < N; ++i) {
        if (!sameBits(lane(values, i), one(all[start + static_cast<std::size_t>(i)]))) return false;
      }
      return true;
    };
    const auto failure = [&](const char* what) {
      return testing::AssertionFailure() << "width " << N << " differs from width 1: " << what << ", "
                                         << textOf(all[start]) << " and the following";
    };
    const auto drawOne = [&](const Numbers& n) { return draw<float>(sampler, n.choice, n.u); };
    if (!same(wide.value, [&](const Numbers& n) { return drawOne(n).value; })) return failure("sample");
    if (!same(wide.pdf, [&](const Numbers& n) { return drawOne(n).pdf; })) return failure("pdf of a sample");
    if constexpr (!std::is_same_v<X, std::uint32_t>) {
      if (!same(wideSampler.pdf(wide.value), [&](const Numbers& n) { return sampler.pdf(drawOne(n).value); })) {
        return failure("pdf() of a sample");
      }
      if (!same(wideSampler.pdf(place), [&](const Numbers& n) { return sampler.pdf(placeAt<X>(n.u, options)); })) {
        return failure("pdf() of some place");
      }
      if constexpr (requires { wideSampler.invert(wide.value); }) {
        if (!same(wideSampler.invert(wide.value), [&](const Numbers& n) { return sampler.invert(drawOne(n).value); })) {
          return failure("invert()");
        }
      }
    }
  }
  return testing::AssertionSuccess();
}

template <class T, class Wide>
testing::AssertionResult proveBoth(const T& sampler, const Wide& wideSampler, const CheckOptions& options) {
  constexpr bool hasInverse = requires { sampler.invert(draw<float>(sampler, 0.0f, {}).value); };
  if (hasInverse != options.inverse) {
    return testing::AssertionFailure() << "there is " << (hasInverse ? "an" : "no")
                                       << " invert(), unlike options.inverse";
  }
  if (const auto result = checkSampling(sampler, options); !result) return result;
  if constexpr (hasInverse) {
    if (const auto result = checkInverse(sampler, options); !result) return result;
  }
  if constexpr (DrawsAt<Wide, Lanes<8>>) {
    if (!options.lanes) return testing::AssertionFailure() << "it has lanes, unlike options.lanes";
    return checkLanes<8>(sampler, wideSampler, options);
  } else {
    if (options.lanes) return testing::AssertionFailure() << "it has no lanes, unlike options.lanes";
    return testing::AssertionSuccess();
  }
}

}  // namespace proof

/// The ladder. `makeOrValue`: see above. It takes about 0.1 s, so it belongs into files named *_stat_test.cpp.
template <class T>
testing::AssertionResult prove(const T& makeOrValue, const CheckOptions& options = {}) {
  if constexpr (std::is_invocable_v<T, float>) {
    return proof::proveBoth(makeOrValue(0.0f), makeOrValue(Lanes<8>(0.0f)), options);
  } else {
    return proof::proveBoth(makeOrValue, makeOrValue, options);
  }
}
/// For what has no parameters: prove<UniformSphere>().
template <template <class> class T>
testing::AssertionResult prove(const CheckOptions& options = {}) {
  return proof::proveBoth(T<float>{}, T<Lanes<8>>{}, options);
}

}  // namespace steradian::test
