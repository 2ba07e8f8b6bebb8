#include "steradian/accel/shapes/primitives/aligned_quad.h"

#include "steradian/core/math/math.h"

namespace steradian {
namespace {

/// The only axis along which v is not 0; nothing if there is none or more than one.
std::optional<int> axisOf(const std::array<float, 3>& v) {
  std::optional<int> axis;
  for (int i = 0; i < 3; ++i) {
    if (v[static_cast<std::size_t>(i)] == 0.0f) continue;
    if (axis) return std::nullopt;
    axis = i;
  }
  return axis;
}

std::array<float, 3> componentsOf(Vec3f v) { return {v.x, v.y, v.z}; }

}  // namespace

std::optional<AlignedQuad> AlignedQuad::of(const Quad<float>& quad) {
  const std::array<float, 3> u = componentsOf(quad.u), v = componentsOf(quad.v), c = componentsOf(quad.corner);
  const std::optional<int> axisU = axisOf(u), axisV = axisOf(v);
  if (!axisU || !axisV || *axisU == *axisV) return std::nullopt;
  const int normal = 3 - *axisU - *axisV;
  const auto at = [](const std::array<float, 3>& a, int i) { return a[static_cast<std::size_t>(i)]; };
  const float edgeU = at(u, *axisU), edgeV = at(v, *axisV);
  if (!isFinite(1.0f / edgeU) || !isFinite(1.0f / edgeV)) return std::nullopt;
  return AlignedQuad{{*axisU, *axisV, normal},
                     {at(c, *axisU), at(c, *axisV), at(c, normal)},
                     {edgeU, edgeV},
                     {1.0f / edgeU, 1.0f / edgeV}};
}

Quad<float> AlignedQuad::quad() const {
  std::array<float, 3> c{}, u{}, v{};
  for (std::size_t i = 0; i < 3; ++i) c[static_cast<std::size_t>(axis[i])] = corner[i];
  u[static_cast<std::size_t>(axis[0])] = edge[0];
  v[static_cast<std::size_t>(axis[1])] = edge[1];
  return {{c[0], c[1], c[2]}, {u[0], u[1], u[2]}, {v[0], v[1], v[2]}};
}

}  // namespace steradian
