#pragma once
/// Values of pixels in groups, of which each is combined with all others of its group.
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include "steradian/core/math/lanes.h"

namespace STERADIAN_API steradian {

/// Rows of floats, one per entry; entries are numbered, and `group` (a power of two) consecutive ones are a group.
template <class F>
class GroupRows {
 public:
  GroupRows(std::size_t rows, std::size_t entries, std::size_t group)
      : rows_(rows), group_(group), values_((entries + group - 1) / group * rows * 2 * group) {}

  /// Sets a row of the entries in the lanes, of which the first is a multiple of their number.
  void set(std::size_t row, std::size_t first, F value) {
    for (int i = 0; i < width; i += run()) {
      float* to = at(row, first + static_cast<std::size_t>(i));
      float lanes[width];
      store(lanes, value);
      std::memcpy(to, lanes + i, sizeof(float) * static_cast<std::size_t>(run()));
      std::memcpy(to + group_, lanes + i, sizeof(float) * static_cast<std::size_t>(run()));
    }
  }
  /// A row of the entries that are `shift` < group places further in the groups of those in the lanes, which begin
  /// again where they end.
  F get(std::size_t row, std::size_t first, std::size_t shift) const {
    if (static_cast<std::size_t>(width) <= group_) return load<F>(at(row, first) + shift);
    float lanes[width];
    for (int i = 0; i < width; i += run()) {
      std::memcpy(lanes + i, at(row, first + static_cast<std::size_t>(i)) + shift,
                  sizeof(float) * static_cast<std::size_t>(run()));
    }
    return load<F>(lanes);
  }

 private:
  static constexpr int width = widthOf<F>;
  int run() const { return std::min(width, static_cast<int>(group_)); }
  /// Every group's row stands there twice: the second time for what begins again.
  const float* at(std::size_t row, std::size_t entry) const {
    return values_.data() + (entry / group_ * rows_ + row) * 2 * group_ + entry % group_;
  }
  float* at(std::size_t row, std::size_t entry) { return const_cast<float*>(std::as_const(*this).at(row, entry)); }

  std::size_t rows_, group_;
  std::vector<float> values_;
};

}  // namespace steradian
