#include "steradian/materials/medium_set.h"

#include "steradian/core/math.h"

namespace steradian {
namespace {

template <class Function>
Rgb byChannel(Rgb a, Rgb b, const Function& f) {
  return {f(a.r, b.r), f(a.g, b.g), f(a.b, b.b)};
}

}  // namespace

Rgb Medium::transmittance(float length) const {
  const auto share = [&](float rate) { return rate > 0.0f ? exponential(-rate * length) : 1.0f; };
  return {share(extinction.r), share(extinction.g), share(extinction.b)};
}

Rgb Medium::emitted(float length) const {
  if (isBlack(emission)) return {};
  return byChannel(emission, extinction, [&](float source, float rate) {
    if (!(source > 0.0f)) return 0.0f;
    return rate > 0.0f ? source * (-exponentialMinusOne(-rate * length) / rate) : source * length;
  });
}

MediumSet::MediumSet(const std::vector<MediumDescription>& media) {
  media_.reserve(media.size());
  for (const MediumDescription& m : media) {
    media_.push_back({m.absorption + m.scattering, m.scattering, m.emission, m.anisotropy});
  }
}

}  // namespace steradian
