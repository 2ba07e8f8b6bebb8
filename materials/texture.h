#pragma once
/// Colours over surfaces, flattened for lookup: no allocation, no virtual call.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "steradian/materials/image_texture.h"
#include "steradian/materials/perlin_noise.h"

namespace STERADIAN_API steradian {

class TextureSet {
 public:
  TextureSet() = default;
  /// Ids as in the description, which must be valid (see validate()).
  explicit TextureSet(const std::vector<TextureDescription>& textures);

  /// The colour at a point of the surface; kNone is black. A solid (World) texture takes the cell of the matter just
  /// below the surface, so that a face lying in the boundary of two cells has one colour and not the pattern of
  /// rounding; noise, which is smooth, takes the position as it is.
  Rgb value(Id texture, const SurfacePoint<float>& at) const;

  /// The value of a texture that is the same everywhere.
  std::optional<Rgb> constant(Id texture) const;

  /// The pattern of a texture that is noise, for several points at once; else null.
  const NoisePattern* noise(Id texture) const {
    const bool isNoise = texture < nodes_.size() && nodes_[texture].kind == Kind::Noise;
    return isNoise ? &noises_[nodes_[texture].index] : nullptr;
  }

  /// Whether value() reads uv, for this texture or for those that it chooses from.
  bool readsUv(Id texture) const { return texture < nodes_.size() && nodes_[texture].readsUv; }

 private:
  enum class Kind : std::uint8_t { Constant, CheckerWorld, CheckerUv, Image, Noise };
  struct Node {
    Kind kind = Kind::Constant;
    Rgb value;
    Id even = kNone, odd = kNone;
    float frequency = 1.0f;   ///< cells per scene unit, or over the parameter range
    std::uint32_t index = 0;  ///< Image, Noise: among those
    bool readsUv = false;
  };
  Node compile(const TextureDescription& texture);

  std::vector<Node> nodes_;
  std::vector<ImageTextureLookup> images_;
  std::vector<NoisePattern> noises_;
};

}  // namespace steradian
