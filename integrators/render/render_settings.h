#pragma once
/// How a picture is to be sampled.
#include <cstdint>
#include <optional>

#include "steradian/core/base/execution_settings.h"
#include "steradian/core/film/film.h"
#include "steradian/core/film/filter.h"
#include "steradian/core/samplers/sampler.h"

namespace STERADIAN_API steradian {

struct RenderSettings {
  /// Of the full picture. Nothing: as the scene says; one of the two given: with the scene's aspect ratio.
  std::optional<int> width = std::nullopt, height = std::nullopt;
  /// The part to render; pixels are those of the full picture, bit for bit.
  std::optional<Crop> crop = std::nullopt;
  /// Nothing: as the scene says, or with a time limit as many as it allows.
  std::optional<std::uint32_t> samplesPerPixel = std::nullopt;
  /// Index of the first sample: shards of one picture render different ranges with the same seed. Not with a
  /// sampler whose points depend on the number of all samples: needsSampleCount() (core/samplers/sampler.h).
  std::uint32_t firstSample = 0;
  /// Seconds of rendering. No pass begins that would probably exceed it; the first pass always ends.
  std::optional<double> timeLimit = std::nullopt;
  std::uint32_t seed = 0;
  SamplerType sampler = SamplerType::Sobol;
  Filter filter{FilterType::Box};
  /// 1: one sequence; R >= 2: R independently scrambled ones, for unbiased standard errors (core/film/film.h).
  std::uint32_t replicates = 1;
  /// Edge of a tile in pixels: a matter of speed only.
  int tileSize = 16;
  /// Instruction set of integrator and film, and paths traced at once: a matter of speed only.
  ExecutionSettings execution = {};
};

}  // namespace steradian
