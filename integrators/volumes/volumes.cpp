#include "steradian/integrators/volumes/volumes.h"

#include <algorithm>

namespace steradian {

// --- Bodies -----------------------------------------------------------------------------------------------------

std::uint32_t Bodies::find(const Body& body) const {
  std::uint32_t i = 0;
  while (i < count_ && !bodies_[i].isSame(body)) ++i;
  return i;
}

void Bodies::enter(const Body& body) {
  if (count_ < kMost && !contains(body)) bodies_[count_++] = body;
}

void Bodies::leave(const Body& body) {
  const std::uint32_t i = find(body);
  if (i == count_) return;
  std::copy(bodies_.begin() + i + 1, bodies_.begin() + count_, bodies_.begin() + i);
  --count_;
}

const Bodies::Body* Bodies::top(const Body* other) const {
  const Body* best = nullptr;
  for (std::uint32_t i = 0; i < count_; ++i) {
    if (other != nullptr && bodies_[i].isSame(*other)) continue;
    if (best == nullptr || bodies_[i].priority >= best->priority) best = &bodies_[i];
  }
  return best;
}

// --- Volumes ----------------------------------------------------------------------------------------------------

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

std::uint32_t Volumes::mediumIn(const Bodies& bodies) const {
  const Bodies::Body* top = bodies.top();
  const Id medium = top != nullptr ? top->medium : outside_;
  return medium < media_.none() ? medium : media_.none();
}

Bodies::Body Volumes::bodyOf(const SurfacePoint<float>& at) const {
  const Closed& closed = closed_[at.shape];
  const int priority = closed.interior.priority;
  const float eta = priority > 0 && at.material < materials_.size() ? materials_[at.material].eta : 1.0f;
  return {at.shape, closed.byPrimitive ? at.primitive : 0u, at.instance, closed.interior.medium, priority, eta};
}

Boundary Volumes::boundary(const SurfacePoint<float>& at, Vec3f direction, const Bodies& bodies) const {
  if (at.material < materials_.size() && materials_[at.material].isInterface) return {false};
  if (!isClosed(at.shape) || closed_[at.shape].interior.priority == 0) return {};
  const Bodies::Body self = bodyOf(at);
  const Bodies::Body* other = bodies.top(&self);
  if (other == nullptr) return {};
  // The surface is there if what counts differs on its two sides.
  const bool enters = dot(direction, at.geometricNormal) < 0.0f;
  const bool isReal = enters || !bodies.contains(self) ? other->priority <= self.priority : bodies.top()->isSame(self);
  return {isReal, other->eta};
}

void Volumes::cross(const SurfacePoint<float>& at, Vec3f direction, Bodies& bodies) const {
  if (!isClosed(at.shape)) return;
  if (dot(direction, at.geometricNormal) < 0.0f) {
    bodies.enter(bodyOf(at));
  } else {
    bodies.leave(bodyOf(at));
  }
}

}  // namespace steradian
