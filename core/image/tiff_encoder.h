#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

/// A TIFF file of interleaved RGB, 8 or 16 bits per channel, rows from top to bottom, in deflated strips.
/// `samples` are width * height * 3 numbers. Ours, because OpenImageIO 2.4 writes damaged TIFFs to memory without an
/// error. Throws `Error` (kind Output) if the file would exceed the 4 GiB that the format can address, and
/// std::bad_alloc. Source: "TIFF Revision 6.0", Adobe 1992, sections 2 and 6; compression 8 of its supplement 2.
std::vector<std::byte> encodeTiff(int width, int height, std::span<const std::uint8_t> samples);
std::vector<std::byte> encodeTiff(int width, int height, std::span<const std::uint16_t> samples);

}  // namespace steradian
