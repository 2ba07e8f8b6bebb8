#include "steradian/integrators/integrator_spec.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace steradian {
namespace {

/// The pieces between separators; an empty text is one empty piece.
std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> pieces;
  for (;;) {
    const std::size_t end = text.find(separator);
    pieces.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return pieces;
    text.remove_prefix(end + 1);
  }
}

template <class T>
std::optional<T> numberIn(std::string_view text, T low, T high) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= low && value <= high)) return std::nullopt;
  return value;
}

}  // namespace

IntegratorSpec::IntegratorSpec(std::string_view text) {
  const std::vector<std::string> pieces = split(text, ':');
  name_ = pieces.front();
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const std::size_t equals = pieces[i].find('=');
    if (equals == std::string::npos || equals == 0) {
      wrong(fmt::format("\"{}\" is not of the form key=value", pieces[i]));
      continue;
    }
    const std::string key = pieces[i].substr(0, equals);
    if (valueOf(key) != nullptr) {
      wrong(fmt::format("\"{}\" is given twice", key));
    } else {
      values_.emplace_back(key, pieces[i].substr(equals + 1));
    }
  }
}

void IntegratorSpec::read(std::string_view key, std::uint32_t& value, std::uint32_t low, std::uint32_t high) {
  std::optional<std::uint32_t> given;
  read(key, given, low, high);
  value = given.value_or(value);
}

void IntegratorSpec::read(std::string_view key, std::optional<std::uint32_t>& value, std::uint32_t low,
                          std::uint32_t high) {
  const std::string* text = valueOf(key);
  if (text == nullptr) return;
  if (const auto number = numberIn(*text, low, high)) {
    value = number;
  } else {
    wrong(fmt::format("{} must be a whole number from {} to {}, not \"{}\"", key, low, high, *text));
  }
}

void IntegratorSpec::read(std::string_view key, float& value, float low, float high) {
  std::optional<float> given;
  read(key, given, low, high);
  value = given.value_or(value);
}

void IntegratorSpec::read(std::string_view key, std::optional<float>& value, float low, float high) {
  const std::string* text = valueOf(key);
  if (text == nullptr) return;
  if (const auto number = numberIn(*text, low, high)) {
    value = number;
  } else {
    wrong(fmt::format("{} must be a number from {} to {}, not \"{}\"", key, low, high, *text));
  }
}

void IntegratorSpec::read(std::string_view key, std::vector<std::string>& value) {
  const std::string* text = valueOf(key);
  if (text == nullptr) return;
  value = split(*text, ',');
  if (std::find(value.begin(), value.end(), "") != value.end()) {
    wrong(fmt::format("{} must be names separated by commas, not \"{}\"", key, *text));
  }
}

void IntegratorSpec::refuse(std::string_view key, std::string_view why) {
  if (valueOf(key) != nullptr) wrong(fmt::format("{} {}", key, why));
}

std::optional<std::size_t> IntegratorSpec::readChoice(std::string_view key, std::span<const std::string_view> names) {
  const std::string* text = valueOf(key);
  if (text == nullptr) return std::nullopt;
  const auto found = std::find(names.begin(), names.end(), *text);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  wrong(fmt::format("{} must be {}, not \"{}\"", key, fmt::join(names, "|"), *text), didYouMean(*text, names));
  return std::nullopt;
}

const IntegratorInfo* IntegratorSpec::find(std::span<const IntegratorInfo> integrators) {
  std::vector<std::string_view> names;
  for (const IntegratorInfo& info : integrators) {
    if (info.name != name_) {
      names.push_back(info.name);
      continue;
    }
    std::vector<std::string_view> keys;
    for (const IntegratorKey& key : info.keys) keys.push_back(key.name);
    for (const auto& [key, value] : values_) {
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
        wrong(fmt::format("integrator \"{}\" has no key \"{}\"", name_, key), didYouMean(key, keys));
      }
    }
    return &info;
  }
  wrong(fmt::format("unknown integrator \"{}\" (there are: {})", name_, fmt::join(names, ", ")),
        didYouMean(name_, names));
  return nullptr;
}

void IntegratorSpec::throwIfWrong() const { diagnostics_.throwIfErrors(ErrorKind::Usage); }

const std::string* IntegratorSpec::valueOf(std::string_view key) const {
  for (const auto& [name, value] : values_) {
    if (name == key) return &value;
  }
  return nullptr;
}

void IntegratorSpec::wrong(std::string message, std::string suggestion) {
  diagnostics_.error({}, std::move(message), std::move(suggestion));
}

}  // namespace steradian
