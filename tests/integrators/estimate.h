#pragma once
/// Means of pictures with honest standard errors, for Z-tests.
#include <gtest/gtest.h>

#include "steradian/integrators/render/integrator.h"
#include "steradian/integrators/render/render.h"

namespace steradian::test {

struct Estimate {
  double mean = 0.0, standardError = 0.0;
};

/// The mean luminance of the film's crop. Pixels are independent of one another, and each has R replicates.
Estimate meanOf(const Film& film);

/// The mean luminance of a picture of `size` x `size` pixels with 8 independent replicates.
Estimate meanOf(const Scene& scene, const Integrator& integrator, int size, std::uint32_t samplesPerPixel,
                std::uint32_t seed = 0);

/// Whether two independent estimates have the same expectation, at the suite's level; differences below 1e-4 of the
/// mean do not count.
testing::AssertionResult agree(const Estimate& a, const Estimate& b);
/// The same for a known value.
testing::AssertionResult agree(const Estimate& a, double expected);

}  // namespace steradian::test
