#pragma once
/// The sampling layer in one header, for use on its own: no scene, no ray tracer, nothing but header, `core` and the
/// shapes that are sampled.
///
///     const auto w = CosineHemisphere<float>::sample(u);                            // warps
///     const MixturePdf mixture(std::array{0.5f, 0.5f}, toLight, CosinePdf(n));      // densities of directions
///     const auto s = sampleDirection(Sphere<float>{{0, 5, 0}, 1}, from, u);         // shapes by solid angle
///     const PiecewiseConstant2D sky(weights, columns, rows);                        // tables
///     const float w1 = misWeight(pdfOfThis, pdfOfThat);                             // the power heuristic
#include "steradian/accel/shapes/box_sampling.h"
#include "steradian/accel/shapes/disk_sampling.h"
#include "steradian/accel/shapes/hittable_pdf.h"
#include "steradian/accel/shapes/quad_sampling.h"
#include "steradian/accel/shapes/sphere_sampling.h"
#include "steradian/accel/shapes/triangle_sampling.h"
#include "steradian/core/direction_pdf.h"
#include "steradian/core/distribution.h"
#include "steradian/core/ggx.h"
#include "steradian/core/henyey_greenstein.h"
#include "steradian/core/hierarchical_warp.h"
#include "steradian/core/line_density.h"
#include "steradian/core/sampled_inverse_cdf.h"
#include "steradian/core/sampler.h"
#include "steradian/core/scattering.h"
#include "steradian/core/warp.h"
#include "steradian/core/weighted_reservoir.h"
