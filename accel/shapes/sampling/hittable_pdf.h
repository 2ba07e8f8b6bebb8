#pragma once
/// Directions towards shapes as densities ("The Rest of Your Life", chapters 10 and 12: hittable_pdf).
#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "steradian/accel/shapes/sampling/sampled_shape_lanes.h"
#include "steradian/core/base/diagnostics.h"
#include "steradian/core/sampling/direction_pdf.h"

namespace STERADIAN_API steradian {

/// Several shapes of which one is chosen with a probability in proportion to its weight.
class TargetGroup {
 public:
  /// One weight >= 0 per shape, of any sum; no weights: all equal. All zero: no shape can be chosen. Throws Error
  /// (Usage) for weights of another number, negative or not finite.
  explicit TargetGroup(std::vector<SampledShape> shapes, std::span<const float> weights = {})
      : shapes_(std::move(shapes)) {
    if (!weights.empty() && weights.size() != shapes_.size()) {
      throw Error(ErrorKind::Usage, "a target group needs one weight per shape");
    }
    double sum = 0.0;
    cumulative_.reserve(shapes_.size());
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      const float weight = weights.empty() ? 1.0f : weights[i];
      if (!(weight >= 0.0f && isFinite(weight))) {
        throw Error(ErrorKind::Usage, "the weights of a target group must be finite and not negative");
      }
      cumulative_.push_back(sum += static_cast<double>(weight));
    }
    for (double& c : cumulative_) c = sum > 0.0 ? c / sum : 0.0;
  }

  std::span<const SampledShape> shapes() const { return shapes_; }
  /// Whether no shape can be chosen.
  bool empty() const { return cumulative_.empty() || cumulative_.back() == 0.0; }
  float probability(std::size_t i) const {
    return static_cast<float>(cumulative_[i] - (i == 0 ? 0.0 : cumulative_[i - 1]));
  }
  /// The shape that `choice` in [0, 1) falls on, never one of weight 0. The group must not be empty.
  std::size_t choose(float choice) const {
    const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end(), static_cast<double>(choice));
    return static_cast<std::size_t>(found - cumulative_.begin());
  }
  /// A direction to the shape that `choice` falls on, for several viewers at once, each at a time of its own; without a
  /// distance, as a direction may hit several members. Lanes that are not active have no sample.
  template <class F>
  DirectionSample<F> sampleDirection(Vec3<F> from, F choice, Vec2<F> u, F time,
                                     MaskOf<F> active = MaskOf<F>(true)) const;
  /// The density of sample, per sr: the marginal one. Undefined in lanes that are not active.
  template <class F>
  F pdfDirection(Vec3<F> from, Vec3<F> wi, F time, MaskOf<F> active = MaskOf<F>(true)) const;

 private:
  std::vector<SampledShape> shapes_;
  std::vector<double> cumulative_;  ///< of the probabilities; the last is 1, or all are 0
};

template <class F>
DirectionSample<F> TargetGroup::sampleDirection(Vec3<F> from, F choice, Vec2<F> u, F time, MaskOf<F> active) const {
  DirectionSample<F> sample;
  if (empty()) return sample;
  UintOf<F> member(0u);
  if (shapes_.size() > 1) {
    for (int i = 0; i < widthOf<F>; ++i) setLane(member, i, static_cast<std::uint32_t>(choose(lane(choice, i))));
  }
  // Once per chosen member: usually one, at worst as many as there are lanes.
  MaskOf<F> left = active;
  for (int i = 0; i < widthOf<F>; ++i) {
    if (!lane(left, i)) continue;
    const std::uint32_t chosen = lane(member, i);
    const MaskOf<F> mine = left & (member == UintOf<F>(chosen));
    const auto one = steradian::sampleDirection<F>(shapes_[chosen], from, u, time, mine);
    sample.wi = select(mine, one.wi, sample.wi);
    sample.pdf = select(mine, one.pdf, sample.pdf);
    left = left & !mine;
  }
  const MaskOf<F> found = active & (sample.pdf > F(0.0f));
  if (shapes_.size() == 1) {
    sample.pdf = select(found, sample.pdf, F(0.0f));
    return sample;
  }
  sample.pdf = any(found) ? select(found, pdfDirection(from, sample.wi, time, found), F(0.0f)) : F(0.0f);
  return sample;
}

template <class F>
F TargetGroup::pdfDirection(Vec3<F> from, Vec3<F> wi, F time, MaskOf<F> active) const {
  F sum(0.0f);
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const float share = probability(i);
    if (share > 0.0f) sum = sum + F(share) * steradian::pdfDirection<F>(shapes_[i], from, wi, time, active);
  }
  return sum;
}

/// The density per sr of the directions from a point to a shape, or to a group of shapes. The density of a group is the
/// marginal one: the sum over all members of probability times density, hit first or not, occluded or not. It takes
/// time in proportion to their number. The target is the caller's and must outlive this.
class HittablePdf {
 public:
  HittablePdf(const SampledShape& shape, Vec3f from, float time = 0.0f) : shape_(&shape), from_(from), time_(time) {}
  HittablePdf(const TargetGroup& group, Vec3f from, float time = 0.0f) : group_(&group), from_(from), time_(time) {}

  /// For a group without a distance: a direction may hit several members.
  DirectionSample<float> sample(float choice, Vec2f u) const {
    if (shape_ != nullptr) return shape_->sampleDirection(from_, u, time_);
    return group_->sampleDirection(from_, choice, u, time_);
  }

  float pdf(Vec3f wi) const {
    if (shape_ != nullptr) return shape_->pdfDirection(from_, wi, time_);
    return group_->pdfDirection(from_, wi, time_);
  }

 private:
  const SampledShape* shape_ = nullptr;
  const TargetGroup* group_ = nullptr;
  Vec3f from_;
  float time_;  // of the shutter
};

}  // namespace steradian
