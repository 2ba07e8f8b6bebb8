#include "steradian/core/colour/display.h"

#include <OpenColorIO/OpenColorIO.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include "steradian/core/base/diagnostics.h"
#include "steradian/core/colour/display_config.h"

namespace steradian {
namespace ocio = OCIO_NAMESPACE;

struct Display::Config {
  ocio::ConstConfigRcPtr config;
  bool builtIn = false;
};

namespace {

[[noreturn]] void failToLoad(const std::string& name, const std::string& reason) {
  throw Error(ErrorKind::Usage, "the colour configuration \"" + name + "\" cannot be used: " + reason);
}

/// The colour space through which a foreign configuration is entered.
constexpr const char* entryRole = "aces_interchange";

void checkConfig(const ocio::ConstConfigRcPtr& config, const std::string& name) {
  try {
    config->validate();
  } catch (const ocio::Exception& e) {
    failToLoad(name, e.what());
  }
  if (!config->hasRole(entryRole)) {
    failToLoad(name, std::string("it has no role \"") + entryRole +
                         "\", so there is no telling how its colours relate to linear Rec.709; add the role to the "
                         "configuration, or render to EXR, which needs none");
  }
  if (config->getNumDisplays() == 0) failToLoad(name, "it has no displays");
}

std::vector<std::string> allViews(const ocio::ConstConfigRcPtr& config, const std::string& display) {
  std::vector<std::string> result;
  const auto add = [&](const std::string& view) {
    if (std::find(result.begin(), result.end(), view) == result.end()) result.push_back(view);
  };
  // The active views in their order, then the configuration's inactive ones.
  for (int i = 0; i < config->getNumViews(display.c_str()); ++i) add(config->getView(display.c_str(), i));
  for (const auto type : {ocio::VIEW_DISPLAY_DEFINED, ocio::VIEW_SHARED}) {
    for (int i = 0; i < config->getNumViews(type, display.c_str()); ++i) add(config->getView(type, display.c_str(), i));
  }
  return result;
}

/// Throws unless `word` is among the candidates.
void checkName(const std::string& what, const std::string& word, const std::vector<std::string>& candidates) {
  if (std::find(candidates.begin(), candidates.end(), word) != candidates.end()) return;
  std::string list;
  for (const std::string& candidate : candidates) list += (list.empty() ? "\"" : ", \"") + candidate + "\"";
  throw Error(ErrorKind::Usage, Diagnostic{Severity::Error,
                                           {},
                                           "unknown " + what + " \"" + word + "\"; there are " + list,
                                           didYouMean(word, candidates)});
}

/// Linear Rec.709 to ACES2065-1, in transforms that every version from 2.1 has built in.
void appendRec709ToAces(ocio::GroupTransform& group) {
  const auto toAcesCg = ocio::BuiltinTransform::Create();
  toAcesCg->setStyle("UTILITY - ACES-AP1_to_LINEAR-REC709_BFD");
  toAcesCg->setDirection(ocio::TRANSFORM_DIR_INVERSE);
  group.appendTransform(toAcesCg);
  const auto toAces = ocio::BuiltinTransform::Create();
  toAces->setStyle("ACEScg_to_ACES2065-1");
  group.appendTransform(toAces);
}

ocio::ConstCPUProcessorRcPtr processorOf(const ocio::ConstConfigRcPtr& config, bool builtIn, const std::string& display,
                                         const std::string& view) {
  const auto group = ocio::GroupTransform::Create();
  const auto toDisplay = ocio::DisplayViewTransform::Create();
  toDisplay->setDisplay(display.c_str());
  toDisplay->setView(view.c_str());
  if (builtIn) {
    toDisplay->setSrc("scene_linear");
  } else {
    // A view of raw data must not be preceded by a conversion either.
    const ocio::ConstColorSpaceRcPtr space =
        config->getColorSpace(config->getDisplayViewColorSpaceName(display.c_str(), view.c_str()));
    if (!space || !space->isData()) appendRec709ToAces(*group);
    toDisplay->setSrc(entryRole);
  }
  group->appendTransform(toDisplay);
  // No fast approximations of logarithms and powers: a picture must not depend on the machine's SIMD instructions.
  return config->getProcessor(group)->getOptimizedCPUProcessor(ocio::OPTIMIZATION_LOSSLESS);
}

Image exposedRgb(const Image& image, float exposure) {
  const auto rgb = image.findRgb();
  if (!rgb) throw Error(ErrorKind::Usage, "an image needs the channels R, G and B to be displayed");
  Image result(image.width(), image.height(), {"R", "G", "B"}, image.window());
  result.metadata() = image.metadata();
  const float scale = std::exp2(exposure);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      for (int c = 0; c < 3; ++c) result.at(x, y, c) = scale * image.at(x, y, (*rgb)[static_cast<std::size_t>(c)]);
    }
  }
  return result;
}

}  // namespace

Display::Display() : Display(fromText(displayConfigText(), "built-in")) {
  config_ = std::make_shared<const Config>(Config{config_->config, true});
}

Display::Display(const std::filesystem::path& path) {
  try {
    config_ = std::make_shared<const Config>(Config{ocio::Config::CreateFromFile(path.c_str()), false});
  } catch (const ocio::Exception& e) {
    failToLoad(path.string(), e.what());
  }
  checkConfig(config_->config, path.string());
}

Display Display::fromText(const std::string& text, const std::string& name) {
  std::istringstream stream(text);
  Config config;
  try {
    config.config = ocio::Config::CreateFromStream(stream);
  } catch (const ocio::Exception& e) {
    failToLoad(name, e.what());
  }
  checkConfig(config.config, name);
  return Display(std::make_shared<const Config>(std::move(config)));
}

std::vector<std::string> Display::displays() const {
  const int count = config_->config->getNumDisplays();
  std::vector<std::string> result;
  result.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) result.emplace_back(config_->config->getDisplay(i));
  return result;
}

std::vector<std::string> Display::views(const std::string& display) const {
  const std::string name = display.empty() ? defaultDisplay() : display;
  checkName("display", name, displays());
  return allViews(config_->config, name);
}

std::string Display::defaultDisplay() const { return config_->config->getDefaultDisplay(); }

std::string Display::defaultView(const std::string& display) const {
  const std::string name = display.empty() ? defaultDisplay() : display;
  checkName("display", name, displays());
  return config_->config->getDefaultView(name.c_str());
}

DisplaySettings Display::resolve(const DisplaySettings& settings) const {
  DisplaySettings result = settings;
  if (result.display.empty()) result.display = defaultDisplay();
  if (result.view.empty()) result.view = defaultView(result.display);
  checkName("view", result.view, views(result.display));
  if (!std::isfinite(std::exp2(result.exposure))) {
    throw Error(ErrorKind::Usage, "an exposure of " + std::to_string(result.exposure) + " stops is out of range");
  }
  return result;
}

void Display::check(const DisplaySettings& settings) const { resolve(settings); }

Image Display::apply(const Image& image, const DisplaySettings& settings) const {
  const DisplaySettings chosen = resolve(settings);
  Image result = exposedRgb(image, chosen.exposure);
  try {
    const auto processor = processorOf(config_->config, config_->builtIn, chosen.display, chosen.view);
    ocio::PackedImageDesc pixels(result.values().data(), result.width(), result.height(), 3);
    processor->apply(pixels);
  } catch (const ocio::Exception& e) {
    throw Error(ErrorKind::Other, "the view \"" + chosen.view + "\" of the display \"" + chosen.display +
                                      "\" cannot be built: " + e.what());
  }
  result.metadata().insert_or_assign("encoding", std::string("display"));
  if (config_->builtIn && chosen.view == "Book")
    result.metadata().insert_or_assign("quantisation", std::string("book"));
  return result;
}

float srgbEncode(float linear) {
  const float x = std::abs(linear);
  const float code = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
  return std::copysign(code, linear);
}

float srgbDecode(float code) {
  const float x = std::abs(code);
  const float linear = x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
  return std::copysign(linear, code);
}

void linearise(Image& image) {
  const auto* encoding = findMetadata<std::string>(image.metadata(), "encoding");
  if (!encoding || *encoding != "srgb") return;
  std::vector<std::size_t> coloured;
  for (const char* name : {"R", "G", "B", "Y"}) {
    if (const auto channel = image.findChannel(name)) coloured.push_back(static_cast<std::size_t>(*channel));
  }
  const std::span<float> values = image.values();
  const auto stride = static_cast<std::size_t>(image.channelCount());
  for (std::size_t i = 0; i < values.size(); i += stride) {
    for (const std::size_t channel : coloured) values[i + channel] = srgbDecode(values[i + channel]);
  }
  image.metadata().insert_or_assign("encoding", std::string("linear"));
}

}  // namespace steradian
