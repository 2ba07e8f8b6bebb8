#pragma once
/// Colours over surfaces, flattened for lookup: no allocation, no virtual call.
#include <cstddef>
#include <optional>
#include <vector>

#include "steradian/core/description.h"

namespace steradian {

class TextureSet {
 public:
  TextureSet() = default;
  /// Ids as in the description, which must be valid (see validate()).
  explicit TextureSet(const std::vector<TextureDescription>& textures);

  /// The colour at a point of the surface; kNone is black. A solid (World) texture takes the cell of the matter just
  /// below the surface, so that a face lying in the boundary of two cells has one colour and not the pattern of
  /// rounding.
  Rgb value(Id texture, const SurfacePoint<float>& at) const;

  /// The value of a texture that is the same everywhere.
  std::optional<Rgb> constant(Id texture) const;

 private:
  enum class Kind : std::uint8_t { Constant, CheckerWorld, CheckerUv };
  struct Node {
    Kind kind = Kind::Constant;
    Rgb value;
    Id even = kNone, odd = kNone;
    float frequency = 1.0f;  ///< cells per scene unit, or over the parameter range
  };
  std::vector<Node> nodes_;
};

}  // namespace steradian
