#include "steradian/core/image/image_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <memory>
#include <new>
#include <utility>

#include "steradian/core/base/atomic_file.h"
#include "steradian/core/base/diagnostics.h"
#include "steradian/core/image/image_header.h"
#include "steradian/core/image/tiff_encoder.h"

namespace steradian {
namespace {

struct FormatEntry {
  ImageFormat format;
  const char* coder;  ///< OpenImageIO's name
  std::vector<std::string_view> extensions;
};

std::span<const FormatEntry> formatTable() {
  static const std::array<FormatEntry, 6> table{{{ImageFormat::Exr, "openexr", {"exr"}},
                                                 {ImageFormat::Png, "png", {"png"}},
                                                 {ImageFormat::Jpeg, "jpeg", {"jpg", "jpeg"}},
                                                 {ImageFormat::Tiff, "tiff", {"tif", "tiff"}},
                                                 {ImageFormat::Hdr, "hdr", {"hdr"}},
                                                 {ImageFormat::Ppm, "pnm", {"ppm"}}}};
  return table;
}

const FormatEntry& entry(ImageFormat format) {
  return *std::find_if(formatTable().begin(), formatTable().end(),
                       [=](const FormatEntry& e) { return e.format == format; });
}

// ---------------------------------------------------------------- writing

bool isStoredAsHalf(std::string_view channel) {
  if (channel.starts_with("N.")) return true;
  const std::size_t dot = channel.rfind('.');
  if (channel.starts_with("StdErr.")) return false;
  const std::string_view last = dot == std::string_view::npos ? channel : channel.substr(dot + 1);
  return last == "R" || last == "G" || last == "B" || last == "A";
}

void addAttribute(OIIO::ImageSpec& spec, const std::string& attribute, const MetadataValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    spec.attribute(attribute, *text);
  } else if (const auto* integer = std::get_if<int>(&value)) {
    spec.attribute(attribute, *integer);
  } else if (const auto* number = std::get_if<float>(&value)) {
    spec.attribute(attribute, *number);
  } else if (const auto* precise = std::get_if<double>(&value)) {
    spec.attribute(attribute, OIIO::TypeDesc::DOUBLE, precise);
  } else if (const auto* vector = std::get_if<std::vector<float>>(&value); vector && !vector->empty()) {
    OIIO::TypeDesc type(OIIO::TypeDesc::FLOAT, static_cast<int>(vector->size()));
    if (vector->size() == 16) type = OIIO::TypeMatrix44;
    if (vector->size() == 9) type = OIIO::TypeMatrix33;
    if (vector->size() == 3) type = OIIO::TypeVector;
    if (vector->size() == 2) type = OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::VEC2);
    spec.attribute(attribute, type, vector->data());
  }
}

OIIO::ImageSpec exrSpec(const Image& image, const WriteOptions& options) {
  OIIO::ImageSpec spec(image.width(), image.height(), image.channelCount(), OIIO::TypeDesc::FLOAT);
  const ImageWindow& window = image.window();
  spec.x = window.x0;
  spec.y = window.y0;
  spec.full_width = window.fullWidth;
  spec.full_height = window.fullHeight;
  spec.channelnames = image.channels();
  spec.alpha_channel = image.findChannel("A").value_or(-1);
  spec.z_channel = image.findChannel("Z").value_or(-1);
  if (options.half) {
    for (const std::string& channel : image.channels()) {
      spec.channelformats.emplace_back(isStoredAsHalf(channel) ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
    }
  }
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", "");
  addAttribute(spec, "chromaticities", std::vector<float>{0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f});
  for (const auto& [key, value] : image.metadata()) addAttribute(spec, key, value);
  return spec;
}

std::array<int, 3> visibleChannels(const Image& image, ImageFormat format) {
  if (const auto rgb = image.findRgb()) return *rgb;
  if (image.channelCount() == 1) return {0, 0, 0};
  throw Error(ErrorKind::Usage, "a " + std::string(formatName(format)) +
                                    " file needs an image with the channels R, G and B, or with one channel");
}

std::vector<float> gatherRgb(const Image& image, ImageFormat format) {
  const std::array<int, 3> rgb = visibleChannels(image, format);
  const auto stride = static_cast<std::size_t>(image.channelCount());
  std::vector<float> result;
  result.reserve(image.pixelCount() * 3);
  for (std::size_t i = 0; i < image.values().size(); i += stride) {
    for (const int c : rgb) result.push_back(image.values()[i + static_cast<std::size_t>(c)]);
  }
  return result;
}

template <class Integer>
std::vector<Integer> quantise(std::span<const float> values, Quantisation how) {
  constexpr float most = static_cast<float>(std::numeric_limits<Integer>::max());
  std::vector<Integer> result(values.size());
  std::transform(values.begin(), values.end(), result.begin(), [=](float value) {
    if (std::isnan(value)) return Integer{0};
    if (how == Quantisation::Book) return static_cast<Integer>((most + 1.0f) * std::clamp(value, 0.0f, 0.999f));
    // NOLINTNEXTLINE(bugprone-incorrect-roundings): what is rounded is not negative.
    return static_cast<Integer>(most * std::clamp(value, 0.0f, 1.0f) + 0.5f);
  });
  return result;
}

Quantisation quantisationOf(const Image& image, const WriteOptions& options) {
  if (options.quantisation) return *options.quantisation;
  const auto* wanted = findMetadata<std::string>(image.metadata(), "quantisation");
  return wanted && *wanted == "book" ? Quantisation::Book : Quantisation::Round;
}

void checkOptions(ImageFormat format, const WriteOptions& options) {
  const bool deep = format == ImageFormat::Png || format == ImageFormat::Tiff;
  if (isDisplayReferred(format) && options.bits != 8 && !(options.bits == 16 && deep)) {
    throw Error(ErrorKind::Usage, "a " + std::string(formatName(format)) + " file cannot have " +
                                      std::to_string(options.bits) + " bits per channel");
  }
  if (options.jpegQuality < 1 || options.jpegQuality > 100) {
    throw Error(ErrorKind::Usage,
                "the quality of a JPEG must lie in [1, 100], not be " + std::to_string(options.jpegQuality));
  }
}

std::vector<std::byte> runEncoder(ImageFormat format, OIIO::ImageSpec spec, const OIIO::TypeDesc& type,
                                  const void* pixels) {
  const std::string file = "image." + std::string(formatName(format));
  const auto fail = [&](const std::string& reason) {
    throw Error(ErrorKind::Output, "cannot encode a " + std::string(formatName(format)) + " image of " +
                                       std::to_string(spec.width) + " x " + std::to_string(spec.height) +
                                       " pixels: " + reason);
  };
  const int longestSide = std::max(spec.width, spec.height);
  // Here libjpeg would end the process and libpng would print.
  if (format == ImageFormat::Jpeg && longestSide > 65500) fail("a side has more than 65500 pixels");
  if (format == ImageFormat::Png && longestSide > 1000000) fail("a side has more than 1000000 pixels");
  const auto output = OIIO::ImageOutput::create(entry(format).coder);
  // An error that is not fetched would be printed by OpenImageIO when the encoder is destroyed.
  if (!output) fail(OIIO::geterror());
  output->threads(1);  // the caller's threads are the only ones
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  if (!output->set_ioproxy(&memory)) fail(output->geterror() + " (the encoder cannot write to memory)");
  if (!output->open(file, spec) || !output->write_image(type, pixels) || !output->close()) fail(output->geterror());
  if (output->has_error()) fail(output->geterror());
  const auto view = std::as_bytes(std::span(bytes));
  return {view.begin(), view.end()};
}

template <class Integer>
std::vector<std::byte> encodeInteger(const Image& image, ImageFormat format, const WriteOptions& options) {
  const std::vector<Integer> rgb = quantise<Integer>(gatherRgb(image, format), quantisationOf(image, options));
  if (format == ImageFormat::Tiff) return encodeTiff(image.width(), image.height(), rgb);
  OIIO::ImageSpec spec(image.width(), image.height(), 3, OIIO::BaseTypeFromC<Integer>::value);
  if (format == ImageFormat::Jpeg) {
    spec.attribute("compression", "jpeg:" + std::to_string(options.jpegQuality));
    spec.attribute("jpeg:subsampling", "4:4:4");  // coloured edges and noise stay where they are
  }
  if (format == ImageFormat::Png) spec.attribute("oiio:ColorSpace", "sRGB");
  return runEncoder(format, spec, spec.format, rgb.data());
}

std::vector<std::byte> encodeAny(const Image& image, ImageFormat format, const WriteOptions& options) {
  if (format == ImageFormat::Exr) {
    return runEncoder(format, exrSpec(image, options), OIIO::TypeDesc::FLOAT, image.values().data());
  }
  if (format == ImageFormat::Hdr) {
    const OIIO::ImageSpec spec(image.width(), image.height(), 3, OIIO::TypeDesc::FLOAT);
    return runEncoder(format, spec, spec.format, gatherRgb(image, format).data());
  }
  return options.bits == 16 ? encodeInteger<std::uint16_t>(image, format, options)
                            : encodeInteger<std::uint8_t>(image, format, options);
}

// ---------------------------------------------------------------- reading

[[noreturn]] void failToRead(const std::string& file, const std::string& reason) {
  throw Error(ErrorKind::Scene, Diagnostic{Severity::Error, {file, 0, 0, 0}, "cannot read the image: " + reason, {}});
}

bool isPnm(std::string_view start) {
  return start.size() > 2 && start[0] == 'P' &&
         ((start[1] >= '1' && start[1] <= '6') || start[1] == 'F' || start[1] == 'f') &&
         std::string_view(" \t\r\n#").find(start[2]) != std::string_view::npos;
}

/// OpenImageIO's name of the decoder, or null.
const char* decoderOf(std::string_view data) {
  using namespace std::string_view_literals;
  if (data.starts_with("\x76\x2f\x31\x01"sv)) return "openexr";
  if (data.starts_with("\x89PNG\r\n\x1a\n"sv)) return "png";
  if (data.starts_with("\xff\xd8\xff"sv)) return "jpeg";
  for (const auto magic : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}) {
    if (data.starts_with(magic)) return "tiff";
  }
  if (data.starts_with("#?RADIANCE"sv) || data.starts_with("#?RGBE"sv)) return "hdr";
  if (isPnm(data)) return "pnm";
  if (data.starts_with("BM"sv)) return "bmp";
  if (data.ends_with("TRUEVISION-XFILE.\0"sv)) return "targa";
  return nullptr;
}

void checkExtent(const std::string& file, std::uint64_t width, std::uint64_t height, std::uint64_t values,
                 std::size_t fileBytes, const ImageLimits& limits) {
  constexpr std::uint64_t alwaysAllowed = std::uint64_t{64} << 20;
  const std::string size = "it claims " + std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width == 0 || height == 0 || values == 0) failToRead(file, "it has no pixels");
  const auto side = static_cast<std::uint64_t>(limits.maxSide);
  if (width > side || height > side) failToRead(file, size + ", more than " + std::to_string(side) + " on a side");
  if (values > limits.maxBytes / sizeof(float)) {
    failToRead(file, size + ", which need more than " + std::to_string(limits.maxBytes >> 20) + " MiB");
  }
  if (values * sizeof(float) > std::max(alwaysAllowed, fileBytes * limits.maxExpansion)) {
    failToRead(file, size + ", but has only " + std::to_string(fileBytes) + " bytes");
  }
}

void checkSpec(const std::string& file, const OIIO::ImageSpec& spec, std::size_t fileBytes, const ImageLimits& limits) {
  if (spec.deep) failToRead(file, "deep images are not supported");
  if (spec.depth > 1) failToRead(file, "images with more than two dimensions are not supported");
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) failToRead(file, "it has no pixels");
  const auto width = static_cast<std::uint64_t>(spec.width), height = static_cast<std::uint64_t>(spec.height);
  // Whole tiles are allocated even for a small image.
  const auto tileWidth = static_cast<std::uint64_t>(std::max(spec.tile_width, spec.width));
  const auto tileHeight = static_cast<std::uint64_t>(std::max(spec.tile_height, spec.height));
  const auto channels = static_cast<std::uint64_t>(spec.nchannels);
  // Two factors below 2^31; then a third, which cannot overflow once the product of the two has passed.
  checkExtent(file, width, height, tileWidth * tileHeight, fileBytes, limits);
  checkExtent(file, width, height, tileWidth * tileHeight * channels, fileBytes, limits);
}

std::string encodingOf(const OIIO::ImageSpec& spec, std::string_view decoder) {
  const std::string space = spec.get_string_attribute("oiio:ColorSpace");
  const bool linear = decoder == "openexr" || decoder == "hdr" || spec.format.is_floating_point() ||
                      space.starts_with("lin") || space.starts_with("Lin") || space == "scene_linear";
  return linear ? "linear" : "srgb";
}

std::optional<MetadataValue> valueOf(const OIIO::ParamValue& attribute) {
  const OIIO::TypeDesc type = attribute.type();
  if (type == OIIO::TypeString) return attribute.get_string();
  if (type == OIIO::TypeInt) return attribute.get_int();
  if (type == OIIO::TypeFloat) return attribute.get_float();
  if (type == OIIO::TypeDesc(OIIO::TypeDesc::DOUBLE)) return *static_cast<const double*>(attribute.data());
  if (type.basetype != OIIO::TypeDesc::FLOAT) return std::nullopt;
  const auto* values = static_cast<const float*>(attribute.data());
  return std::vector<float>(values, values + type.basevalues());
}

/// OpenImageIO's name of a standard OpenEXR attribute, and OpenEXR's.
std::string exrName(const std::string& attribute) {
  if (attribute == "worldtocamera") return "worldToCamera";
  if (attribute == "worldtoscreen") return "worldToNDC";
  return attribute;
}

Metadata metadataOf(const OIIO::ImageSpec& spec) {
  Metadata result;
  for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
    const std::string key = attribute.name().string();
    const bool internal = key.starts_with("oiio:") || key.starts_with("openexr:") || key == "compression";
    if (internal) continue;
    if (auto value = valueOf(attribute)) result.insert_or_assign(exrName(key), std::move(*value));
  }
  return result;
}

Image runDecoder(std::span<const std::byte> bytes, const std::string& file, const char* decoder,
                 const ImageLimits& limits) {
  const auto input = OIIO::ImageInput::create(decoder);
  if (!input) failToRead(file, OIIO::geterror());
  const auto fail = [&] { failToRead(file, input->geterror()); };
  input->threads(1);
  OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
  OIIO::ImageSpec config, spec;
  config.attribute("oiio:UnassociatedAlpha", 1);  // as stored, not multiplied in with the precision of 8 bits
  if (!input->set_ioproxy(&memory)) fail();
  if (!input->open(file, spec, config)) fail();
  checkSpec(file, spec, bytes.size(), limits);
  const ImageWindow window{spec.x - spec.full_x, spec.y - spec.full_y, spec.full_width, spec.full_height};
  Image image(spec.width, spec.height, spec.channelnames, window);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.values().data())) fail();
  if (std::string_view(decoder) == "openexr") image.metadata() = metadataOf(spec);
  image.metadata().insert_or_assign("encoding", encodingOf(spec, decoder));
  input->close();
  if (input->has_error()) fail();
  return image;
}

std::vector<std::byte> readFile(const std::filesystem::path& path, std::uint64_t maxBytes) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (error) failToRead(path.string(), error.message());
  if (std::filesystem::is_directory(status)) failToRead(path.string(), "it is a directory");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) failToRead(path.string(), std::generic_category().message(errno));
  // In pieces: devices and pipes have no size, and that of a file may change meanwhile.
  constexpr std::size_t piece = std::size_t{1} << 20;
  std::vector<std::byte> data;
  while (stream) {
    const std::size_t before = data.size();
    if (before > maxBytes) failToRead(path.string(), "it is larger than " + std::to_string(maxBytes) + " bytes");
    data.resize(before + piece);
    stream.read(reinterpret_cast<char*>(data.data() + before), static_cast<std::streamsize>(piece));
    data.resize(before + static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) failToRead(path.string(), "reading failed");
  return data;
}

}  // namespace

bool isDisplayReferred(ImageFormat format) { return format != ImageFormat::Exr && format != ImageFormat::Hdr; }

std::string_view formatName(ImageFormat format) { return entry(format).extensions.front(); }

ImageFormat imageFormatOf(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  std::vector<std::string_view> known;
  for (const FormatEntry& e : formatTable()) {
    if (std::find(e.extensions.begin(), e.extensions.end(), extension) != e.extensions.end()) return e.format;
    known.insert(known.end(), e.extensions.begin(), e.extensions.end());
  }
  std::string list;
  for (const std::string_view k : known) list += " ." + std::string(k);
  const std::string problem =
      extension.empty() ? "has no extension" : "has the unknown extension \"" + extension + "\"";
  throw Error(ErrorKind::Usage, Diagnostic{Severity::Error,
                                           {},
                                           "the image file \"" + path.string() + "\" " + problem + "; known are" + list,
                                           didYouMean(extension, known)});
}

std::vector<std::byte> encodeImage(const Image& image, ImageFormat format, const WriteOptions& options) {
  checkOptions(format, options);
  try {
    return encodeAny(image, format, options);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::Memory, "not enough memory to encode a " + std::string(formatName(format)) + " image");
  }
}

void writeImage(const Image& image, const std::filesystem::path& path, const WriteOptions& options) {
  const ImageFormat format = options.format ? *options.format : imageFormatOf(path);
  writeFileAtomically(path, encodeImage(image, format, options));
}

Image readImage(const std::filesystem::path& path, const ImageLimits& limits) {
  try {
    return decodeImage(readFile(path, limits.maxFileBytes), path.string(), limits);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::Memory, "not enough memory to read \"" + path.string() + "\"");
  }
}

Image decodeImage(std::span<const std::byte> file, const std::string& name, const ImageLimits& limits) {
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  if (text.empty()) failToRead(name, "it is empty");
  const char* decoder = decoderOf(text);
  if (!decoder) failToRead(name, "its first bytes are those of no known image format");
  if (std::string_view(decoder) == "openexr") {
    const auto extent = readExrExtent(file);
    if (!extent) failToRead(name, "its header is damaged");
    checkExtent(name, extent->width, extent->height, extent->values, file.size(), limits);
  }
  if (std::string_view(decoder) == "png" && !pngChunksFit(file)) failToRead(name, "it is damaged");
  try {
    return runDecoder(file, name, decoder, limits);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::Memory, "not enough memory to read \"" + name + "\"");
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::Usage) throw;
    failToRead(name, error.diagnostics().front().message);  // two channels of one name, for instance
  }
}

}  // namespace steradian
