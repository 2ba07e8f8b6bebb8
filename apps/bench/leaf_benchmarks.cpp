#include "steradian/accel/shapes/clusters/cluster.h"
#include "steradian/accel/shapes/clusters/leaf_kinds.h"
#include "steradian/apps/bench/micro.h"
#include "steradian/apps/bench/micro_loop.h"
#include "steradian/core/sampling/warp.h"

namespace steradian::bench {
namespace {

/// Primitives in the unit cube, from the random numbers that it is given in order.
class Numbers {
 public:
  explicit Numbers(std::uint32_t stream) : random_(0, 0, stream, 0x6c656166) {}
  float in(float low, float high) { return low + (high - low) * random_.next(); }
  Vec3f point() {
    const float x = random_.next(), y = random_.next(), z = random_.next();
    return {x, y, z};
  }
  Vec3f direction() {
    const float x = random_.next(), y = random_.next();
    return UniformSphere<float>::sample({x, y});
  }

 private:
  RandomStream random_;
};

/// Of about a fifth of the cube's edge: a ray meets one or two of 16.
constexpr float kSize = 0.2f;

void make(Numbers& n, Sphere<float>& s) { s = {n.point(), n.in(0.5f, 1.0f) * kSize}; }
void make(Numbers& n, Quad<float>& q) {
  q = {n.point(), n.direction() * (2.0f * kSize), n.direction() * (2.0f * kSize)};
}
void make(Numbers& n, AlignedQuad& q) {
  const int u = static_cast<int>(n.in(0.0f, 2.99f)), v = (u + 1) % 3;
  const auto along = [](int axis) {
    const float length = 2.0f * kSize;
    return Vec3f{axis == 0 ? length : 0.0f, axis == 1 ? length : 0.0f, axis == 2 ? length : 0.0f};
  };
  q = *AlignedQuad::of({n.point(), along(u), along(v)});
}
void make(Numbers& n, Disk<float>& d) { d = {n.point(), n.direction(), kSize}; }
void make(Numbers& n, Triangle<float>& t) {
  const Vec3f a = n.point();
  t = {a, a + n.direction() * (2.0f * kSize), a + n.direction() * (2.0f * kSize)};
}
Vec3f halfEdges(Numbers& n) {
  const float x = n.in(0.5f, 1.0f), y = n.in(0.5f, 1.0f), z = n.in(0.5f, 1.0f);
  return Vec3f{x, y, z} * (0.5f * kSize);
}
void make(Numbers& n, UprightBox<float>& b) {
  const Vec3f center = n.point(), half = halfEdges(n);
  const SinCos<float> turn = sinCosTwoPi(n.in(0.0f, 1.0f));
  b = {center, half, {turn.cos, turn.sin}};
}
void make(Numbers& n, TurnedBox& b) {
  const Vec3f center = n.point(), half = halfEdges(n), axis = n.direction();
  const SinCos<float> turn = sinCosTwoPi(0.5f * n.in(0.0f, 1.0f));
  b = {center, half, turn.cos, axis.x * turn.sin, axis.y * turn.sin, axis.z * turn.sin};
}

template <class Leaf>
Cluster<Leaf> fullCluster() {
  Numbers numbers(1);
  Cluster<Leaf> cluster;
  for (std::uint32_t i = 0; i < kClusterSize; ++i) {
    typename Leaf::Shape shape;
    make(numbers, shape);
    cluster.put(static_cast<int>(i), shape, 0, i);
  }
  return cluster;
}

/// From a sphere about the cube to points in it.
std::vector<Ray<float>> raysAtCube() {
  Numbers numbers(2);
  std::vector<Ray<float>> rays(kInputs);
  for (Ray<float>& ray : rays) {
    ray.origin = Vec3f{0.5f, 0.5f, 0.5f} + numbers.direction() * 2.0f;
    ray.direction = normalize(numbers.point() - ray.origin);
  }
  return rays;
}

template <class Leaf>
void registerLeaf(const std::string& name) {
  benchmark::RegisterBenchmark(("leaf/" + name + "/nearest").c_str(), [](benchmark::State& state) {
    const Cluster<Leaf> cluster = fullCluster<Leaf>();
    const std::vector<Ray<float>> rays = raysAtCube();
    measureRays(state, kInputs, [&](std::size_t i) {
      LeafHit best;
      intersectCluster(cluster, 0, broadcastRay<LeafLanes>(rays[i]), kNone, best);
      return best;
    });
  });
  benchmark::RegisterBenchmark(("leaf/" + name + "/any").c_str(), [](benchmark::State& state) {
    const Cluster<Leaf> cluster = fullCluster<Leaf>();
    const std::vector<Ray<float>> rays = raysAtCube();
    measureRays(state, kInputs,
                [&](std::size_t i) { return clusterOccludes(cluster, broadcastRay<LeafLanes>(rays[i])); });
  });
}

}  // namespace

void registerLeafBenchmarks() {
  registerLeaf<SphereLeaf>("sphere");
  registerLeaf<QuadLeaf>("quad");
  registerLeaf<AlignedQuadLeaf>("aligned-quad");
  registerLeaf<UprightBoxLeaf>("upright-box");
  registerLeaf<TurnedBoxLeaf>("turned-box");
  registerLeaf<DiskLeaf>("disk");
  registerLeaf<TriangleLeaf>("triangle");
}

}  // namespace steradian::bench
