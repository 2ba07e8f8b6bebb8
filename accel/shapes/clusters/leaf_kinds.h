#pragma once
/// The list of leaf kinds (leaf.h says what one is). All that depends on which kinds there are is derived from it:
/// clusters, primitives by themselves, records for points.
#include <concepts>
#include <tuple>
#include <variant>

#include "steradian/accel/shapes/clusters/aligned_quad_leaf.h"
#include "steradian/accel/shapes/clusters/box_leaf.h"
#include "steradian/accel/shapes/clusters/disk_leaf.h"
#include "steradian/accel/shapes/clusters/moving_sphere_leaf.h"
#include "steradian/accel/shapes/clusters/quad_leaf.h"
#include "steradian/accel/shapes/clusters/sphere_leaf.h"
#include "steradian/accel/shapes/clusters/triangle_leaf.h"
#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

template <class... Kinds>
struct LeafKindList {
  static constexpr std::size_t count = sizeof...(Kinds);
  using Tuple = std::tuple<Kinds...>;
  /// A primitive of any kind, as its cluster keeps it.
  using Shape = std::variant<typename Kinds::Shape...>;
  /// One Of<Kind> for each kind.
  template <template <class> class Of>
  using TupleOf = std::tuple<Of<Kinds>...>;

  /// The number of a kind.
  template <class Kind>
  static constexpr std::uint32_t indexOf() {
    static_assert((std::same_as<Kind, Kinds> + ... + 0) == 1, "each kind stands in the list once");
    constexpr bool same[] = {std::same_as<Kind, Kinds>...};
    std::uint32_t i = 0;
    while (!same[i]) ++i;
    return i;
  }
  /// Calls visit.operator()<Kind>() for each kind in order.
  template <class Visit>
  static void forEach(const Visit& visit) {
    (visit.template operator()<Kinds>(), ...);
  }
  /// Calls visit.operator()<Kind>() for the kind of this number.
  template <class Visit>
  static void dispatch(std::uint32_t index, const Visit& visit) {
    static_cast<void>(((indexOf<Kinds>() == index && (visit.template operator()<Kinds>(), true)) || ...));
  }

  static_assert(((Kinds::pointRows * 4 <= static_cast<int>(std::tuple_size_v<PointNumbers>)) && ...));
  static_assert(((Kinds::rows > 0) && ...));
};

using LeafKinds = LeafKindList<QuadLeaf, AlignedQuadLeaf, UprightBoxLeaf, SphereLeaf, MovingSphereLeaf, TriangleLeaf,
                               DiskLeaf, TurnedBoxLeaf>;

using LeafShape = LeafKinds::Shape;

/// The set that holds primitives of this kind, if the geometry is one; else null.
template <class Leaf>
const typename Leaf::Set* setOf(const ShapeGeometry& geometry) {
  const auto* set = std::get_if<typename Leaf::Set>(&geometry);
  return set && Leaf::takes(*set) ? set : nullptr;
}

}  // namespace steradian
