#pragma once
/// From densities over a surface to densities over the directions that it is seen in.
#include "steradian/core/transport/scattering.h"

namespace STERADIAN_API steradian {

/// Density per sr of the direction to a point that was chosen with `pdfPosition` per m^2, at `distance` from the viewer
/// on a plane that passes the viewer at `height` = distance |cos|: pdfPosition distance^2 / |cos|.
template <class F>
F densityPerSteradian(F pdfPosition, F distance, F height) {
  return pdfPosition * distance * distance * (distance / height);
}

/// The sample, or "no sample" (pdf 0, everything finite) where it is not valid or its density is not a positive float.
template <class F>
DirectionSample<F> sampleIf(MaskOf<F> valid, Vec3<F> wi, F pdf, F distance) {
  const MaskOf<F> finitePdf = isFinite(pdf), finiteDistance = isFinite(distance);
  const MaskOf<F> good = valid & (pdf > F(0.0f)) & finitePdf & finiteDistance;
  const Vec3<F> anywhere{F(0.0f), F(0.0f), F(1.0f)};
  return {select(good, wi, anywhere), select(good, pdf, F(0.0f)), select(good, distance, F(0.0f))};
}

/// The density of a given direction, by the same rule.
template <class F>
F densityIf(MaskOf<F> valid, F pdf) {
  return select(valid & (pdf > F(0.0f)) & isFinite(pdf), pdf, F(0.0f));
}

}  // namespace steradian
