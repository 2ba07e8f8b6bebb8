#include "steradian/core/image/tiff_encoder.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>

#include "steradian/core/base/diagnostics.h"

namespace steradian {
namespace {

constexpr std::uint16_t shortType = 3;
constexpr std::uint16_t longType = 4;
constexpr std::uint16_t rationalType = 5;

/// Little-endian integers at the end of a file.
class Writer {
 public:
  explicit Writer(std::vector<std::byte>& file) : file_(file) {}

  std::uint32_t position() const { return static_cast<std::uint32_t>(file_.size()); }
  void half(std::uint16_t value) { put(value, 2); }
  void word(std::uint32_t value) { put(value, 4); }

 private:
  void put(std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) file_.push_back(static_cast<std::byte>(value >> (8 * i) & 0xFFu));
  }
  std::vector<std::byte>& file_;
};

struct Field {
  std::uint16_t tag;
  std::uint16_t type;
  std::vector<std::uint32_t> values;
};

/// Writes the values that do not fit into their directory entries, then the directory; returns where that begins.
std::uint32_t writeDirectory(Writer& out, const std::vector<Field>& fields) {
  std::vector<std::uint32_t> places;
  for (const Field& field : fields) {
    const std::size_t bytes = field.values.size() * (field.type == shortType ? 2 : 4);
    places.push_back(out.position());
    if (bytes <= 4) continue;
    for (const std::uint32_t value : field.values) {
      field.type == shortType ? out.half(static_cast<std::uint16_t>(value)) : out.word(value);
    }
    if (bytes % 4 != 0) out.half(0);
  }
  const std::uint32_t begin = out.position();
  out.half(static_cast<std::uint16_t>(fields.size()));
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const Field& field = fields[i];
    const bool inside = field.values.size() * (field.type == shortType ? 2 : 4) <= 4;
    out.half(field.tag);
    out.half(field.type);
    out.word(static_cast<std::uint32_t>(field.values.size() / (field.type == rationalType ? 2 : 1)));
    out.word(inside ? field.values.front() : places[i]);
  }
  out.word(0);  // no further directory
  return begin;
}

void checkSize(std::size_t bytes) {
  constexpr std::size_t roomForDirectory = std::size_t{1} << 24;
  if (bytes > std::numeric_limits<std::uint32_t>::max() - roomForDirectory) {
    throw Error(ErrorKind::Output, "the image is too large for a TIFF file, which ends at 4 GiB");
  }
}

void appendDeflated(std::vector<std::byte>& file, std::span<const std::uint8_t> strip) {
  constexpr int level = 6;
  uLongf size = compressBound(static_cast<uLong>(strip.size()));
  const std::size_t begin = file.size();
  file.resize(begin + size);
  auto* target = reinterpret_cast<Bytef*>(file.data() + begin);
  if (compress2(target, &size, strip.data(), static_cast<uLong>(strip.size()), level) != Z_OK) throw std::bad_alloc();
  file.resize(begin + size + size % 2);  // the next strip or table begins at an even place
}

/// `bytes` is the pixel data, little-endian.
std::vector<std::byte> encode(int width, int height, std::span<const std::uint8_t> bytes, std::uint32_t bits) {
  const std::size_t rowBytes = static_cast<std::size_t>(width) * 3 * (bits / 8);
  const std::size_t rowsPerStrip =
      std::clamp<std::size_t>((std::size_t{1} << 18) / rowBytes, 1, static_cast<std::size_t>(height));
  std::vector<std::byte> file;
  Writer out(file);
  out.half(0x4949);  // "II": little-endian
  out.half(42);
  out.word(0);  // the place of the directory, known at the end

  std::vector<std::uint32_t> offsets, sizes;
  for (std::size_t i = 0; i < bytes.size(); i += rowsPerStrip * rowBytes) {
    offsets.push_back(out.position());
    appendDeflated(file, bytes.subspan(i, std::min(rowsPerStrip * rowBytes, bytes.size() - i)));
    checkSize(file.size());
    sizes.push_back(out.position() - offsets.back());
  }
  const std::uint32_t directory = writeDirectory(out, {{256, longType, {static_cast<std::uint32_t>(width)}},
                                                       {257, longType, {static_cast<std::uint32_t>(height)}},
                                                       {258, shortType, {bits, bits, bits}},
                                                       {259, shortType, {8}},  // deflate
                                                       {262, shortType, {2}},  // RGB
                                                       {273, longType, offsets},
                                                       {277, shortType, {3}},
                                                       {278, longType, {static_cast<std::uint32_t>(rowsPerStrip)}},
                                                       {279, longType, sizes},
                                                       {282, rationalType, {1, 1}},  // square pixels
                                                       {283, rationalType, {1, 1}},
                                                       {284, shortType, {1}},    // interleaved
                                                       {296, shortType, {1}}});  // of no absolute size
  for (std::size_t i = 0; i < 4; ++i) file[4 + i] = static_cast<std::byte>(directory >> (8 * i) & 0xFFu);
  return file;
}

}  // namespace

std::vector<std::byte> encodeTiff(int width, int height, std::span<const std::uint8_t> samples) {
  return encode(width, height, samples, 8);
}

std::vector<std::byte> encodeTiff(int width, int height, std::span<const std::uint16_t> samples) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(samples.size() * 2);
  for (const std::uint16_t sample : samples) {
    bytes.push_back(static_cast<std::uint8_t>(sample & 0xFFu));
    bytes.push_back(static_cast<std::uint8_t>(sample >> 8));
  }
  return encode(width, height, bytes, 16);
}

}  // namespace steradian
