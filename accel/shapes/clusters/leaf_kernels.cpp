#include "steradian/accel/shapes/clusters/leaf_kernels.h"

namespace steradian {

const LeafKernels& leafKernels(Isa isa) {
  if constexpr (STERADIAN_DISPATCH) {
    if (isa == Isa::Avx2) return avx2::leafKernels;
    if (isa == Isa::Avx512) return avx512::leafKernels;
  }
  return baseline::leafKernels;
}

}  // namespace steradian
