#pragma once
/// The ledger of a film: which samples are in its sums. Two films merge only if no sample is in both.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

/// The samples first, ..., end - 1 of every pixel, drawn with `seed`.
struct SampleRange {
  std::uint32_t seed = 0;
  std::uint32_t first = 0, end = 0;
  bool complete = true;  ///< false: a pass that was stopped; some pixels have some of these samples

  bool operator==(const SampleRange&) const = default;
};

class SampleLedger {
 public:
  /// Enters a range that is not empty. Throws `Error` (Usage) if a sample of it is in the ledger already.
  void add(const SampleRange& range);
  /// Enters all ranges of `other`, or, if that throws, none.
  void merge(const SampleLedger& other);

  /// By seed, then by sample; neighbours joined.
  std::span<const SampleRange> ranges() const { return ranges_; }
  /// Samples that every pixel has, over all seeds.
  std::uint64_t completeCount() const;
  /// As written to files: "seed:first-last" of each range, separated by blanks, a stopped pass with a tilde before it:
  /// "0:0-63 ~0:64-79".
  std::string text() const;
  bool operator==(const SampleLedger&) const = default;

 private:
  std::vector<SampleRange> ranges_;
};

}  // namespace steradian
