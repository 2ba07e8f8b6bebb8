#pragma once
/// Renders the pictures of a book and writes its page.
#include <filesystem>

#include "steradian/apps/books/rendering.h"

namespace steradian::books {

/// Samples of the pictures shown, and how many of them were not finite.
struct Tally {
  std::uint64_t samples = 0, nonFinite = 0;

  void add(const Rendering& rendering) {
    samples += rendering.statistics.samples;
    nonFinite += rendering.statistics.nonFiniteSamples;
  }
};

/// Into `folder`, which must exist: the pictures as PNG and the page. Says on standard output what is done. Throws
/// Error.
void writeRestOfYourLife(const std::filesystem::path& folder, const Effort& effort, Tally& tally);
void writeInOneWeekend(const std::filesystem::path& folder, const Effort& effort, Tally& tally);

/// The text as a file.
void writePage(const std::filesystem::path& path, const std::string& html);

}  // namespace steradian::books
