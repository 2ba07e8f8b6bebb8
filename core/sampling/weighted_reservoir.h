#pragma once
/// Weighted reservoir sampling: one item of a stream, each with probability in proportion to its weight, without
/// knowing the stream's length or storing it (Chao 1982, "A general purpose unequal probability sampling plan", for a
/// sample of one).
#include <cstdint>

#include "steradian/core/math/math.h"

namespace STERADIAN_API steradian {

/// T: any value at width 1; a type with `select(MaskOf<F>, T, T)` for Lanes<N>, where each lane has a stream of its
/// own.
///
/// Weights are finite; what is not above 0 is never chosen. The sum is kept to twice the digits of a float. A random
/// number has 24 bits: an item of less than 2^-24 of the sum so far is taken that often all the same.
template <class F, class T>
class WeightedReservoir {
 public:
  /// Offers an item, with a random number u in [0, 1) of its own; whether it was taken. An item replaces the one before
  /// with probability weight / total: then each item's own probability is its weight / total.
  MaskOf<F> add(const T& item, F weight, F u) {
    const F w = select(weight > F(0.0f), weight, F(0.0f));
    count_ += 1;
    accumulate(w);
    // The first is taken even if its weight is lost by rounding.
    const MaskOf<F> first = empty();
    const F sum = total();
    const MaskOf<F> taken = (w > F(0.0f)) & (first | (u * sum < w));
    keep(taken, item);
    weight_ = select(taken, w, weight_);
    return taken;
  }

  /// Adds the stream of another reservoir, as if it had followed; u in [0, 1).
  MaskOf<F> merge(const WeightedReservoir& other, F u) {
    count_ += other.count_;
    accumulate(other.total_);
    accumulate(other.rest_);
    const MaskOf<F> first = empty(), offered = !other.empty();
    const F sum = total(), added = other.total();
    const MaskOf<F> taken = offered & (first | (u * sum < added));
    keep(taken, other.item_);
    weight_ = select(taken, other.weight_, weight_);
    return taken;
  }

  /// Nothing of positive weight has been offered: there is no item.
  MaskOf<F> empty() const { return !(weight_ > F(0.0f)); }
  /// What was chosen; T{} where empty.
  const T& item() const { return item_; }
  F weight() const { return weight_; }
  /// The sum of all weights offered.
  F total() const { return total_ + rest_; }
  /// The probability with which the item was chosen: weight / total; 0 where empty.
  F probability() const { return select(empty(), F(0.0f), weight_ / total()); }
  /// The number of items offered, including those of weight 0.
  std::uint64_t count() const { return count_; }

 private:
  void keep(MaskOf<F> taken, const T& item) {
    if constexpr (widthOf<F> == 1) {
      if (taken) item_ = item;
    } else {
      item_ = select(taken, item, item_);
    }
  }
  /// total_ + rest_ grows by w; what rounding loses goes to rest_ (Knuth 1998, section 4.2.2, theorem B).
  void accumulate(F w) {
    const F sum = total_ + w, back = sum - total_;
    const F lost = rest_ + ((total_ - (sum - back)) + (w - back));
    total_ = sum + lost;
    rest_ = lost - (total_ - sum);
  }

  T item_{};
  F weight_{0.0f};
  F total_{0.0f}, rest_{0.0f};
  std::uint64_t count_ = 0;
};

}  // namespace steradian
