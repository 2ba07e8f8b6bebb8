#pragma once
/// Embree 3.13 and Embree 4 under one set of names: everything in which they differ is in this file.
#if STERADIAN_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "steradian/accel/query_counts.h"

namespace steradian::embree {

inline constexpr const char* kVersion = RTC_VERSION_STRING;

/// The context that a query passes to the callbacks. Embree's own context is the first member: callbacks get a pointer
/// to it.
struct QueryContext {
#if STERADIAN_EMBREE_MAJOR >= 4
  RTCRayQueryContext embree;
#else
  RTCIntersectContext embree;
#endif
  EmbreeCounts* counts;  ///< null: not counted

  explicit QueryContext(EmbreeCounts* c) : counts(c) {
#if STERADIAN_EMBREE_MAJOR >= 4
    rtcInitRayQueryContext(&embree);
#else
    rtcInitIntersectContext(&embree);
#endif
    if (counts != nullptr) ++counts->rays;
  }
};

/// The counts of a callback's context, after adding this callback; null if not counted.
template <class Arguments>
EmbreeCounts* countCallback(const Arguments* args) {
  EmbreeCounts* counts = reinterpret_cast<const QueryContext*>(args->context)->counts;
  if (counts != nullptr) ++counts->callbacks;
  return counts;
}

inline void intersect(RTCScene scene, RTCRayHit& rayHit, EmbreeCounts* counts) {
  QueryContext context(counts);
#if STERADIAN_EMBREE_MAJOR >= 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context.embree;
  rtcIntersect1(scene, &rayHit, &arguments);
#else
  rtcIntersect1(scene, &context.embree, &rayHit);
#endif
}

/// `valid`: -1 for rays that are to be traced, 0 for others.
inline void intersect8(const int* valid, RTCScene scene, RTCRayHit8& rayHits, EmbreeCounts* counts) {
  QueryContext context(counts);
#if STERADIAN_EMBREE_MAJOR >= 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context.embree;
  rtcIntersect8(valid, scene, &rayHits, &arguments);
#else
  rtcIntersect8(valid, scene, &context.embree, &rayHits);
#endif
}

/// Embree reports a hit by setting ray.tfar to minus infinity.
inline void occluded(RTCScene scene, RTCRay& ray, EmbreeCounts* counts) {
  QueryContext context(counts);
#if STERADIAN_EMBREE_MAJOR >= 4
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context.embree;
  rtcOccluded1(scene, &ray, &arguments);
#else
  rtcOccluded1(scene, &context.embree, &ray);
#endif
}

}  // namespace steradian::embree
