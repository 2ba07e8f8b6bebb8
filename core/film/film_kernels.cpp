#include "steradian/core/film/film_kernels.h"

namespace steradian {

const FilmKernels& filmKernels(Isa isa) {
  if constexpr (STERADIAN_DISPATCH) {
    if (isa == Isa::Avx2) return avx2::filmKernels;
    if (isa == Isa::Avx512) return avx512::filmKernels;
  }
  return baseline::filmKernels;
}

}  // namespace steradian
