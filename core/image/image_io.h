#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "steradian/core/image/image.h"

namespace STERADIAN_API steradian {

/// Exr and Hdr are scene-linear: they hold the pixels of a render as they are, without any display transform.
/// Png, Jpeg, Tiff and Ppm are display-referred: they hold display values, so an image goes through `Display::apply`
/// first. TIFF counts as such (8 or 16 bits) because programs show an integer TIFF as it is, and for scene-linear
/// pixels there is EXR.
enum class ImageFormat { Exr, Png, Jpeg, Tiff, Hdr, Ppm };

bool isDisplayReferred(ImageFormat format);

/// "exr", "png", "jpg", "tif", "hdr", "ppm".
std::string_view formatName(ImageFormat format);

/// The format that the extension of `path` (.exr .png .jpg .jpeg .tif .tiff .hdr .ppm, upper or lower case) names.
/// Throws `Error` (kind Usage) with the supported extensions for any other.
ImageFormat imageFormatOf(const std::filesystem::path& path);

/// How display values become integers.
enum class Quantisation {
  Round,  ///< the nearest of the 2^bits values
  Book    ///< int(2^bits * clamp(v, 0, 0.999)), as in "Ray Tracing in One Weekend"
};

struct WriteOptions {
  /// By default the extension decides. Needed for "-" (standard output).
  std::optional<ImageFormat> format{};
  /// EXR: store colours ("R", "G", "B", "A", also behind a dot: "Albedo.R") and normals ("N.X", ...) as half. Depth,
  /// standard errors and everything else stay float.
  bool half = false;
  /// PNG, TIFF: 8 or 16 bits per channel. JPEG and PPM have 8.
  int bits = 8;
  int jpegQuality = 95;
  /// By default Book if the image's metadata says "quantisation" = "book", else Round.
  std::optional<Quantisation> quantisation{};
};

/// The bytes of an image file.
///
/// EXR: all channels and metadata, ZIP-compressed scanlines, the window of a cropped image as data window,
/// chromaticities of Rec.709 unless the metadata has others. HDR: R G B. The other formats: R G B quantised, without
/// alpha: colours are premultiplied, so this is the picture over black; not a number becomes 0. Formats other than
/// EXR take an image with a single channel as grey, and drop window and metadata.
///
/// Throws `Error`: kind Usage if the image has neither R, G, B nor a single channel or if an option is out of range,
/// kind Output if the format cannot hold it (a JPEG wider than 65500 pixels, say).
std::vector<std::byte> encodeImage(const Image& image, ImageFormat format, const WriteOptions& options = {});

/// Encodes in memory, then writes with `writeFileAtomically`, whose promises and errors are also those of this
/// function: encoders that write files themselves may hang or stop silently when the disk is full.
void writeImage(const Image& image, const std::filesystem::path& path, const WriteOptions& options = {});

/// What an image file may ask for. Checked before anything is allocated.
struct ImageLimits {
  int maxSide = 1 << 16;
  /// Of the decoded image (float32).
  std::uint64_t maxBytes = std::uint64_t{8} << 30;
  std::uint64_t maxFileBytes = std::uint64_t{4} << 30;
  /// A file whose decoded image is larger than 64 MiB and than this many times the file is taken for an attack.
  std::uint64_t maxExpansion = 1 << 14;
};

/// Reads EXR (flat, first part), PNG, JPEG, TIFF, HDR, PNM and PFM, BMP, and TGA with a footer. The first bytes decide,
/// not the name. Pixels are what the file stores: integers scaled to [0, 1], alpha not multiplied in, no transfer
/// curve removed; metadata "encoding" is "srgb" or "linear" (`linearise` in display.h removes the curve).
/// The data window of an EXR becomes the image's window, relative to the display window.
///
/// Throws `Error`: kind Scene, with the path, for a file that cannot be read, is no image, is damaged, or exceeds the
/// limits; kind Memory. libpng, as OpenImageIO 2.4 drives it, also prints a line for a damaged PNG.
Image readImage(const std::filesystem::path& path, const ImageLimits& limits = {});

/// The same from memory; `name` is for messages.
Image decodeImage(std::span<const std::byte> file, const std::string& name, const ImageLimits& limits = {});

}  // namespace steradian
