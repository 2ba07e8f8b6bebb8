#pragma once
/// The exact error of the books' stratified estimate of pi.
#include <cstdint>

namespace steradian::montecarlo {

/// The standard error of 4 x the share of n x n points inside the unit circle, one uniform point in each cell of a grid
/// over [-1, 1]^2; n even. Only the cells that the circle crosses count: a cell of which the share p lies inside adds
/// p (1 - p). For large n it falls as n^(-3/2), that is N^(-3/4).
double jitteredCircleError(std::uint32_t n);

}  // namespace steradian::montecarlo
