#pragma once
/// One geometry with and without a hierarchy.
#include <gtest/gtest.h>

#include "steradian/accel/geometry.h"

namespace steradian::test {

inline constexpr std::uint32_t kAlways = 0xffffffffu;

/// A loop over all clusters, without a hierarchy.
inline GeometrySettings direct() {
  return {.accel = {.maxClustersWithoutTree = kAlways, .maxClusteredTriangles = kAlways}};
}
/// Our hierarchy, even over few primitives.
inline GeometrySettings hierarchy() {
  return {.accel = {.maxClustersWithoutTree = 0, .maxClusteredTriangles = kAlways}};
}

/// Embree's hierarchy, even over few primitives.
inline GeometrySettings embreeHierarchy() {
  return {.accel = {.accel = Accel::Embree, .maxClusteredTriangles = kAlways}};
}

/// To the bit.
inline void expectSame(const Hit<float>& a, const Hit<float>& b) {
  ASSERT_EQ(a.valid, b.valid);
  if (!a.valid) return;
  ASSERT_EQ(a.t, b.t);
  ASSERT_EQ(a.u, b.u);
  ASSERT_EQ(a.v, b.v);
  ASSERT_EQ(a.shape, b.shape);
  ASSERT_EQ(a.primitive, b.primitive);
  ASSERT_EQ(a.instance, b.instance);
}

}  // namespace steradian::test
