#pragma once
/// The weights that combine light sampling with scattering (multiple importance sampling: Veach 1997, section 9.2).
///
/// Light that reaches a vertex from a certain direction may be found in two ways: by one of the vertex's light samples,
/// or by the scattered ray, if that hits the light. Both are counted, with weights that add up to 1. Dirac
/// distributions need no special case: their density kDirac is infinite, and the weights become 0 and 1.
#include "steradian/core/base/api.h"
#include "steradian/core/transport/scattering.h"
#include "steradian/integrators/path/path_settings.h"

namespace STERADIAN_API steradian {

/// The weight of a light sample: the power heuristic (Veach 1997, 9.2.4) for `lightSamples` samples of density
/// `lightPdf` > 0 against one scattered ray of density `scatterPdf`. Densities are per steradian, of one direction.
template <class F>
F lightSampleWeight(F lightSamples, F lightPdf, F scatterPdf) {
  return misWeight(lightSamples * lightPdf, scatterPdf);
}

/// The weight of emitted radiance that a scattered ray of density `scatterPdf` has found: 1 less the weight of a light
/// sample. It is 1 where light sampling cannot find the emitter and `lightPdf` is therefore 0.
template <class F>
F emissionWeight(F scatterPdf, F lightSamples, F lightPdf) {
  return select(lightPdf > F(0.0f), misWeight(scatterPdf, lightSamples * lightPdf), F(1.0f));
}

/// The density with which scattering enters these weights: `pdf`, that of the sampled direction, in all strategies but
/// `light`. There emission counts only after Dirac lobes and at vertices that lights are not sampled for
/// (`lightSampled` is false): such rays get density kDirac and all of the weight, all others 0 and none.
template <class F>
F competingDensity(Strategy strategy, MaskOf<F> lightSampled, F pdf) {
  if (strategy != Strategy::Light) return pdf;
  return select(lightSampled & (pdf != F(kDirac)), F(0.0f), F(kDirac));
}

}  // namespace steradian
