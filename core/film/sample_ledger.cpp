#include "steradian/core/film/sample_ledger.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "steradian/core/base/diagnostics.h"

namespace steradian {
namespace {

std::string textOf(const SampleRange& r) {
  return (r.complete ? "" : "~") + std::to_string(r.seed) + ":" + std::to_string(r.first) + "-" +
         std::to_string(r.end - 1);
}

}  // namespace

void SampleLedger::add(const SampleRange& range) {
  if (range.first >= range.end) {
    throw Error(ErrorKind::Usage, "a range of samples ends (" + std::to_string(range.end) + ") before it begins (" +
                                      std::to_string(range.first) + ")");
  }
  for (const SampleRange& r : ranges_) {
    if (r.seed == range.seed && r.first < range.end && range.first < r.end) {
      throw Error(ErrorKind::Usage, "the samples " + textOf(range) + " (seed:first-last) overlap the samples " +
                                        textOf(r) + " that are there already");
    }
  }
  const auto before = [](const SampleRange& a, const SampleRange& b) {
    return std::tie(a.seed, a.first) < std::tie(b.seed, b.first);
  };
  ranges_.insert(std::upper_bound(ranges_.begin(), ranges_.end(), range, before), range);

  std::vector<SampleRange> joined;
  for (const SampleRange& r : ranges_) {
    if (!joined.empty() && joined.back().seed == r.seed && joined.back().end == r.first && joined.back().complete &&
        r.complete) {
      joined.back().end = r.end;
    } else {
      joined.push_back(r);
    }
  }
  ranges_ = std::move(joined);
}

void SampleLedger::merge(const SampleLedger& other) {
  SampleLedger merged = *this;
  for (const SampleRange& r : other.ranges_) merged.add(r);
  *this = std::move(merged);
}

std::uint64_t SampleLedger::completeCount() const {
  std::uint64_t count = 0;
  for (const SampleRange& r : ranges_) count += r.complete ? r.end - r.first : 0u;
  return count;
}

std::string SampleLedger::text() const {
  std::string text;
  for (const SampleRange& r : ranges_) text += (text.empty() ? "" : " ") + textOf(r);
  return text;
}

}  // namespace steradian
