#include "steradian/accel/shapes/sampling/box_sampling.h"
#include "steradian/accel/shapes/sampling/disk_sampling.h"
#include "steradian/accel/shapes/sampling/quad_sampling.h"
#include "steradian/accel/shapes/sampling/sphere_sampling.h"
#include "steradian/accel/shapes/sampling/triangle_sampling.h"
#include "steradian/apps/bench/micro.h"
#include "steradian/apps/bench/micro_loop.h"

namespace steradian::bench {
namespace {

using Wide = Lanes<8>;

template <class F>
Vec3<F> vec(float x, float y, float z) {
  return {F(x), F(y), F(z)};
}

/// Viewers below the shape, in a square of edge 2 about the origin: the shapes are 2 units above them and seen under
/// 0.1 to 1 sr, where they are sampled by solid angle if they can be.
template <class F, class Shape>
void registerShape(const std::string& name, const Shape& shape) {
  benchmark::RegisterBenchmark(widthName<F>("direction/" + name + "/sample").c_str(), [shape](benchmark::State& state) {
    const UniformPoints points(0), places(1);
    measureCalls(state, kBatches<F>, static_cast<std::size_t>(widthOf<F>), [&](std::size_t i) {
      const Vec2<F> place = places.at<F>(i);
      const F two(2.0f), one(1.0f);
      return sampleDirection(shape, Vec3<F>{two * place.x - one, F(0.0f), two * place.y - one}, points.at<F>(i));
    });
  });
}

template <class F>
void registerWidth() {
  registerShape<F>("sphere", Sphere<F>{vec<F>(0.0f, 2.0f, 0.0f), F(0.7f)});
  registerShape<F>("quad", Quad<F>{vec<F>(-0.7f, 2.0f, -0.7f), vec<F>(1.4f, 0.0f, 0.0f), vec<F>(0.0f, 0.0f, 1.4f)});
  registerShape<F>("triangle",
                   Triangle<F>{vec<F>(-1.0f, 2.0f, -1.0f), vec<F>(1.0f, 2.0f, -1.0f), vec<F>(0.0f, 2.0f, 1.0f)});
  registerShape<F>("disk", Disk<F>{vec<F>(0.0f, 2.0f, 0.0f), vec<F>(0.0f, -1.0f, 0.0f), F(0.7f)});
  registerShape<F>("box", Box<F>{vec<F>(0.0f, 2.0f, 0.0f), vec<F>(0.5f, 0.4f, 0.6f),
                                 axesOfQuaternion(F(0.8f), F(0.0f), F(0.6f), F(0.0f))});
}

}  // namespace

void registerShapeBenchmarks() {
  registerWidth<float>();
  registerWidth<Wide>();
}

}  // namespace steradian::bench
