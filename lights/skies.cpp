#include "steradian/lights/skies.h"

#include <algorithm>

namespace steradian {

Skies::Skies(const SceneDescription& scene, bool sampleSmooth, bool samplePictures) {
  Sky smooth;
  bool hasSmooth = false;
  for (const LightDescription& light : scene.lights) {
    if (const auto* constant = std::get_if<ConstantSky>(&light.model)) smooth.add(*constant), hasSmooth = true;
    if (const auto* gradient = std::get_if<GradientSky>(&light.model)) smooth.add(*gradient), hasSmooth = true;
    if (const auto* image = std::get_if<ImageSky>(&light.model))
      parts_.push_back({EnvironmentMap(*image, samplePictures), samplePictures});
  }
  if (hasSmooth) parts_.push_back({smooth, sampleSmooth});
  setShares();
}

Skies::Skies(const Skies& skies, bool sampleSmooth, bool samplePictures) {
  for (const Part& part : skies.parts_) {
    if (const auto* picture = std::get_if<EnvironmentMap>(&part.sky)) {
      parts_.push_back({EnvironmentMap(*picture, samplePictures), samplePictures});
    } else {
      parts_.push_back({part.sky, sampleSmooth});
    }
  }
  setShares();
}

void Skies::setShares() {
  std::vector<float> weights;
  for (const Part& part : parts_) {
    const Rgb total = std::visit([](const auto& sky) { return sky.total(); }, part.sky);
    weights.push_back(part.sampled ? luminance(total) : 0.0f);
  }
  const auto bright = std::count_if(weights.begin(), weights.end(), [](float w) { return w > 0.0f; });
  if (bright > 1) choice_.emplace(weights, 0.0f, static_cast<float>(weights.size()));
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (weights[i] > 0.0f) parts_[i].share = choice_ ? choice_->probability(i) : 1.0f;
  }
}

Rgb Skies::power(float sceneRadius) const {
  Rgb total;
  for (const Part& part : parts_) total += std::visit([](const auto& sky) { return sky.total(); }, part.sky);
  return total * (kPi * sceneRadius * sceneRadius);
}

Rgb Skies::sampledPower(float sceneRadius) const {
  Rgb total;
  for (const Part& part : parts_) {
    if (part.sampled) total += std::visit([](const auto& sky) { return sky.total(); }, part.sky);
  }
  return total * (kPi * sceneRadius * sceneRadius);
}

}  // namespace steradian
