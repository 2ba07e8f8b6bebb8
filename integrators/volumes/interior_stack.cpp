#include "steradian/integrators/volumes/interior_stack.h"

#include <algorithm>

namespace steradian {

std::uint32_t InteriorStack::find(const Entry& entry) const {
  std::uint32_t i = 0;
  while (i < count_ && !entries_[i].isSame(entry)) ++i;
  return i;
}

void InteriorStack::enter(const Entry& entry) {
  if (count_ < kMaxSize && !contains(entry)) entries_[count_++] = entry;
}

void InteriorStack::leave(const Entry& entry) {
  const std::uint32_t i = find(entry);
  if (i == count_) return;
  std::copy(entries_.begin() + i + 1, entries_.begin() + count_, entries_.begin() + i);
  --count_;
}

const InteriorStack::Entry* InteriorStack::top(const Entry* other) const {
  const Entry* best = nullptr;
  for (std::uint32_t i = 0; i < count_; ++i) {
    if (other != nullptr && entries_[i].isSame(*other)) continue;
    if (best == nullptr || entries_[i].priority >= best->priority) best = &entries_[i];
  }
  return best;
}

}  // namespace steradian
