#include "steradian/lights/target_set.h"

#include <utility>

#include "steradian/accel/shapes/sampling/sampled_shape_at.h"

namespace steradian {
namespace {

constexpr const char* kLights = "lights";

/// An object: its primitives with their weights, which add up to 1.
struct Object {
  std::vector<SampledShape> shapes;
  std::vector<float> weights;

  void add(SampledShape shape, float weight) {
    shapes.push_back(std::move(shape));
    weights.push_back(weight);
  }
  void normalise() {
    double sum = 0.0;
    for (const float w : weights) sum += static_cast<double>(w);
    if (sum > 0.0) {
      for (float& w : weights) w = static_cast<float>(static_cast<double>(w) / sum);
    }
  }
};

Object objectOf(const AreaLights& lights) {
  Object object;
  for (std::size_t i = 0; i < lights.size(); ++i) object.add(lights[i].shape(), luminance(lights[i].power()));
  return object;
}

void addShape(const SceneDescription& scene, const Placements& placements, Id shape, Object& object) {
  const ShapeDescription& description = scene.shapes[shape];
  for (std::size_t i = 0; i < primitiveCount(description.geometry); ++i) {
    placements.forEachPlaceOf(shape, [&](const ShapePlacement& place) {
      SampledShape placed = sampledShapeOf(description, i, place.instance);
      const float area = placed.area();
      object.add(std::move(placed), area);
    });
  }
}

/// All shapes of one name are one object.
Object objectOf(const SceneDescription& scene, const AreaLights& lights, const std::string& name) {
  if (name == kLights) return objectOf(lights);
  const Placements placements(scene);
  Object object;
  bool found = false;
  for (Id shape = 0; shape < scene.shapes.size(); ++shape) {
    if (scene.shapes[shape].name != name) continue;
    found = true;
    addShape(scene, placements, shape, object);
  }
  if (found) return object;
  std::vector<std::string> names{kLights};
  for (const ShapeDescription& shape : scene.shapes) {
    if (!shape.name.empty()) names.push_back(shape.name);
  }
  Diagnostic diagnostic;
  diagnostic.message = "there is no target named \"" + name + "\": it is neither a shape nor \"lights\"";
  diagnostic.suggestion = didYouMean(name, names);
  throw Error(ErrorKind::Usage, diagnostic);
}

std::vector<Object> objectsOf(const SceneDescription& scene, const AreaLights& lights,
                              std::span<const std::string> names, TargetSet::Unnamed unnamed) {
  std::vector<Object> objects;
  for (const std::string& name : names) objects.push_back(objectOf(scene, lights, name));
  if (!names.empty()) return objects;
  const Placements placements(scene);
  const bool nonEmitters = unnamed == TargetSet::Unnamed::FlaggedNonEmitters;
  for (Id shape = 0; shape < scene.shapes.size(); ++shape) {
    const ShapeDescription& s = scene.shapes[shape];
    if (s.target && (s.emission == kNone || !nonEmitters)) addShape(scene, placements, shape, objects.emplace_back());
  }
  if (objects.empty() && !nonEmitters) objects.push_back(objectOf(lights));
  return objects;
}

TargetGroup groupOf(std::vector<Object> objects) {
  Object all;
  for (Object& object : objects) {
    object.normalise();
    for (std::size_t i = 0; i < object.shapes.size(); ++i) all.add(std::move(object.shapes[i]), object.weights[i]);
  }
  return TargetGroup(std::move(all.shapes), all.weights);
}

}  // namespace

TargetSet::TargetSet(const SceneDescription& scene, std::span<const std::string> names, Unnamed unnamed)
    : TargetSet(scene, AreaLights(scene), names, unnamed) {}

TargetSet::TargetSet(const SceneDescription& scene, const AreaLights& lights, std::span<const std::string> names,
                     Unnamed unnamed)
    : members_(groupOf(objectsOf(scene, lights, names, unnamed))) {}

}  // namespace steradian
