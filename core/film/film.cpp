#include "steradian/core/film/film.h"

#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "steradian/core/base/diagnostics.h"
#include "steradian/core/film/film_kernels.h"

namespace steradian {
namespace {

std::string sizeText(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

Crop checkedCrop(const FilmSettings& s) {
  if (s.width < 1 || s.height < 1 || s.width > Image::maxSide || s.height > Image::maxSide) {
    throw Error(ErrorKind::Usage, "a picture cannot have " + sizeText(s.width, s.height) +
                                      " pixels: each side must lie in [1, " + std::to_string(Image::maxSide) + "]");
  }
  if (s.replicates < 1 || s.replicates > Film::kMaxReplicates) {
    throw Error(ErrorKind::Usage, "the number of replicates must lie in [1, " + std::to_string(Film::kMaxReplicates) +
                                      "], not " + std::to_string(s.replicates));
  }
  const Crop c = s.crop.value_or(Crop{0, s.width, 0, s.height});
  if (c.x0 < 0 || c.y0 < 0 || c.x1 > s.width || c.y1 > s.height || c.x0 >= c.x1 || c.y0 >= c.y1) {
    throw Error(ErrorKind::Usage, "the crop x " + std::to_string(c.x0) + ".." + std::to_string(c.x1) + ", y " +
                                      std::to_string(c.y0) + ".." + std::to_string(c.y1) +
                                      " is not a part of a picture of " + sizeText(s.width, s.height) + " pixels");
  }
  return c;
}

std::uint64_t physicalMemory() {
  const long pages = sysconf(_SC_PHYS_PAGES), pageSize = sysconf(_SC_PAGESIZE);
  if (pages <= 0 || pageSize <= 0) return std::numeric_limits<std::uint64_t>::max();
  return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(pageSize);
}

bool allFinite(const PixelSample& s) {
  const bool depth = isFinite(s.depth) || s.depth == kInfinity;
  return depth && isFinite(s.radiance.r) && isFinite(s.radiance.g) && isFinite(s.radiance.b) && isFinite(s.alpha) &&
         isFinite(s.albedo.r) && isFinite(s.albedo.g) && isFinite(s.albedo.b) && isFinite(s.normal.x) &&
         isFinite(s.normal.y) && isFinite(s.normal.z);
}

}  // namespace

std::uint64_t Film::bytesPerPixel(std::uint32_t replicates) {
  const std::uint64_t groups = replicates == 1 ? kSubSequences : replicates;
  return sizeof(Sums) + groups * (sizeof(FixedPoint64) + sizeof(std::uint32_t));
}

Film::Film(const FilmSettings& settings, Isa isa)
    : settings_(settings),
      crop_(checkedCrop(settings)),
      groups_(settings.replicates == 1 ? kSubSequences : settings.replicates),
      drops_(std::make_unique<Drops>()),
      kernels_(&filmKernels(isa)) {
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(crop_.x1 - crop_.x0) * static_cast<std::uint64_t>(crop_.y1 - crop_.y0);
  const std::uint64_t bytes = pixels * bytesPerPixel(settings.replicates);
  const auto fail = [&](const std::string& reason) {
    throw Error(ErrorKind::Memory, "a film of " + sizeText(crop_.x1 - crop_.x0, crop_.y1 - crop_.y0) +
                                       " pixels needs " + std::to_string(bytes >> 20) + " MiB, " + reason);
  };
  const std::uint64_t limit = settings.memoryLimit > 0 ? settings.memoryLimit : physicalMemory();
  if (bytes > limit) fail("more than the limit of " + std::to_string(limit >> 20) + " MiB");
  try {
    sums_.resize(pixels);
    groupLuminance_.resize(pixels * groups_);
    groupCount_.resize(pixels * groups_);
  } catch (const std::bad_alloc&) {
    fail("which is not there");
  } catch (const std::length_error&) {
    fail("which is not there");
  }
}

std::size_t Film::pixelIndex(int x, int y) const {
  assert(crop_.contains(x, y));
  return static_cast<std::size_t>(y - crop_.y0) * static_cast<std::size_t>(crop_.x1 - crop_.x0) +
         static_cast<std::size_t>(x - crop_.x0);
}

void Film::addSamples(int x, int y, std::uint32_t firstSample, std::span<const PixelSample> samples) {
  if (samples.empty()) return;
  assert(samples.size() <= std::numeric_limits<std::uint32_t>::max() - firstSample);
  if (settings_.replicates == 1) {
    const std::uint32_t last = firstSample + static_cast<std::uint32_t>(samples.size() - 1);
    widenSubSequences(pixelIndex(x, y), subSequenceShift(last));
  }
  while (!samples.empty()) {
    const std::size_t n = std::min(samples.size(), SampleSums::kMaxCount);
    addBatch(x, y, firstSample, samples.first(n));
    samples = samples.subspan(n);
    firstSample += static_cast<std::uint32_t>(n);
  }
}

/// Joins runs until they are at least 2^shift samples long.
void Film::widenSubSequences(std::size_t pixel, std::uint32_t shift) {
  const std::uint32_t step = shift - std::min(shift, sums_[pixel].shift);
  if (step == 0) return;
  sums_[pixel].shift = shift;
  const std::span<FixedPoint64> luminance(&groupLuminance_[pixel * groups_], groups_);
  const std::span<std::uint32_t> count(&groupCount_[pixel * groups_], groups_);
  for (std::uint32_t g = 1; g < groups_; ++g) {
    const std::uint32_t to = g >> step;
    luminance[to] += std::exchange(luminance[g], FixedPoint64());
    count[to] += std::exchange(count[g], 0u);
  }
}

void Film::addBatch(int x, int y, std::uint32_t firstSample, std::span<const PixelSample> samples) {
  SampleSums batch;
  if (!kernels_->sum(samples, batch)) [[unlikely]] {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      addExtraordinary(x, y, firstSample + static_cast<std::uint32_t>(i), samples[i]);
    }
    return;
  }
  const std::size_t pixel = pixelIndex(x, y);
  Sums& sums = sums_[pixel];
  for (std::size_t c = 0; c < 3; ++c) sums.radiance[c] += batch.radiance[c];
  sums.depth += batch.depth;
  for (std::size_t c = 0; c < kNarrow; ++c) sums.narrow[c] += batch.narrow[c];
  sums.hits += batch.hits;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::size_t group = pixel * groups_ + groupOf(pixel, firstSample + static_cast<std::uint32_t>(i));
    groupLuminance_[group] += FixedPoint64::fromSteps(batch.luminance[i]);
    ++groupCount_[group];
  }
}

/// The same sums without the fast path: for values of any size, and for those that are not finite.
void Film::addExtraordinary(int x, int y, std::uint32_t sample, const PixelSample& s) {
  if (!allFinite(s)) {
    drop({sample, x, y});
    return;
  }
  const std::size_t pixel = pixelIndex(x, y);
  const std::array<float, 10> values = valuesOf(s);
  Sums& sums = sums_[pixel];
  for (std::size_t c = 0; c < 3; ++c) sums.radiance[c] += FixedPoint128::from(values[c]);
  for (std::size_t c = 0; c < kNarrow; ++c) sums.narrow[c] += FixedPoint64::from(values[c + 3]);
  if (s.depth != kInfinity) {
    sums.depth += FixedPoint128::from(s.depth);
    ++sums.hits;
  }
  const std::size_t group = pixel * groups_ + groupOf(pixel, sample);
  groupLuminance_[group] += FixedPoint64::from(luminance(s.radiance));
  ++groupCount_[group];
}

void Film::drop(const DroppedSample& sample) {
  const std::scoped_lock lock(drops_->mutex);
  ++drops_->count;
  std::vector<DroppedSample>& first = drops_->first;
  first.insert(std::upper_bound(first.begin(), first.end(), sample), sample);
  if (first.size() > kRememberedDrops) first.pop_back();
}

void Film::merge(const Film& other) {
  if (settings_.width != other.settings_.width || settings_.height != other.settings_.height || crop_ != other.crop_ ||
      groups_ != other.groups_ || settings_.replicates != other.settings_.replicates) {
    throw Error(ErrorKind::Usage, "films of different size, crop or number of replicates cannot be merged");
  }
  if (&other == this) throw Error(ErrorKind::Usage, "a film cannot be merged with itself");
  ledger_.merge(other.ledger_);
  for (std::size_t p = 0; p < sums_.size(); ++p) {
    Sums& to = sums_[p];
    const Sums& from = other.sums_[p];
    for (std::size_t c = 0; c < 3; ++c) to.radiance[c] += from.radiance[c];
    to.depth += from.depth;
    for (std::size_t c = 0; c < kNarrow; ++c) to.narrow[c] += from.narrow[c];
    to.hits += from.hits;
    widenSubSequences(p, from.shift);
    const std::uint32_t step = to.shift - from.shift;
    for (std::uint32_t g = 0; g < groups_; ++g) {
      const std::size_t group = p * groups_ + (g >> step);
      groupLuminance_[group] += other.groupLuminance_[p * groups_ + g];
      groupCount_[group] += other.groupCount_[p * groups_ + g];
    }
  }
  const std::uint64_t count = drops_->count + other.drops_->count;
  for (const DroppedSample& d : other.drops_->first) drop(d);
  drops_->count = count;
}

std::uint32_t Film::sampleCount(int x, int y) const {
  const std::size_t first = pixelIndex(x, y) * groups_;
  std::uint32_t count = 0;
  for (std::size_t g = first; g < first + groups_; ++g) count += groupCount_[g];
  return count;
}

std::uint64_t Film::sampleCount() const {
  std::uint64_t count = 0;
  for (const std::uint32_t n : groupCount_) count += n;
  return count;
}

std::uint64_t Film::droppedCount() const { return drops_->count; }

std::vector<DroppedSample> Film::dropped() const { return drops_->first; }

Rgb Film::radiance(int x, int y) const {
  const std::uint32_t n = sampleCount(x, y);
  if (n == 0) return {};
  const auto mean = [&](FixedPoint128 sum) { return static_cast<float>(sum.toDouble() / n); };
  const Sums& s = sums_[pixelIndex(x, y)];
  return {mean(s.radiance[0]), mean(s.radiance[1]), mean(s.radiance[2])};
}

MeanEstimate Film::luminanceEstimate(int x, int y) const {
  const std::size_t first = pixelIndex(x, y) * groups_;
  std::array<double, kMaxReplicates> sums;
  bool saturated = false;
  for (std::size_t g = 0; g < groups_; ++g) {
    sums[g] = groupLuminance_[first + g].toDouble();
    saturated |= groupLuminance_[first + g].saturated();
  }
  MeanEstimate estimate = meanFromGroups({sums.data(), groups_}, {&groupCount_[first], groups_});
  if (saturated) {
    estimate.mean = luminance(radiance(x, y));
    estimate.standardError = std::numeric_limits<double>::infinity();
    estimate.degreesOfFreedom = 0;
  }
  return estimate;
}

Image Film::image(const FilmImageOptions& options) const {
  std::vector<std::string> channels{"R", "G", "B", "A"};
  if (options.features) {
    channels.insert(channels.end(), {"Albedo.R", "Albedo.G", "Albedo.B", "N.X", "N.Y", "N.Z", "Z"});
  }
  if (options.errors) channels.insert(channels.end(), {"StdErr.Y", "Samples"});
  Image image(crop_.x1 - crop_.x0, crop_.y1 - crop_.y0, channels,
              ImageWindow{crop_.x0, crop_.y0, settings_.width, settings_.height});
  for (int y = crop_.y0; y < crop_.y1; ++y) {
    for (int x = crop_.x0; x < crop_.x1; ++x) {
      const Sums& s = sums_[pixelIndex(x, y)];
      const std::uint32_t n = sampleCount(x, y);
      const double divisor = std::max(n, 1u);
      auto to = image.pixel(x - crop_.x0, y - crop_.y0).begin();
      for (const FixedPoint128& sum : s.radiance) *to++ = static_cast<float>(sum.toDouble() / divisor);
      const std::size_t narrow = options.features ? kNarrow : 1;  // alpha is the first
      for (std::size_t c = 0; c < narrow; ++c) *to++ = static_cast<float>(s.narrow[c].toDouble() / divisor);
      if (options.features) *to++ = s.hits > 0 ? static_cast<float>(s.depth.toDouble() / s.hits) : kInfinity;
      if (options.errors) {
        *to++ = static_cast<float>(luminanceEstimate(x, y).standardError);
        *to++ = static_cast<float>(n);
      }
    }
  }
  return image;
}

}  // namespace steradian
