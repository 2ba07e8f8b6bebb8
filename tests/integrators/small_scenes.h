#pragma once
/// Scenes of a few shapes, whose radiance is known or quick to estimate.
#include "steradian/core/scene/description.h"
#include "steradian/integrators/render/render_settings.h"

namespace steradian::test {

Id addQuad(SceneDescription& scene, Vec3f corner, Vec3f u, Vec3f v, Id material);
Id addSphere(SceneDescription& scene, Vec3f center, float radius, Id material);
/// Turned by `degrees` about the vertical axis through its centre.
Id addBox(SceneDescription& scene, Vec3f center, Vec3f half, float degrees, Id material);
Id addLambert(SceneDescription& scene, Rgb reflectance);
Id addAbsorber(SceneDescription& scene);

/// The inside of the cube from (-1, -1, -1) to (1, 1, 1), seen from its middle; every wall emits `radiance` and
/// reflects diffusely. Radiance after d bounces is the geometric series radiance (1 + r + ... + r^d) everywhere.
SceneDescription furnace(float reflectance, float radiance);

/// A unit sphere of the material in a sky of radiance 1, filling the picture.
SceneDescription sphereInSky(MaterialModel material);

/// A wide white floor at y = 0, of which the camera sees the point (0, 0, 0) only, for one bounce.
SceneDescription floorPoint();

/// A room of 2 x 2 x 2 about the origin, open to the camera at +z, 40 % grey, with a light of 0.8 x 0.8 and radiance 5
/// under the ceiling. Tests add objects to it.
SceneDescription room();

/// A few shapes on a white floor under a picture of a sky, 16 x 8, with a bright pixel in it.
SceneDescription underAnEnvironmentMap();

/// The size and number of samples of a picture, other settings at their defaults.
RenderSettings settingsOf(int width, int height, std::uint32_t samplesPerPixel, std::uint32_t seed = 0);

}  // namespace steradian::test
