#pragma once
/// Embree 3.13 and Embree 4 under one set of names: everything in which they differ is in this file.
#if STERADIAN_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace steradian::embree {

inline constexpr const char* kVersion = RTC_VERSION_STRING;

inline void intersect(RTCScene scene, RTCRayHit& rayHit) {
#if STERADIAN_EMBREE_MAJOR >= 4
  rtcIntersect1(scene, &rayHit);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &rayHit);
#endif
}

/// Embree reports a hit by setting ray.tfar to minus infinity.
inline void occluded(RTCScene scene, RTCRay& ray) {
#if STERADIAN_EMBREE_MAJOR >= 4
  rtcOccluded1(scene, &ray);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, &ray);
#endif
}

}  // namespace steradian::embree
