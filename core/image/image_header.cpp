#include "steradian/core/image/image_header.h"

#include <algorithm>
#include <string_view>

namespace steradian {
namespace {

constexpr std::uint64_t maxValues = std::uint64_t{1} << 53;
constexpr std::uint32_t multiPartFlag = 0x1000;

/// Reads values from the front of the file; after a failure everything it returns is zero or empty.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> data) : data_(data) {}

  bool failed() const { return failed_; }
  bool empty() const { return data_.empty(); }

  std::span<const std::byte> bytes(std::uint64_t count) {
    if (failed_ || count > data_.size()) {
      failed_ = true;
      return {};
    }
    const auto result = data_.first(static_cast<std::size_t>(count));
    data_ = data_.subspan(static_cast<std::size_t>(count));
    return result;
  }

  std::uint32_t word() {
    std::uint32_t value = 0;
    int shift = 0;
    for (const std::byte b : bytes(4)) {
      value |= std::to_integer<std::uint32_t>(b) << shift;
      shift += 8;
    }
    return value;
  }

  std::string_view text() {
    const auto end = std::find(data_.begin(), data_.end(), std::byte{0});
    if (failed_ || end == data_.end()) {
      failed_ = true;
      return {};
    }
    const auto size = static_cast<std::size_t>(end - data_.begin());
    const std::string_view result(reinterpret_cast<const char*>(data_.data()), size);
    data_ = data_.subspan(size + 1);
    return result;
  }

 private:
  std::span<const std::byte> data_;
  bool failed_ = false;
};

struct Part {
  std::uint64_t width = 0;
  std::uint64_t height = 0;
  std::uint64_t channels = 0;
  std::uint64_t tileWidth = 1;
  std::uint64_t tileHeight = 1;
};

std::uint64_t side(std::uint32_t low, std::uint32_t high) {
  const auto first = static_cast<std::int32_t>(low), last = static_cast<std::int32_t>(high);
  return last < first ? 0 : static_cast<std::uint64_t>(std::int64_t{last} - first + 1);
}

std::uint64_t countChannels(std::span<const std::byte> list) {
  Reader reader(list);
  std::uint64_t count = 0;
  while (!reader.text().empty()) {
    reader.bytes(16);  // pixel type, linearity, sampling
    ++count;
  }
  return reader.failed() ? 0 : count;
}

/// One header: attributes (name, type, size, value) up to an empty name.
std::optional<Part> readPart(Reader& reader, std::string_view firstName) {
  Part part;
  for (std::string_view name = firstName; !name.empty(); name = reader.text()) {
    reader.text();  // the type
    const auto value = reader.bytes(reader.word());
    if (name == "channels") part.channels = countChannels(value);
    if (name == "dataWindow") {
      Reader box(value);
      const std::uint32_t x0 = box.word(), y0 = box.word(), x1 = box.word(), y1 = box.word();
      part.width = side(x0, x1);
      part.height = side(y0, y1);
    }
    if (name == "tiles") {
      Reader tile(value);
      part.tileWidth = tile.word();
      part.tileHeight = tile.word();
    }
  }
  if (reader.failed() || part.width == 0 || part.height == 0 || part.channels == 0) return std::nullopt;
  return part;
}

}  // namespace

std::optional<ExrExtent> readExrExtent(std::span<const std::byte> file) {
  Reader reader(file);
  reader.word();  // the magic number
  const bool multiPart = (reader.word() & multiPartFlag) != 0;
  ExrExtent extent;
  do {
    const std::string_view name = reader.text();
    if (name.empty() && !reader.failed() && extent.values > 0) break;  // the end of the list of headers
    const auto part = readPart(reader, name);
    if (!part) return std::nullopt;
    extent.width = std::max(extent.width, part->width);
    extent.height = std::max(extent.height, part->height);
    // Whole tiles are allocated even for a small image.
    const std::uint64_t width = std::max(part->width, part->tileWidth);
    const std::uint64_t height = std::max(part->height, part->tileHeight);
    const bool tooMany = width > maxValues / height / part->channels;
    extent.values = std::min(maxValues, extent.values + (tooMany ? maxValues : width * height * part->channels));
  } while (multiPart);
  return extent;
}

bool pngChunksFit(std::span<const std::byte> file) {
  Reader reader(file);
  reader.bytes(8);  // the signature
  while (!reader.failed()) {
    std::uint32_t length = 0;
    for (const std::byte b : reader.bytes(4)) length = length << 8 | std::to_integer<std::uint32_t>(b);
    const auto type = reader.bytes(4);
    if (reader.failed()) break;
    if (std::string_view(reinterpret_cast<const char*>(type.data()), type.size()) == "IDAT") return true;
    reader.bytes(std::uint64_t{length} + 4);  // and the check sum
  }
  return false;
}

}  // namespace steradian
