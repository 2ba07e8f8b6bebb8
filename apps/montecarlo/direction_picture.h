#pragma once
/// The books' plot of random directions.
#include <cstdint>
#include <string>

namespace steradian::montecarlo {

/// An SVG picture of `count` uniform directions as points of the unit sphere, once with independent, stratified and
/// Sobol' points each; those of the far side are pale.
std::string directionsSvg(std::uint32_t count, std::uint32_t seed);

}  // namespace steradian::montecarlo
