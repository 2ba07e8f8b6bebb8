#pragma once
/// A finished render as an image that says where it comes from.
#include "steradian/core/image/image.h"
#include "steradian/integrators/render/render.h"
#include "steradian/integrators/scene/scene.h"

namespace STERADIAN_API steradian {

/// The film's image with metadata. Of names that others know: "worldToCamera", "worldToNDC" (core/scene/camera.h; the
/// second not for spherical cameras), "chromaticities" (Rec.709), "software", "renderTime" (seconds). Our own:
/// "steradian.scene" (its name), "steradian.sceneHash" (scene_hash.h), "steradian.seed", "steradian.sampler",
/// "steradian.replicates" and "steradian.ledger" (core/film/sample_ledger.h: which samples it contains).
Image renderedImage(const RenderResult& result, const Scene& scene, const FilmImageOptions& options = {});

}  // namespace steradian
