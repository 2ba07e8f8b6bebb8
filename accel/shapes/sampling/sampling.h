#pragma once
/// The sampling layer in one header, for use on its own: no scene, no ray tracer, nothing but header, `core` and the
/// shapes that are sampled.
///
///     const auto w = CosineHemisphere<float>::sample(u);                            // warps
///     const MixturePdf mixture(std::array{0.5f, 0.5f}, toLight, CosinePdf(n));      // densities of directions
///     const auto s = sampleDirection(Sphere<float>{{0, 5, 0}, 1}, from, u);         // shapes by solid angle
///     const PiecewiseConstant2D sky(weights, columns, rows);                        // tables
///     const float w1 = misWeight(pdfOfThis, pdfOfThat);                             // the power heuristic
#include "steradian/accel/shapes/sampling/box_sampling.h"
#include "steradian/accel/shapes/sampling/disk_sampling.h"
#include "steradian/accel/shapes/sampling/hittable_pdf.h"
#include "steradian/accel/shapes/sampling/quad_sampling.h"
#include "steradian/accel/shapes/sampling/sphere_sampling.h"
#include "steradian/accel/shapes/sampling/triangle_sampling.h"
#include "steradian/core/samplers/sampler.h"
#include "steradian/core/sampling/direction_pdf.h"
#include "steradian/core/sampling/distribution.h"
#include "steradian/core/sampling/ggx.h"
#include "steradian/core/sampling/henyey_greenstein.h"
#include "steradian/core/sampling/hierarchical_warp.h"
#include "steradian/core/sampling/line_density.h"
#include "steradian/core/sampling/sampled_inverse_cdf.h"
#include "steradian/core/sampling/warp.h"
#include "steradian/core/sampling/weighted_reservoir.h"
#include "steradian/core/transport/scattering.h"
