#include "steradian/accel/shapes/clusters/cluster_partition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "steradian/accel/shapes/clusters/cluster.h"
#include "steradian/core/base/parallel.h"

namespace steradian {
namespace {

constexpr std::uint32_t kGrain = 4096;

template <class Body>
void forEachInParallel(std::size_t count, const Body& body) {
  parallelForRanges(count, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i != end; ++i) body(i);
  });
}

float extentOf(const ClusterItem& item) { return maxComponent(item.bounds.extent()); }

bool byOrdinal(const ClusterItem& a, const ClusterItem& b) { return a.ordinal < b.ordinal; }

constexpr std::array<float Vec3f::*, 3> kAxes{&Vec3f::x, &Vec3f::y, &Vec3f::z};

float halfArea(const Bounds3& b) {
  const Vec3f e = b.extent();
  return e.x * e.y + e.y * e.z + e.z * e.x;
}

/// Twice the centre.
float middleOf(const ClusterItem& item, float Vec3f::*axis) { return item.bounds.low.*axis + item.bounds.high.*axis; }

std::size_t clustersOf(std::size_t items) { return (items + kClusterSize - 1) / kClusterSize; }

/// Where to cut items in two: the number of items before the cut, in order along an axis.
struct Cut {
  float Vec3f::*axis = &Vec3f::x;
  std::size_t before = 0;
};

/// Finds the best of a few planes along each axis by the surface-area heuristic (Wald 2007); of very many items only a
/// part is examined.
class CutSearch {
 public:
  explicit CutSearch(std::span<const ClusterItem> items) : items_(items), step_(1 + items.size() / kMaxExamined) {
    Bounds3 middles;
    forEachLookedAt([&](const ClusterItem& item) { middles.include(item.bounds.low + item.bounds.high); });
    for (Along& along : axes_) {
      const auto axis = kAxes[static_cast<std::size_t>(&along - axes_)];
      const float extent = middles.extent().*axis;
      along.low = middles.low.*axis;
      along.scale = extent > 0.0f ? static_cast<float>(kBins) / extent : 0.0f;
    }
    forEachLookedAt([&](const ClusterItem& item) {
      for (std::size_t a = 0; a < kAxes.size(); ++a) {
        Along& along = axes_[a];
        // NaN or infinite where floats cannot represent the distances of the items: these go to the last bin.
        const float place = (middleOf(item, kAxes[a]) - along.low) * along.scale;
        const bool isInside = place < static_cast<float>(kBins);
        along.bins[isInside ? static_cast<std::size_t>(place) : kBins - 1].add({1, item.bounds});
      }
    });
  }

  /// The median along the first axis if all are in one place.
  Cut best() const {
    Cut best{kAxes[0], items_.size() / 2};
    float least = kInfinity;
    for (std::size_t a = 0; a < kAxes.size(); ++a) {
      if (axes_[a].scale > 0.0f) search(axes_[a], kAxes[a], best, least);
    }
    return best;
  }

 private:
  static constexpr std::size_t kBins = 16, kMaxExamined = 4096;
  struct Bin {
    std::size_t count = 0;
    Bounds3 bounds;

    void add(const Bin& bin) {
      count += bin.count;
      bounds.include(bin.bounds);
    }
  };
  struct Along {
    float low, scale;
    Bin bins[kBins];
  };

  template <class Visit>
  void forEachLookedAt(const Visit& visit) const {
    for (std::size_t i = 0; i < items_.size(); i += step_) visit(items_[i]);
  }
  /// Infinite for an empty side, so that no cut has one.
  float costOf(const Bin& side) const {
    return side.count == 0 ? kInfinity : halfArea(side.bounds) * static_cast<float>(clustersOf(side.count * step_));
  }
  void search(const Along& along, float Vec3f::*axis, Cut& best, float& least) const {
    float above[kBins];
    Bin rest;
    for (std::size_t i = kBins; i-- > 1;) {
      rest.add(along.bins[i]);
      above[i] = costOf(rest);
    }
    Bin below;
    for (std::size_t i = 1; i < kBins; ++i) {
      below.add(along.bins[i - 1]);
      const float cost = costOf(below) + above[i];
      if (cost < least) {
        least = cost;
        best = {axis, below.count * step_};
      }
    }
  }

  std::span<const ClusterItem> items_;
  std::size_t step_;
  Along axes_[3];
};

/// Sorts items so that each run of kClusterSize is compact. After `searches` cuts by cost, which may each have been
/// very uneven, it cuts at the median.
void arrange(std::span<ClusterItem> items, int searches = 64) {
  if (items.size() <= kClusterSize) return;
  const Cut cut = searches > 0 ? CutSearch(items).best() : Cut{kAxes[0], items.size() / 2};
  const std::size_t nearby = (cut.before + kClusterSize / 2) / kClusterSize;
  const std::size_t before = std::clamp<std::size_t>(nearby, 1, clustersOf(items.size()) - 1) * kClusterSize;
  const auto isBefore = [axis = cut.axis](const ClusterItem& a, const ClusterItem& b) {
    const float x = middleOf(a, axis), y = middleOf(b, axis);
    return x != y ? x < y : a.ordinal < b.ordinal;
  };
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(before), items.end(), isBefore);
  const auto left = items.first(before), right = items.subspan(before);
  if (items.size() > kGrain) {
    parallelInvoke([&] { arrange(left, searches - 1); }, [&] { arrange(right, searches - 1); });
  } else {
    arrange(left, searches - 1);
    arrange(right, searches - 1);
  }
}

/// Classes of size, each a factor of 32 wide, around the median of a sample: small spheres and their huge ground sphere
/// are two classes, so that the ground does not affect how the small ones are cut.
class SizeClasses {
 public:
  explicit SizeClasses(std::span<const ClusterItem> items) {
    constexpr std::size_t kSample = 1024;
    const std::size_t step = (items.size() + kSample - 1) / kSample;
    std::vector<float> sample;
    for (std::size_t i = 0; i < items.size(); i += step) sample.push_back(extentOf(items[i]));
    const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
    std::nth_element(sample.begin(), middle, sample.end());
    median_ = exponent(*middle);
  }
  int operator()(const ClusterItem& item) const { return (exponent(extentOf(item)) - median_ + 5 * 64 + 2) / 5 - 64; }

 private:
  static int exponent(float extent) { return extent > 0.0f ? std::min(std::ilogb(extent), 128) : -149; }
  int median_;
};

/// Moves the oversized primitives of one cluster to its end and returns their number.
std::uint32_t separateOversized(std::span<ClusterItem> cluster) {
  const auto smaller = [](const ClusterItem& a, const ClusterItem& b) {
    const float x = extentOf(a), y = extentOf(b);
    return x != y ? x < y : a.ordinal < b.ordinal;
  };
  std::sort(cluster.begin(), cluster.end(), smaller);
  Bounds3 together;
  std::size_t regular = 1;
  together.include(cluster.front().bounds);
  while (regular < cluster.size() && extentOf(cluster[regular]) <= 4.0f * maxComponent(together.extent())) {
    together.include(cluster[regular++].bounds);
  }
  std::sort(cluster.begin(), cluster.begin() + static_cast<std::ptrdiff_t>(regular), byOrdinal);
  return static_cast<std::uint32_t>(cluster.size() - regular);
}

/// Clusters of one size class, which is items [begin, end).
void appendRanges(ClusterPartition& partition, std::uint32_t begin, std::uint32_t end) {
  const std::span<ClusterItem> items = std::span(partition.items).subspan(begin, end - begin);
  arrange(items);
  const std::size_t clusters = clustersOf(items.size());
  std::vector<std::uint32_t> oversized(clusters);
  const auto sizeOf = [&](std::size_t c) {
    return std::min<std::size_t>(kClusterSize, items.size() - c * kClusterSize);
  };
  forEachInParallel(
      clusters, [&](std::size_t c) { oversized[c] = separateOversized(items.subspan(c * kClusterSize, sizeOf(c))); });
  for (std::size_t c = 0; c < clusters; ++c) {
    const auto first = static_cast<std::uint32_t>(begin + c * kClusterSize);
    const auto regular = static_cast<std::uint32_t>(sizeOf(c)) - oversized[c];
    partition.ranges.push_back({first, regular});
    for (std::uint32_t g = 0; g < oversized[c]; ++g) partition.ranges.push_back({first + regular + g, 1});
  }
}

}  // namespace

ClusterPartition partitionIntoClusters(std::uint32_t count, const std::function<Bounds3(std::uint32_t)>& boundsOf) {
  ClusterPartition partition;
  if (count == 0) return partition;
  partition.items.resize(count);
  forEachInParallel(count, [&](std::size_t i) {
    const auto ordinal = static_cast<std::uint32_t>(i);
    partition.items[i] = {boundsOf(ordinal), ordinal};
  });
  if (count <= kClusterSize) {
    partition.ranges.push_back({0, count});
    return partition;
  }
  const SizeClasses classOf(partition.items);
  const auto smaller = [&](const auto& a, const auto& b) { return classOf(a) < classOf(b); };
  if (!std::is_sorted(partition.items.begin(), partition.items.end(), smaller)) {
    std::stable_sort(partition.items.begin(), partition.items.end(), smaller);
  }
  partition.ranges.reserve(count / kClusterSize + 16);
  for (std::uint32_t begin = 0; begin < count;) {
    const auto end =
        std::upper_bound(partition.items.begin() + begin, partition.items.end(), partition.items[begin], smaller);
    const auto next = static_cast<std::uint32_t>(end - partition.items.begin());
    appendRanges(partition, begin, next);
    begin = next;
  }
  return partition;
}

}  // namespace steradian
