#pragma once
/// Densities of directions as values ("The Rest of Your Life", chapter 10): what can be sampled and evaluated, and
/// mixtures of such. Directions are unit vectors in world space; densities are per steradian; a sample with pdf 0 is no
/// sample.
#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>

#include "steradian/core/math/frame.h"
#include "steradian/core/sampling/warp.h"
#include "steradian/core/transport/scattering.h"

namespace STERADIAN_API steradian {

template <class P, class F>
concept SimpleDirectionPdf = requires(const P& p, Vec2<F> u, Vec3<F> wi) {
  { p.sample(u) } -> std::same_as<DirectionSample<F>>;
  { p.pdf(wi) } -> std::convertible_to<F>;
};

/// A density whose sampling first chooses among parts, with a random number of its own.
template <class P, class F>
concept ChoosingDirectionPdf = requires(const P& p, F choice, Vec2<F> u, Vec3<F> wi) {
  { p.sample(choice, u) } -> std::same_as<DirectionSample<F>>;
  { p.pdf(wi) } -> std::convertible_to<F>;
};

/// `sample` draws with exactly the density `pdf`: pdf integrates to 1 less the probability of "no sample", and the pdf
/// of a sample is pdf(sample.wi).
template <class P, class F>
concept DirectionPdf = SimpleDirectionPdf<P, F> || ChoosingDirectionPdf<P, F>;

/// A sample of either kind; `choice` goes unused where there is nothing to choose.
template <class F, DirectionPdf<F> P>
DirectionSample<F> sampleDirectionPdf(const P& p, F choice, Vec2<F> u) {
  if constexpr (ChoosingDirectionPdf<P, F>) {
    return p.sample(choice, u);
  } else {
    return p.sample(u);
  }
}

/// Uniform over all directions: 1 / 4 pi.
template <class F>
struct SpherePdf {
  DirectionSample<F> sample(Vec2<F> u) const { return {UniformSphere<F>::sample(u), F(kInvFourPi)}; }
  F pdf(Vec3<F> wi) const { return UniformSphere<F>::pdf(wi); }
  Vec2<F> invert(Vec3<F> wi) const { return UniformSphere<F>::invert(wi); }
};

/// Uniform over the hemisphere about a unit axis: 1 / 2 pi. Directions below the horizon by a cosine of up to 2^-22
/// count as inside: they are samples, rounded.
template <class F>
class HemispherePdf {
 public:
  explicit HemispherePdf(Vec3<F> axis) : frame_(Frame<F>::fromZ(axis)) {}

  DirectionSample<F> sample(Vec2<F> u) const {
    const Vec3<F> wi = frame_.toWorld(UniformHemisphere<F>::sample(u));
    return {wi, pdf(wi)};
  }
  F pdf(Vec3<F> wi) const { return select(dot(wi, frame_.z) >= F(-0x1p-22f), F(kInvTwoPi), F(0.0f)); }
  Vec2<F> invert(Vec3<F> wi) const { return UniformHemisphere<F>::invert(frame_.toLocal(wi)); }

 private:
  Frame<F> frame_;
};

/// Proportional to the cosine with a unit axis: cos / pi, 0 below the horizon.
template <class F>
class CosinePdf {
 public:
  explicit CosinePdf(Vec3<F> axis) : frame_(Frame<F>::fromZ(axis)) {}
  explicit CosinePdf(const Frame<F>& frame) : frame_(frame) {}

  DirectionSample<F> sample(Vec2<F> u) const {
    const Vec3<F> wi = frame_.toWorld(CosineHemisphere<F>::sample(u));
    return {wi, pdf(wi)};
  }
  F pdf(Vec3<F> wi) const { return maximum(dot(wi, frame_.z), F(0.0f)) * F(kInvPi); }
  Vec2<F> invert(Vec3<F> wi) const { return CosineHemisphere<F>::invert(frame_.toLocal(wi)); }

 private:
  Frame<F> frame_;
};

/// One of several, chosen by weight.
template <class F>
struct WeightedChoice {
  UintOf<F> index;  ///< below the number of weights; 0 when all weights are zero
  F rest;           ///< the random number that remains, again uniform in [0, 1)
};

/// The index that `choice` in [0, 1) falls on, for weights >= 0 of any sum (inverse of the cumulative sum). An index of
/// zero weight is never chosen unless all weights are zero.
template <class F>
WeightedChoice<F> chooseByWeight(F choice, std::span<const F> weights, F total) {
  const F target = choice * total;
  UintOf<F> index(0u);
  F low(0.0f), width(0.0f), sum(0.0f);
  MaskOf<F> found(false);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    // Where rounding leaves the target above the sum of all, the last possible index stays.
    const MaskOf<F> take = (!found) & (weights[i] > F(0.0f));
    index = select(take, UintOf<F>(static_cast<std::uint32_t>(i)), index);
    low = select(take, sum, low);
    width = select(take, weights[i], width);
    sum += weights[i];
    found = found | (take & (target < sum));
  }
  const F rest = select(width > F(0.0f), (target - low) / width, F(0.0f));
  return {index, clamp(rest, F(0.0f), F(kOneMinusEpsilon))};
}

namespace detail {
template <class F>
F sumOf(std::span<const F> weights) {
  F total(0.0f);
  for (const F& w : weights) total += w;
  return total;
}

/// The sample of a mixture: the chosen part's direction, with the mixture's marginal density of it.
template <class F, class Mixture>
DirectionSample<F> mixtureSample(const Mixture& mixture, Vec3<F> wi, F partPdf) {
  return {wi, select(partPdf > F(0.0f), mixture.pdf(wi), F(0.0f))};
}
}  // namespace detail

/// sum_i w_i p_i for any number of parts of any kinds, and weights >= 0 that need not sum to 1 (they are divided by
/// their sum; all zero: no sample). The density of a sample is the marginal one: that of the direction, whichever part
/// made it.
template <class F, DirectionPdf<F>... Parts>
class MixturePdf {
 public:
  static constexpr std::size_t size = sizeof...(Parts);

  MixturePdf(std::array<F, size> weights, Parts... parts)
      : weights_(weights), parts_(std::move(parts)...), total_(detail::sumOf(std::span<const F>(weights_))) {}

  DirectionSample<F> sample(F choice, Vec2<F> u) const {
    const WeightedChoice<F> chosen = chooseByWeight(choice, std::span<const F>(weights_), total_);
    DirectionSample<F> part;
    const auto draw = [&](std::uint32_t i, const auto& p) {
      const MaskOf<F> mine = chosen.index == UintOf<F>(i);
      if (!any(mine)) return;
      const DirectionSample<F> s = sampleDirectionPdf(p, chosen.rest, u);
      part.wi = select(mine, s.wi, part.wi);
      part.pdf = select(mine, s.pdf, part.pdf);
    };
    forEachPart(draw);
    return detail::mixtureSample(*this, part.wi, part.pdf);
  }

  F pdf(Vec3<F> wi) const {
    F sum(0.0f);
    forEachPart([&](std::uint32_t i, const auto& p) {
      // A part that cannot be chosen may have any density, even an infinite one.
      sum += select(weights_[i] > F(0.0f), weights_[i] * p.pdf(wi), F(0.0f));
    });
    return select(total_ > F(0.0f), sum / total_, F(0.0f));
  }

 private:
  template <class Visitor>
  void forEachPart(Visitor&& visit) const {
    std::apply(
        [&](const Parts&... p) {
          std::uint32_t i = 0;
          (visit(i++, p), ...);
        },
        parts_);
  }

  std::array<F, size> weights_;
  std::tuple<Parts...> parts_;
  F total_;
};
template <class F, std::size_t N, class... Parts>
MixturePdf(std::array<F, N>, Parts...) -> MixturePdf<F, Parts...>;

/// The same for a number of parts that is known only when the program runs; weights and parts, one each, are the
/// caller's and must outlive this.
template <class F, DirectionPdf<F> Part>
class MixtureSpanPdf {
 public:
  MixtureSpanPdf(std::span<const F> weights, std::span<const Part> parts)
      : weights_(weights), parts_(parts), total_(detail::sumOf(weights)) {}

  DirectionSample<F> sample(F choice, Vec2<F> u) const {
    const WeightedChoice<F> chosen = chooseByWeight(choice, weights_, total_);
    DirectionSample<F> part;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const MaskOf<F> mine = chosen.index == UintOf<F>(static_cast<std::uint32_t>(i));
      if (!any(mine)) continue;
      const DirectionSample<F> s = sampleDirectionPdf(parts_[i], chosen.rest, u);
      part.wi = select(mine, s.wi, part.wi);
      part.pdf = select(mine, s.pdf, part.pdf);
    }
    return detail::mixtureSample(*this, part.wi, part.pdf);
  }

  F pdf(Vec3<F> wi) const {
    F sum(0.0f);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      sum += select(weights_[i] > F(0.0f), weights_[i] * parts_[i].pdf(wi), F(0.0f));
    }
    return select(total_ > F(0.0f), sum / total_, F(0.0f));
  }

 private:
  std::span<const F> weights_;
  std::span<const Part> parts_;
  F total_;
};
template <class F, class Part>
MixtureSpanPdf(std::span<const F>, std::span<const Part>) -> MixtureSpanPdf<F, Part>;

}  // namespace steradian
