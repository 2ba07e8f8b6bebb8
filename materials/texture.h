#pragma once
/// The textures of a scene, prepared for lookup without allocation or virtual calls.
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

  /// The colour at a point of the surface; kNone is black. A checker in world space is looked up just below the
  /// surface: a face that lies exactly between two cells has one colour then, and not whichever rounding picks. Noise
  /// is smooth, and is looked up at the position itself.
  Rgb value(Id texture, const SurfacePoint<float>& at) const;

  /// The colour of a texture that has the same everywhere; else nothing.
  std::optional<Rgb> constant(Id texture) const;

  /// The pattern of a texture that is noise, for several points at once; else null.
  const NoisePattern* noise(Id texture) const {
    const bool isNoise = texture < nodes_.size() && nodes_[texture].kind == Kind::Noise;
    return isNoise ? &noises_[nodes_[texture].index] : nullptr;
  }

  /// Whether value() reads uv, for this texture or for those that a checker refers to.
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
