#pragma once
/// Values of paths in groups, of which each is combined with all others of its group.
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include "steradian/core/math/lanes.h"

namespace STERADIAN_API steradian {

/// A table with a column for each path (entry). Entries are numbered; each `group` consecutive ones, a power of two,
/// are a group.
template <class F>
class GroupRows {
 public:
  GroupRows(std::size_t rows, std::size_t entries, std::size_t group)
      : rows_(rows), group_(group), values_((entries + group - 1) / group * rows * 2 * group) {}

  /// Sets a row's values for the entries first, first + 1, ..., one in each lane; `first` must be a multiple of the
  /// number of lanes.
  void set(std::size_t row, std::size_t first, F value) {
    for (int i = 0; i < width; i += run()) {
      float* to = at(row, first + static_cast<std::size_t>(i));
      float lanes[width];
      store(lanes, value);
      std::memcpy(to, lanes + i, sizeof(float) * static_cast<std::size_t>(run()));
      std::memcpy(to + group_, lanes + i, sizeof(float) * static_cast<std::size_t>(run()));
    }
  }
  /// A row's values for the entries that are `shift` < group places further in their groups than those of the lanes,
  /// counted on from the group's start where it ends (cyclically).
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
  /// Each row of a group is stored twice in succession, so that a cyclic shift of it is a contiguous stretch.
  const float* at(std::size_t row, std::size_t entry) const {
    return values_.data() + (entry / group_ * rows_ + row) * 2 * group_ + entry % group_;
  }
  float* at(std::size_t row, std::size_t entry) { return const_cast<float*>(std::as_const(*this).at(row, entry)); }

  std::size_t rows_, group_;
  std::vector<float> values_;
};

}  // namespace steradian
