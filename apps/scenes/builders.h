#pragma once
/// One function per built-in scene; scenes.cpp lists them.
#include <cstdint>

#include "steradian/core/scene/description.h"

namespace steradian::scenes {

// one_weekend.cpp: "Ray Tracing in One Weekend"
SceneDescription oneWeekend();
SceneDescription oneWeekendMaterials();
SceneDescription bouncingSpheres();  // of "The Next Week"
/// The sky of the book: white at the nadir, light blue at the zenith.
GradientSky bookSky();

// one_weekend_pictures.cpp
/// The scene of the book's picture of that number, 4 to 23. Pictures of normals need the integrator `normals`. For
/// picture 15 the book shows a wrong render; this is its scene.
SceneDescription oneWeekendPicture(std::uint32_t picture);

// next_week.cpp: "Ray Tracing: The Next Week"
SceneDescription checkeredSpheres();
/// With the picture of earth_picture.h in the place of the book's photograph.
SceneDescription earth();
ImageTexture earthTexture();
SceneDescription perlinSpheres();
SceneDescription quads();
SceneDescription simpleLight();

// next_week_final.cpp: the cube of spheres as an instance, or sphere by sphere, which is faster (one hierarchy for all)
SceneDescription nextWeekFinal(bool instanced);

// cornell.cpp: the Cornell boxes of "The Next Week" and "The Rest of Your Life"
SceneDescription cornellOriginal();
SceneDescription cornellSmoke();
/// The same with surfaces that scatter uniformly into the hemisphere ("The Rest of Your Life", 6.3).
SceneDescription cornellUniformDiffuse();
SceneDescription cornellBox();
SceneDescription cornellAluminium();
SceneDescription cornellGlassSphere();

// nested_glass.cpp, door_crack.cpp
SceneDescription nestedGlass();
SceneDescription doorCrack();

// generated.cpp
/// N boxes on the floor of the Cornell room, one to a cell of a square grid.
///
/// With n = ceil(sqrt N), cell c = 555 / n, and u_k the k-th word of randomWords(i, 0, 0, 0x63697479) as a float in
/// [0, 1): box i stands in column i mod n and row i div n, its edges along x and z are c (0.3 + 0.35 u_0) and
/// c (0.3 + 0.35 u_1), its height 40 + 290 u_2^2, its turn about y 90 u_3 degrees. The half diagonal of its base is
/// below 0.46 c, so neighbours never overlap.
SceneDescription cornellCity(std::uint32_t boxes);
/// N Cornell rooms, ceil(sqrt N) to a floor, 565 units apart, as instances of one group; each has its own light.
SceneDescription cornellTower(std::uint32_t rooms);

// cornell.cpp: parts that the generated scenes use
/// Adds the five walls of the Cornell room and returns the ids of their shapes.
std::vector<Id> addCornellWalls(SceneDescription& scene);
/// Adds the 130 x 105 light under the ceiling, facing down.
Id addCornellLight(SceneDescription& scene, bool twoSided);
/// Adds the tall or the short box of the books.
Id addTallBox(SceneDescription& scene, Id material);
Id addShortBox(SceneDescription& scene, Id material);
PerspectiveCamera cornellCamera();
/// The white of walls and boxes; added once per scene.
Id whiteOf(SceneDescription& scene);

}  // namespace steradian::scenes
