#include "steradian/materials/medium_set.h"

namespace steradian {

MediumSet::MediumSet(const std::vector<MediumDescription>& media) {
  records_.reserve(media.size() + 1);
  for (const MediumDescription& m : media) {
    records_.push_back({m.absorption + m.scattering, m.scattering, m.emission, m.anisotropy, {}});
  }
  records_.push_back({});
}

}  // namespace steradian
