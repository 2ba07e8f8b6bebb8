#pragma once

/// Renders a few pixels with a shape and an integrator of its own: 0.5 if all is well.
__attribute__((visibility("default"))) float renderABit();
/// Gives the library a scene that is wrong, and throws what it throws.
__attribute__((visibility("default"))) void failALot();
