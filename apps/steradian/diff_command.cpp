#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "steradian/apps/steradian/commands.h"
#include "steradian/apps/steradian/console.h"
#include "steradian/apps/steradian/exit_codes.h"
#include "steradian/core/base/atomic_file.h"
#include "steradian/core/colour/display.h"
#include "steradian/core/colour/false_colour.h"
#include "steradian/core/image/image_io.h"
#include "steradian/core/image/image_metrics.h"

namespace steradian::app {

namespace {

/// The share of pixels that may exceed the top of the map's scale, so that a few fireflies do not make it black.
constexpr double kMapOutliers = 0.01;

struct DiffArguments {
  std::string image, reference, imageError, referenceError, map;
  bool json = false, check = false;
};

struct Difference {
  double relMse = 0.0, mse = 0.0, maximum = 0.0;
  std::array<double, 3> imageMean{}, referenceMean{};
  std::optional<ZTestResult> z;
};

/// A picture and the image that carries its standard errors: a file of their own, the picture itself, or none.
struct Picture {
  Image image;
  std::optional<Image> separateErrors;

  Picture(const std::string& path, const std::string& errorPath) : image(readImage(path)) {
    linearise(image);
    if (!errorPath.empty()) separateErrors = readImage(errorPath);
  }
  const Image* errors() const {
    if (separateErrors) return &*separateErrors;
    return image.findChannel("StdErr.Y") ? &image : nullptr;
  }
  /// The largest number of pixels with correlated errors; a render says so.
  double correlatedPixels() const {
    const auto* text = findMetadata<std::string>(image.metadata(), "steradian.correlatedPixels");
    return text != nullptr ? std::max(std::atoi(text->c_str()), 1) : 1.0;
  }
  /// Standard errors of R, G and B, which relMSE can subtract. A render with StdErr.Y has none: its R, G and B are
  /// colours.
  const Image* colourErrors() const {
    const bool byColour = separateErrors && separateErrors->findRgb() && !separateErrors->findChannel("StdErr.Y");
    return byColour ? &*separateErrors : nullptr;
  }
};

Difference compare(const Picture& picture, const Picture& reference) {
  Difference d;
  d.relMse = relMSE(picture.image, reference.image, reference.colourErrors());
  d.mse = mse(picture.image, reference.image);
  d.maximum = maxAbsDifference(picture.image, reference.image);
  d.imageMean = channelMeans(picture.image);
  d.referenceMean = channelMeans(reference.image);
  if (picture.errors() != nullptr || reference.errors() != nullptr)
    d.z = zTest(picture.image, picture.errors(), reference.image, reference.errors(),
                {.correlatedPixelsA = picture.correlatedPixels(), .correlatedPixelsB = reference.correlatedPixels()});
  if (d.z && d.z->knownBlocks == 0) d.z.reset();  // no error is known for renders of one sample
  return d;
}

std::string asText(const Difference& d) {
  std::string text =
      fmt::format("relMSE        {:.6g}\nMSE           {:.6g}\nmax           {:.6g}\n", d.relMse, d.mse, d.maximum);
  for (std::size_t c = 0; c < 3; ++c) {
    text += fmt::format("mean {}        {:.6g} against {:.6g}", "RGB"[c], d.imageMean[c], d.referenceMean[c]);
    if (d.referenceMean[c] != 0.0)
      text += fmt::format(" ({:+.3f} %)", 100.0 * (d.imageMean[c] / d.referenceMean[c] - 1.0));
    text += "\n";
  }
  if (!d.z) return text + "Z-test        none: no standard errors are known\n";
  const std::string known = d.z->knownBlocks < d.z->blockCount()
                                ? fmt::format(" ({} of unknown error)", d.z->blockCount() - d.z->knownBlocks)
                                : "";
  return text +
         fmt::format("Z-test        {} blocks{}, worst z {:.2f} (limit {:.2f}), whole picture z {:.2f}, p {:.3g}: {}\n",
                     d.z->blockCount(), known, d.z->worstZ, d.z->threshold, d.z->imageZ, d.z->pValue,
                     d.z->passed ? "the noise explains the difference" : "the pictures differ");
}

std::string asJson(const Difference& d) {
  nlohmann::json out = {{"relMSE", d.relMse},
                        {"MSE", d.mse},
                        {"max", d.maximum},
                        {"mean", d.imageMean},
                        {"reference_mean", d.referenceMean}};
  if (d.z)
    out["z_test"] = {{"blocks", d.z->blockCount()}, {"known_blocks", d.z->knownBlocks}, {"worst_z", d.z->worstZ},
                     {"threshold", d.z->threshold}, {"image_z", d.z->imageZ},           {"p", d.z->pValue},
                     {"passed", d.z->passed}};
  return out.dump(1) + "\n";
}

/// The relative error as numbers (EXR, HDR) or as colours; prints the value of the brightest colour.
void writeMap(const Image& image, const Image& reference, const std::string& path) {
  Image map = relativeErrorMap(image, reference);
  for (float& squared : map.values()) squared = std::sqrt(squared);
  if (!isDisplayReferred(imageFormatOf(path))) return writeImage(map, path);
  const std::string& channel = map.channels().front();
  const ScalarRange range{0.0f, rangeOf(map, channel, kMapOutliers).high};
  writeImage(falseColour(map, channel, range), path);
  printErr(fmt::format("{}: black is no error, light yellow a relative error of {:.3g} or more\n", path, range.high));
}

int runDiff(const DiffArguments& given) {
  if (!given.map.empty()) {  // complain before work
    imageFormatOf(given.map);
    checkWritable(given.map);
  }
  const Picture picture(given.image, given.imageError), reference(given.reference, given.referenceError);
  const Difference d = compare(picture, reference);
  printOut(given.json ? asJson(d) : asText(d));
  if (!given.map.empty()) writeMap(picture.image, reference.image, given.map);
  if (!given.check) return kExitSuccess;
  if (!d.z)
    throw Error(ErrorKind::Usage,
                "--check needs known standard errors: a channel StdErr.Y of two samples or more, or --image-error");
  return d.z->passed ? kExitSuccess : kExitOther;
}

}  // namespace

void addDiffCommand(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("diff", "Compare an image with a reference");
  auto given = std::make_shared<DiffArguments>();
  command->add_option("image", given->image, "the image")->required()->type_name("FILE");
  command->add_option("reference", given->reference, "what it should be")->required()->type_name("FILE");
  command
      ->add_option("--image-error", given->imageError,
                   "the image's standard errors (default: its own\nchannel StdErr.Y)")
      ->type_name("FILE");
  command
      ->add_option("--reference-error", given->referenceError,
                   "the reference's standard errors; by colour, they\nare subtracted from relMSE")
      ->type_name("FILE");
  command
      ->add_option("--map", given->map,
                   "write the relative error |x-r|/sqrt(r^2+0.01):\nas a heat map, or as numbers (.exr, .hdr)")
      ->type_name("FILE");
  command->add_flag("--json", given->json, "print JSON");
  command->add_flag("--check", given->check, "exit with 1 if the Z-test finds a difference");
  command->callback([&run, given] {
    run = [given](Arguments& arguments) {
      arguments.throwIfProblems();
      return runDiff(*given);
    };
  });
}

}  // namespace steradian::app
