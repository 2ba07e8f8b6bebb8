#pragma once
/// Rooms with motion while the shutter is open, and the same rooms frozen at one time.
#include "steradian/core/scene/description.h"

namespace steradian::test {

/// Scales, then turns about x, y and z (radians), then moves.
Matrix placed(Vec3f translation, Vec3f rotation = {}, Vec3f scale = {1.0f, 1.0f, 1.0f});

/// A sphere that flies.
SceneDescription flyingSphere();
/// A box that turns, grows and moves.
SceneDescription tumblingBox();
/// Instances of a box and a ball that turn and move; the ball moves in them.
SceneDescription tumblingInstances();
/// No light but those that move: a quad, a ball that becomes an egg, a ball that flies, and an instance of a disk.
SceneDescription movingLights();
/// All of that.
SceneDescription everythingMoves();

/// The scene at `time`, at rest: shapes with a motion of their own become instances.
SceneDescription frozen(const SceneDescription& scene, float time);

}  // namespace steradian::test
