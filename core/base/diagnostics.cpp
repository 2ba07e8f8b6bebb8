#include "steradian/core/base/diagnostics.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace steradian {
namespace {

constexpr std::size_t excerptWidth = 100;
constexpr std::size_t longestComparedWord = 64;

bool isContinuationByte(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::optional<std::string_view> findLine(std::string_view text, int line) {
  for (int current = 1; !text.empty(); ++current) {
    const std::size_t end = text.find('\n');
    if (current == line) {
      std::string_view found = text.substr(0, end);
      if (found.ends_with('\r')) found.remove_suffix(1);
      return found;
    }
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  return std::nullopt;
}

/// Tabs become one blank, so that the caret below is in the right column for any tab stops of the terminal.
std::string printable(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c == '\t')
      c = ' ';
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
      c = '?';
  }
  return result;
}

std::size_t countCharacters(std::string_view text) {
  return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), isContinuationByte));
}

std::string excerpt(const SourceRange& where, std::string_view line) {
  const std::size_t column = std::min(static_cast<std::size_t>(std::max(where.column, 1)) - 1, line.size());
  std::size_t begin = column > excerptWidth / 2 && line.size() > excerptWidth ? column - excerptWidth / 2 : 0;
  while (begin < column && isContinuationByte(line[begin])) ++begin;
  std::size_t end = std::min(line.size(), begin + excerptWidth);
  while (end < line.size() && isContinuationByte(line[end])) ++end;

  const std::string number = std::to_string(where.line);
  const std::string gutter(number.size() < 5 ? 5 - number.size() : 0, ' ');
  std::string result = gutter + number + " | " + printable(line.substr(begin, end - begin));
  if (where.column <= 0) return result;
  const std::size_t length = std::min(static_cast<std::size_t>(std::max(where.length, 1)), end - column);
  const std::size_t marks = std::max<std::size_t>(countCharacters(line.substr(column, length)), 1);
  result += "\n" + std::string(gutter.size() + number.size(), ' ') + " | ";
  result += std::string(countCharacters(line.substr(begin, column - begin)), ' ');
  return result + "^" + std::string(marks - 1, '~');
}

std::string_view name(Severity severity) { return severity == Severity::Error ? "error" : "warning"; }

}  // namespace

std::string format(const Diagnostic& diagnostic, std::string_view sourceText) {
  const SourceRange& where = diagnostic.where;
  std::string text;
  if (!where.file.empty()) {
    text += printable(where.file) + ":";
    if (where.line > 0) text += std::to_string(where.line) + ":";
    if (where.line > 0 && where.column > 0) text += std::to_string(where.column) + ":";
    text += " ";
  }
  text += std::string(name(diagnostic.severity)) + ": " + printable(diagnostic.message);
  if (!diagnostic.suggestion.empty()) text += " (did you mean \"" + printable(diagnostic.suggestion) + "\"?)";
  if (where.line > 0) {
    if (const auto line = findLine(sourceText, where.line)) text += "\n" + excerpt(where, *line);
  }
  return text;
}

Error::Error(ErrorKind kind, const std::string& message) : Error(kind, Diagnostic{Severity::Error, {}, message, {}}) {}

Error::Error(ErrorKind kind, const Diagnostic& diagnostic, std::string_view sourceText)
    : std::runtime_error(steradian::format(diagnostic, sourceText)),
      kind_(kind),
      diagnostics_(std::make_shared<const std::vector<Diagnostic>>(1, diagnostic)) {}

Error::Error(ErrorKind kind, std::vector<Diagnostic> diagnostics, const std::string& text)
    : std::runtime_error(text),
      kind_(kind),
      diagnostics_(std::make_shared<const std::vector<Diagnostic>>(std::move(diagnostics))) {}

void Diagnostics::add(Diagnostic diagnostic) {
  ++(diagnostic.severity == Severity::Error ? errorCount_ : warningCount_);
  if (items_.size() < capacity) {
    items_.push_back(std::move(diagnostic));
    return;
  }
  if (diagnostic.severity == Severity::Warning) return;
  // Warnings give way to errors: the reason for a failure must be among what the user sees.
  const auto warning =
      std::find_if(items_.begin(), items_.end(), [](const Diagnostic& d) { return d.severity == Severity::Warning; });
  if (warning == items_.end()) return;
  items_.erase(warning);
  items_.push_back(std::move(diagnostic));
}

void Diagnostics::error(SourceRange where, std::string message, std::string suggestion) {
  add({Severity::Error, std::move(where), std::move(message), std::move(suggestion)});
}

void Diagnostics::warning(SourceRange where, std::string message, std::string suggestion) {
  add({Severity::Warning, std::move(where), std::move(message), std::move(suggestion)});
}

std::string Diagnostics::format(const SourceLookup& sourceOf) const {
  std::string text;
  for (const Diagnostic& item : items_) {
    if (!text.empty()) text += "\n";
    text += steradian::format(item, sourceOf ? sourceOf(item.where.file) : std::string_view{});
  }
  const std::size_t unseen = errorCount_ + warningCount_ - items_.size();
  if (unseen > 0) text += "\n... and " + std::to_string(unseen) + " more";
  return text;
}

void Diagnostics::throwIfErrors(ErrorKind kind, const SourceLookup& sourceOf) const {
  if (hasErrors()) throw Error(kind, items_, format(sourceOf));
}

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> beforeLast(b.size() + 1), last(b.size() + 1), current(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) current[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    beforeLast.swap(last);
    last.swap(current);
    current[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitution = last[j - 1] + (lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1);
      current[j] = std::min({last[j] + 1, current[j - 1] + 1, substitution});
      const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) current[j] = std::min(current[j], beforeLast[j - 2] + 1);
    }
  }
  return current[b.size()];
}

std::size_t nearness(std::string_view word, std::string_view candidate) {
  if (word.empty() || word.size() > longestComparedWord || candidate.size() > longestComparedWord) {
    return std::string_view::npos;
  }
  const std::size_t farthest = std::max<std::size_t>(word.size() / 3, 1);
  const std::size_t distance = editDistance(word, candidate);
  // A distance of the whole word would make any one-letter word near to any other.
  if (distance <= farthest && distance < std::max(word.size(), candidate.size())) return distance;
  const bool begins =
      word.size() >= 3 && candidate.size() > word.size() &&
      std::equal(word.begin(), word.end(), candidate.begin(), [](char x, char y) { return lower(x) == lower(y); });
  return begins ? farthest + 1 : std::string_view::npos;
}

}  // namespace steradian
