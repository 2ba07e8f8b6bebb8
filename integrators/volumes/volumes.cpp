#include "steradian/integrators/volumes/volumes.h"

#include <algorithm>

namespace steradian {

Volumes::Volumes(const SceneDescription& scene) : media_(scene.media), outside_(scene.outside) {
  for (const MaterialDescription& m : scene.materials) {
    Material& material = materials_.emplace_back();
    material.isInterface = std::holds_alternative<InterfaceMaterial>(m.model);
    if (const auto* dielectric = std::get_if<DielectricMaterial>(&m.model)) material.eta = dielectric->eta;
    passable_ = passable_ || material.isInterface;
  }
  for (const ShapeDescription& shape : scene.shapes) {
    Closed& closed = closed_.emplace_back();
    closed.isClosed = shape.interior.has_value();
    closed.byPrimitive = !std::holds_alternative<TriangleMesh>(shape.geometry);
    if (!shape.interior) continue;
    closed.interior = *shape.interior;
    needed_ = true;
    passable_ = passable_ || closed.interior.priority > 0;
  }
  for (const ShapeDescription& shape : scene.shapes) {
    const auto isInterface = [&](Id material) {
      return material < materials_.size() && materials_[material].isInterface;
    };
    const bool more = shape.interior || isInterface(shape.material) ||
                      std::any_of(shape.primitiveMaterials.begin(), shape.primitiveMaterials.end(), isInterface);
    moreThanWall_.push_back(more ? 1u : 0u);
  }
  moreThanWall_.push_back(0u);  // where there is no shape at all
  needed_ = needed_ || passable_ || outside_ != kNone;
}

std::uint32_t Volumes::mediumIn(const InteriorStack& interior) const {
  const InteriorStack::Entry* top = interior.top();
  const Id medium = top != nullptr ? top->medium : outside_;
  return medium < media_.none() ? medium : media_.none();
}

InteriorStack::Entry Volumes::entryOf(const SurfacePoint<float>& at) const {
  const Closed& closed = closed_[at.shape];
  const int priority = closed.interior.priority;
  const float eta = priority > 0 && at.material < materials_.size() ? materials_[at.material].eta : 1.0f;
  return {at.shape, closed.byPrimitive ? at.primitive : 0u, at.instance, closed.interior.medium, priority, eta};
}

Boundary Volumes::boundary(const SurfacePoint<float>& at, Vec3f direction, const InteriorStack& interior) const {
  if (at.material < materials_.size() && materials_[at.material].isInterface) return {false};
  if (!isClosed(at.shape) || closed_[at.shape].interior.priority == 0) return {};
  const InteriorStack::Entry self = entryOf(at);
  const InteriorStack::Entry* other = interior.top(&self);
  if (other == nullptr) return {};
  // The surface is there if what counts differs on its two sides.
  const bool enters = dot(direction, at.geometricNormal) < 0.0f;
  const bool isReal =
      enters || !interior.contains(self) ? other->priority <= self.priority : interior.top()->isSame(self);
  return {isReal, other->eta};
}

void Volumes::cross(const SurfacePoint<float>& at, Vec3f direction, InteriorStack& interior) const {
  if (!isClosed(at.shape)) return;
  if (dot(direction, at.geometricNormal) < 0.0f) {
    interior.enter(entryOf(at));
  } else {
    interior.leave(entryOf(at));
  }
}

}  // namespace steradian
