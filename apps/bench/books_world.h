#pragma once
/// A scene in the books' objects, made from our description of it.
#include <memory>
#include <vector>

#include "steradian/apps/bench/books_materials.h"
#include "steradian/core/scene/description.h"

namespace steradian::bench::books {

/// Linear in y of the unit direction; black where there is no sky.
struct Background {
  Colour nadir{}, zenith{};

  Colour value(Vec direction) const;
};

struct World {
  std::vector<std::unique_ptr<const Texture>> textures;
  std::vector<std::unique_ptr<const Material>> materials;
  Object root;
  Background background;
  PerspectiveCamera camera;
  int maxDepth = 50;  ///< rays of a path, at most
};

/// Spheres (moving too), quads, boxes turned about y, groups and instances of these, materials and textures that the
/// books have, isotropic grey media, constant and linear skies. Throws Error (Usage) for anything else.
World makeWorld(const SceneDescription& scene);

}  // namespace steradian::bench::books
