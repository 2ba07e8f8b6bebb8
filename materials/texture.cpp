#include "steradian/materials/texture.h"

#include <cmath>

namespace steradian {
namespace {

/// Parity of floor(x), also for |x| beyond every integer type.
bool oddFloor(float x) {
  const float half = 0.5f * std::floor(x);
  return half != std::floor(half);
}

Vec3f belowSurface(const SurfacePoint<float>& at) {
  return at.position - at.geometricNormal * (2.0f * dot(absolute(at.geometricNormal), at.positionError));
}

}  // namespace

TextureSet::TextureSet(const std::vector<TextureDescription>& textures) {
  nodes_.reserve(textures.size());
  for (const TextureDescription& texture : textures) nodes_.push_back(compile(texture));
}

TextureSet::Node TextureSet::compile(const TextureDescription& texture) {
  Node node;
  if (const auto* constant = std::get_if<ConstantTexture>(&texture)) {
    node.value = constant->value;
  } else if (const auto* checker = std::get_if<CheckerTexture>(&texture)) {
    const bool world = checker->space == CheckerTexture::Space::World;
    node.kind = world ? Kind::CheckerWorld : Kind::CheckerUv;
    node.even = checker->even;
    node.odd = checker->odd;
    node.frequency = world ? 1.0f / checker->scale : checker->scale;
    node.readsUv = !world || readsUv(checker->even) || readsUv(checker->odd);
  } else if (const auto* image = std::get_if<ImageTexture>(&texture)) {
    node.kind = Kind::Image;
    node.index = static_cast<std::uint32_t>(images_.size());
    node.readsUv = true;
    images_.emplace_back(*image);
  } else if (const auto* noise = std::get_if<NoiseTexture>(&texture)) {
    node.kind = Kind::Noise;
    node.index = static_cast<std::uint32_t>(noises_.size());
    noises_.emplace_back(*noise);
  }
  return node;
}

Rgb TextureSet::value(Id texture, const SurfacePoint<float>& at) const {
  // A chain of checkers has no more links than there are textures.
  for (std::size_t links = 0; links <= nodes_.size(); ++links) {
    if (texture >= nodes_.size()) return {};
    const Node& node = nodes_[texture];
    bool odd = false;
    switch (node.kind) {
      case Kind::Constant:
        return node.value;
      case Kind::CheckerWorld: {
        const Vec3f p = belowSurface(at) * node.frequency;
        odd = (oddFloor(p.x) != oddFloor(p.y)) != oddFloor(p.z);
        break;
      }
      case Kind::CheckerUv:
        odd = oddFloor(at.uv.x * node.frequency) != oddFloor(at.uv.y * node.frequency);
        break;
      case Kind::Image:
        return images_[node.index].value(at.uv);
      case Kind::Noise:
        return noises_[node.index].value(at.position);
    }
    texture = odd ? node.odd : node.even;
  }
  return {};
}

std::optional<Rgb> TextureSet::constant(Id texture) const {
  if (texture >= nodes_.size()) return Rgb{};
  const Node& node = nodes_[texture];
  return node.kind == Kind::Constant ? std::optional(node.value) : std::nullopt;
}

}  // namespace steradian
