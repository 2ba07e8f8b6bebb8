#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

/// A stretch of text in an input file. Lines and columns count from 1, columns and length in bytes;
/// 0 means "not known" (an error of the whole file has line 0).
struct SourceRange {
  std::string file;
  int line = 0;
  int column = 0;
  int length = 0;
};

enum class Severity { Warning, Error };

/// One remark about the user's input.
struct Diagnostic {
  Severity severity = Severity::Error;
  SourceRange where;
  std::string message;     ///< one sentence, no full stop, no newline
  std::string suggestion;  ///< the word the user may have meant; empty if there is none
};

/// The remark as a compiler would print it:
///
///     box.pbrt:3:10: error: unknown material "difuse" (did you mean "diffuse"?)
///         3 | Material "difuse"
///           |          ^~~~~~~~
///
/// The excerpt appears when `sourceText`, the whole text of the file, is given and contains the line. Control
/// characters of the input are shown as '?', and long lines are cut around the column. No newline at the end.
std::string format(const Diagnostic& diagnostic, std::string_view sourceText = {});

/// Finds the text of a file by the name used in `SourceRange::file`; returns an empty view if it is not known.
using SourceLookup = std::function<std::string_view(const std::string& file)>;

/// What went wrong, as far as a caller may want to act on it (programs map it to their exit codes).
enum class ErrorKind {
  Usage,   ///< the caller asked for something that does not exist or makes no sense
  Scene,   ///< a scene or an asset is bad
  Memory,  ///< not enough memory
  Output,  ///< a result could not be written
  Other
};

/// The one exception type of the library. `what()` is the complete text for the user, one or more lines.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message);
  explicit Error(ErrorKind kind, const Diagnostic& diagnostic, std::string_view sourceText = {});
  Error(ErrorKind kind, std::vector<Diagnostic> diagnostics, const std::string& text);

  ErrorKind kind() const noexcept { return kind_; }
  /// At least one entry.
  std::span<const Diagnostic> diagnostics() const noexcept { return *diagnostics_; }

 private:
  ErrorKind kind_;
  std::shared_ptr<const std::vector<Diagnostic>> diagnostics_;  // shared: copying an exception must not throw
};

/// Collects remarks, so that a user sees all errors of a file at once.
class Diagnostics {
 public:
  /// Remarks beyond this number are counted but not kept: a hostile file must not fill the memory.
  static constexpr std::size_t capacity = 100;

  void add(Diagnostic diagnostic);
  void error(SourceRange where, std::string message, std::string suggestion = {});
  void warning(SourceRange where, std::string message, std::string suggestion = {});

  std::span<const Diagnostic> items() const noexcept { return items_; }
  std::size_t errorCount() const noexcept { return errorCount_; }
  std::size_t warningCount() const noexcept { return warningCount_; }
  bool hasErrors() const noexcept { return errorCount_ > 0; }
  bool empty() const noexcept { return errorCount_ + warningCount_ == 0; }

  /// All remarks, one after the other in the order in which they came, and how many were not kept.
  std::string format(const SourceLookup& sourceOf = {}) const;

  /// Throws an `Error` with everything collected if there is at least one error.
  void throwIfErrors(ErrorKind kind, const SourceLookup& sourceOf = {}) const;

 private:
  std::vector<Diagnostic> items_;
  std::size_t errorCount_ = 0;
  std::size_t warningCount_ = 0;
};

/// Number of insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b`, no part of the
/// text being edited twice (the restricted Damerau-Levenshtein distance). Upper and lower case count as equal.
std::size_t editDistance(std::string_view a, std::string_view b);

/// How near `candidate` is to `word`: its edit distance if that is at most a third of the word's length (at least
/// 1); one more than that if the candidate only begins with the word (of three letters or more); otherwise
/// `std::string_view::npos`.
std::size_t nearness(std::string_view word, std::string_view candidate);

/// The candidate (any range of strings) that `word` was probably meant to be; empty when none is near.
/// Of equally near ones, the first.
template <class Candidates>
std::string didYouMean(std::string_view word, const Candidates& candidates) {
  std::string best;
  std::size_t bestNearness = std::string_view::npos;
  for (const auto& candidate : candidates) {
    const std::size_t n = nearness(word, candidate);
    if (n < bestNearness) {
      bestNearness = n;
      best = std::string_view(candidate);
    }
  }
  return best;
}

inline std::string didYouMean(std::string_view word, std::initializer_list<std::string_view> candidates) {
  return didYouMean<std::initializer_list<std::string_view>>(word, candidates);
}

}  // namespace steradian
