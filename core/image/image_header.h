#pragma once
/// The sizes that image files claim, read before a decoder opens them: decoders allocate memory for these as soon as
/// they open a file, damaged or not, so a later check would be too late.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

/// What an OpenEXR file claims to hold, read from its header alone.
struct ExrExtent {
  std::uint64_t width = 0;   ///< of the widest part
  std::uint64_t height = 0;  ///< of the highest part
  std::uint64_t values = 0;  ///< pixels (at least a tile) times channels, in all parts; 2^53 if there are more
};

/// Reads the data windows and channel counts of all parts; OpenEXR allocates tables in proportion to the data window.
/// Empty if the header is damaged or lacks a data window or channels.
/// Source: "OpenEXR File Layout", openexr.com.
std::optional<ExrExtent> readExrExtent(std::span<const std::byte> file);

/// Whether every chunk of a PNG file before its pixels lies within the file; libpng allocates the length that a chunk
/// claims, up to 2 GiB. Source: ISO/IEC 15948, section 5.3.
bool pngChunksFit(std::span<const std::byte> file);

}  // namespace steradian
