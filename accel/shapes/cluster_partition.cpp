#include "steradian/accel/shapes/cluster_partition.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "steradian/accel/shapes/cluster.h"

namespace steradian {
namespace {

constexpr std::uint32_t kGrain = 4096;

template <class Body>
void forEachInParallel(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kGrain), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
  });
}

float Vec3f::*longestAxis(std::span<const ClusterItem> items) {
  Bounds3 bounds;
  for (const ClusterItem& item : items) bounds.include(item.center);
  const Vec3f extent = bounds.extent();
  if (extent.x >= extent.y && extent.x >= extent.z) return &Vec3f::x;
  return extent.y >= extent.z ? &Vec3f::y : &Vec3f::z;
}

bool byOrdinal(const ClusterItem& a, const ClusterItem& b) { return a.ordinal < b.ordinal; }

/// Sorts items so that each run of kClusterSize is compact: halves along the longest axis of the centres, cut at
/// multiples of the cluster size.
void arrange(std::span<ClusterItem> items) {
  if (items.size() <= kClusterSize) return;
  const std::size_t clusters = (items.size() + kClusterSize - 1) / kClusterSize;
  const std::size_t middle = (clusters + 1) / 2 * kClusterSize;
  const auto axis = longestAxis(items);
  const auto before = [axis](const ClusterItem& a, const ClusterItem& b) {
    return a.center.*axis != b.center.*axis ? a.center.*axis < b.center.*axis : a.ordinal < b.ordinal;
  };
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(middle), items.end(), before);
  const auto left = items.first(middle), right = items.subspan(middle);
  if (items.size() > kGrain) {
    tbb::parallel_invoke([&] { arrange(left); }, [&] { arrange(right); });
  } else {
    arrange(left);
    arrange(right);
  }
}

/// Sizes in steps of a factor 32 around the median of a sample: sets of balls on a huge ground are two classes, so
/// that the ground does not decide how the balls are cut.
class SizeClasses {
 public:
  explicit SizeClasses(std::span<const ClusterItem> items) {
    constexpr std::size_t kSample = 1024;
    const std::size_t step = (items.size() + kSample - 1) / kSample;
    std::vector<float> sample;
    for (std::size_t i = 0; i < items.size(); i += step) sample.push_back(items[i].extent);
    const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
    std::nth_element(sample.begin(), middle, sample.end());
    median_ = exponent(*middle);
  }
  int operator()(const ClusterItem& item) const { return (exponent(item.extent) - median_ + 5 * 64 + 2) / 5 - 64; }

 private:
  static int exponent(float extent) { return extent > 0.0f ? std::ilogb(extent) : -149; }
  int median_;
};

/// Moves the giants of one cluster to its end and returns how many there are.
std::uint32_t separateGiants(std::span<ClusterItem> cluster) {
  const auto smaller = [](const ClusterItem& a, const ClusterItem& b) {
    return a.extent != b.extent ? a.extent < b.extent : a.ordinal < b.ordinal;
  };
  std::sort(cluster.begin(), cluster.end(), smaller);
  Bounds3 together;
  const auto include = [&](const ClusterItem& item) {
    const float r = 0.5f * item.extent;
    together.include(item.center - Vec3f{r, r, r});
    together.include(item.center + Vec3f{r, r, r});
  };
  std::size_t regular = 1;
  include(cluster.front());
  while (regular < cluster.size() && cluster[regular].extent <= 4.0f * maxComponent(together.extent())) {
    include(cluster[regular++]);
  }
  std::sort(cluster.begin(), cluster.begin() + static_cast<std::ptrdiff_t>(regular), byOrdinal);
  return static_cast<std::uint32_t>(cluster.size() - regular);
}

/// Clusters of one size class, which is items [begin, end).
void appendRanges(ClusterPartition& partition, std::uint32_t begin, std::uint32_t end) {
  const std::span<ClusterItem> items = std::span(partition.items).subspan(begin, end - begin);
  arrange(items);
  const std::size_t clusters = (items.size() + kClusterSize - 1) / kClusterSize;
  std::vector<std::uint32_t> giants(clusters);
  const auto sizeOf = [&](std::size_t c) {
    return std::min<std::size_t>(kClusterSize, items.size() - c * kClusterSize);
  };
  forEachInParallel(clusters,
                    [&](std::size_t c) { giants[c] = separateGiants(items.subspan(c * kClusterSize, sizeOf(c))); });
  for (std::size_t c = 0; c < clusters; ++c) {
    const auto first = static_cast<std::uint32_t>(begin + c * kClusterSize);
    const auto regular = static_cast<std::uint32_t>(sizeOf(c)) - giants[c];
    partition.ranges.push_back({first, regular});
    for (std::uint32_t g = 0; g < giants[c]; ++g) partition.ranges.push_back({first + regular + g, 1});
  }
}

}  // namespace

ClusterPartition partitionIntoClusters(std::uint32_t count, const std::function<Bounds3(std::uint32_t)>& boundsOf) {
  ClusterPartition partition;
  if (count == 0) return partition;
  partition.items.resize(count);
  forEachInParallel(count, [&](std::size_t i) {
    const auto ordinal = static_cast<std::uint32_t>(i);
    const Bounds3 bounds = boundsOf(ordinal);
    partition.items[i] = {bounds.center(), maxComponent(bounds.extent()), ordinal};
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
