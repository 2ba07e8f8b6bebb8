#pragma once
/// All lights of a scene: chooses one by power, samples it, and tells what a ray that hits one finds.
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "steradian/core/bounds.h"
#include "steradian/lights/area_lights.h"
#include "steradian/lights/dirac_lights.h"
#include "steradian/lights/light_selection.h"
#include "steradian/lights/sky.h"

namespace steradian {

/// What sample() may choose from. Point, spot and distant lights always: nothing else finds them.
struct LightSetSettings {
  bool sampleAreas = true;  ///< false for the strategies that find them otherwise (`bsdf`, `mixture`)
  /// Skies are smooth: scattering finds them about as well, and without them the samples go to the other lights.
  /// `light` needs true.
  bool sampleSkies = false;
};

/// For people: an emitting shape with all its primitives and instances, or another light.
struct LightInfo {
  std::string kind;          ///< "quad", "sphere", ..., "point", "spot", "distant", "sky"
  std::string name;          ///< may be empty; that of the sky is always
  std::size_t count = 1;     ///< of primitives
  Rgb power;                 ///< W per channel; of distant lights and skies what enters the scene's bounding sphere
  float probability = 0.0f;  ///< of being chosen by sample()
};

/// Selection: in proportion to the luminance of the power, whatever the place. A light without power is never chosen.
/// All skies together are one light. What sample() does not choose has pdf 0 in emission(), so that MIS weights of the
/// other techniques are 1.
class LightSet {
 public:
  /// The description must be valid. `sceneBounds` measures the power of distant lights and skies.
  LightSet(const SceneDescription& scene, const Bounds3& sceneBounds, LightSetSettings settings = {});

  /// One light, one direction. pdf 0: no sample.
  LightSample<float> sample(const ScatterPoint<float>& from, const LightRandom<float>& random) const;

  /// What `ray`, which left `from`, finds: the emission of the surface it hit, or of the skies where hit.valid is
  /// false; with the density with which sample(from) would have chosen ray.direction through that light. Where lights
  /// overlap, each is a light of its own.
  Emission<float> emission(const ScatterPoint<float>& from, const Ray<float>& ray,
                           const SurfacePoint<float>& hit) const;

  /// The radiance alone, where the density does not matter (after the camera, after Dirac bounces).
  Rgb radiance(const Ray<float>& ray, const SurfacePoint<float>& hit) const;

  /// sample() never makes a sample. emission() may find light all the same.
  bool empty() const { return selection_.empty(); }
  /// Number of lights: primitives and their instances one by one, the skies as one.
  std::size_t size() const { return areas_.size() + diracs_.size() + (sky_ ? 1u : 0u); }
  const AreaLights& areas() const { return areas_; }
  const std::vector<LightInfo>& info() const { return info_; }

 private:
  using DiracLight = std::variant<PointLight, PreparedSpot, DistantLight>;

  /// One light's entry in info_ and its weight in the selection.
  struct Weighed {
    std::size_t entry;
    float weight;
  };
  void listAreas(const SceneDescription& scene, bool sampled, std::vector<Weighed>& weighed);
  void listOthers(const SceneDescription& scene, float sceneRadius, bool sampleSkies, std::vector<Weighed>& weighed);

  AreaLights areas_;
  std::vector<DiracLight> diracs_;
  std::optional<Sky> sky_;
  LightSelection selection_{{}};  ///< area lights, Dirac lights, sky
  std::vector<LightInfo> info_;
};

}  // namespace steradian
