#pragma once
/// The closed shapes around a point of a path.
#include <array>
#include <cstdint>

#include "steradian/core/scene/description.h"

namespace STERADIAN_API steradian {

/// The closed shapes that a ray is inside of, in the order in which it entered them. Which of them fills the space is
/// decided by priority ("Ray Tracing Gems", chapter 11: Automatic Handling of Materials in Nested Volumes).
class InteriorStack {
 public:
  struct Entry {
    Id shape, primitive, instance;  ///< primitive: 0 for meshes, whose triangles bound one volume together
    Id medium;
    int priority;
    float eta;  ///< refractive index; 1 for shapes without a priority

    bool isSame(const Entry& other) const {
      return shape == other.shape && primitive == other.primitive && instance == other.instance;
    }
  };
  /// Shapes entered while the stack is full are not recorded.
  static constexpr std::uint32_t kMaxSize = 64;

  InteriorStack() = default;
  InteriorStack(const InteriorStack& other) { *this = other; }
  /// Copies only the entries in use: mostly one or two.
  InteriorStack& operator=(const InteriorStack& other) {
    count_ = other.count_;
    for (std::uint32_t i = 0; i < count_; ++i) entries_[i] = other.entries_[i];
    return *this;
  }

  void enter(const Entry& entry);
  void leave(const Entry& entry);
  bool contains(const Entry& entry) const { return find(entry) < count_; }
  /// The shape that fills the space: the one entered last of those with the highest priority; null outside of all
  /// shapes. `other` does not count.
  const Entry* top(const Entry* other = nullptr) const;
  bool empty() const { return count_ == 0; }

 private:
  std::uint32_t find(const Entry& entry) const;

  std::array<Entry, kMaxSize> entries_;  ///< the first count_ are in use, the others not even initialised
  std::uint32_t count_ = 0;
};

}  // namespace steradian
