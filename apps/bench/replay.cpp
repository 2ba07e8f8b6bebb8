#include "steradian/apps/bench/replay.h"

#include <algorithm>
#include <atomic>
#include <bit>

#include "steradian/accel/shapes/clusters/flat_primitives.h"
#include "steradian/core/base/float_mode.h"
#include "steradian/core/base/parallel.h"

namespace steradian::bench {
namespace {

using F = Lanes<kNativeWidth>;
using Active = Mask<kNativeWidth>;

/// About the rays of one sample per pixel of a tile.
constexpr std::size_t kRun = 2048;

std::uint64_t countHits(const Geometry& geometry, std::span<const RecordedRay> rays) {
  std::uint64_t hits = 0;
  for (const RecordedRay& recorded : rays) {
    const bool hit =
        recorded.kind == RayKind::Shadow ? geometry.occluded(recorded.ray) : geometry.intersect(recorded.ray).valid;
    hits += hit ? 1u : 0u;
  }
  return hits;
}

/// Collects rays of one kind of query until there is one for each lane.
template <class Query>
class Packet {
 public:
  explicit Packet(Query query) : query_(query) {}

  /// Hits of the query, if this ray was the last that it waited for.
  std::uint64_t add(const Ray<float>& ray) {
    setLane(rays_, count_, ray);
    setLane(active_, count_, true);
    return ++count_ == kNativeWidth ? flush() : 0;
  }
  std::uint64_t flush() {
    const auto hits = static_cast<std::uint64_t>(std::popcount(laneBits(query_(rays_, active_))));
    active_ = false;
    count_ = 0;
    return hits;
  }

 private:
  Query query_;
  Ray<F> rays_;
  Active active_{false};
  int count_ = 0;
};

std::uint64_t countHits(const FlatPrimitives& primitives, std::span<const RecordedRay> rays) {
  Packet nearest([&](const Ray<F>& r, Active active) { return primitives.intersect(r, active).valid; });
  Packet occluded([&](const Ray<F>& r, Active active) { return primitives.occluded(r, active); });
  std::uint64_t hits = 0;
  for (const RecordedRay& recorded : rays) {
    hits += recorded.kind == RayKind::Shadow ? occluded.add(recorded.ray) : nearest.add(recorded.ray);
  }
  return hits + nearest.flush() + occluded.flush();
}

}  // namespace

std::uint64_t replay(const Geometry& geometry, std::span<const RecordedRay> rays, bool several) {
  // Not where Embree has something to traverse besides.
  const FlatPrimitives* flat = several && !geometry.statistics().accel.needsEmbree() ? geometry.flat() : nullptr;
  std::atomic<std::uint64_t> hits{0};
  const std::size_t runs = (rays.size() + kRun - 1) / kRun;
  parallelForEach(runs, [&](std::size_t i) {
    const FlushDenormals floatMode;
    const std::size_t begin = i * kRun;
    const auto run = rays.subspan(begin, std::min(kRun, rays.size() - begin));
    hits += flat != nullptr ? countHits(*flat, run) : countHits(geometry, run);
  });
  return hits;
}

}  // namespace steradian::bench
