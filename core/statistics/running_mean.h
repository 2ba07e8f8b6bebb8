#pragma once
/// Mean and variance of a stream of values.
#include <cmath>
#include <cstdint>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

/// One value at a time, without their sum of squares, whose digits would cancel (Welford 1962, "Note on a method for
/// calculating corrected sums of squares and products").
class RunningMean {
 public:
  void add(double x) {
    ++count_;
    const double d = x - mean_;
    mean_ += d / static_cast<double>(count_);
    squares_ += d * (x - mean_);
  }

  std::int64_t count() const { return count_; }
  double mean() const { return mean_; }
  /// Of the values, unbiased (divided by count - 1); 0 for fewer than two.
  double variance() const { return count_ > 1 ? squares_ / static_cast<double>(count_ - 1) : 0.0; }
  /// Of the mean, if the values are independent; 0 for fewer than two.
  double standardError() const { return count_ > 0 ? std::sqrt(variance() / static_cast<double>(count_)) : 0.0; }

 private:
  std::int64_t count_ = 0;
  double mean_ = 0.0, squares_ = 0.0;
};

}  // namespace steradian
