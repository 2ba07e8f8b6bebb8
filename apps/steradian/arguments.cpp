#include "steradian/apps/steradian/arguments.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

namespace steradian::app {

namespace {

/// The whole text as a number, or nothing.
template <class Number>
std::optional<Number> parse(std::string_view text) {
  Number value{};
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

constexpr int kMaxSide = 65536;
constexpr std::int64_t kMaxPixels = std::int64_t{1} << 28;

}  // namespace

void Arguments::problem(std::string message, std::string suggestion) {
  problems_.error({}, std::move(message), std::move(suggestion));
}

void Arguments::unexpected(const std::vector<std::string>& words, const std::vector<std::string>& known) {
  bool afterOption = false;
  for (const std::string& word : words) {
    const bool isOption = word.size() > 1 && word.front() == '-';
    if (isOption || !afterOption) {
      const std::string name = word.substr(0, word.find('='));
      problem(fmt::format("unexpected argument \"{}\"", word), didYouMean(name, known));
    }
    afterOption = isOption && word.find('=') == std::string::npos;
  }
}

std::uint32_t Arguments::whole(std::string_view option, const std::string& text, std::uint32_t low,
                               std::uint32_t high) {
  const auto value = parse<std::uint32_t>(text);
  if (value && *value >= low && *value <= high) return *value;
  problem(fmt::format("{} needs a whole number from {} to {}, not \"{}\"", option, low, high, text));
  return low;
}

double Arguments::number(std::string_view option, const std::string& text, double low, double high) {
  const auto value = parse<double>(text);
  if (value && *value >= low && *value <= high) return *value;
  problem(fmt::format("{} needs a number from {} to {}, not \"{}\"", option, low, high, text));
  return low;
}

Size Arguments::size(std::string_view option, const std::string& text) {
  const std::size_t cross = text.find_first_of("xX");
  if (cross != std::string::npos) {
    const std::string_view all = text;
    const auto width = parse<int>(all.substr(0, cross)), height = parse<int>(all.substr(cross + 1));
    if (width && height && *width >= 1 && *height >= 1 && *width <= kMaxSide && *height <= kMaxSide &&
        std::int64_t{*width} * *height <= kMaxPixels)
      return {*width, *height};
  }
  problem(fmt::format("{} needs WIDTHxHEIGHT, sides from 1 to {} and at most {} pixels, not \"{}\"", option, kMaxSide,
                      kMaxPixels, text));
  return {1, 1};
}

Crop Arguments::crop(std::string_view option, const std::string& text, Size within) {
  std::array<int, 4> values{};
  std::string_view rest = text;
  bool good = true;
  for (std::size_t i = 0; i < values.size() && good; ++i) {
    const std::size_t comma = i < 3 ? rest.find(',') : rest.size();
    const auto value = comma == std::string_view::npos ? std::nullopt : parse<int>(rest.substr(0, comma));
    good = value.has_value();
    if (good) values[i] = *value;
    if (good && i < 3) rest.remove_prefix(comma + 1);
  }
  const Crop crop{values[0], values[1], values[2], values[3]};
  if (good && 0 <= crop.x0 && crop.x0 < crop.x1 && crop.x1 <= within.width && 0 <= crop.y0 && crop.y0 < crop.y1 &&
      crop.y1 <= within.height)
    return crop;
  problem(fmt::format("{} needs x0,x1,y0,y1 with 0 <= x0 < x1 <= {} and 0 <= y0 < y1 <= {}, not \"{}\"", option,
                      within.width, within.height, text));
  return {0, within.width, 0, within.height};
}

double Arguments::seconds(std::string_view option, const std::string& text) {
  static constexpr std::array<std::pair<std::string_view, double>, 4> units{
      {{"ms", 0.001}, {"s", 1.0}, {"m", 60.0}, {"h", 3600.0}}};
  std::string_view digits = text;
  double scale = 1.0;
  for (const auto& [unit, length] : units) {
    if (!digits.ends_with(unit)) continue;
    digits.remove_suffix(unit.size());
    scale = length;
    break;
  }
  const auto value = parse<double>(digits);
  if (value && std::isfinite(*value) && *value > 0.0 && *value * scale <= 1e9) return *value * scale;
  problem(fmt::format("{} needs a time such as 90s, 1.5m, 2h or 500ms, not \"{}\"", option, text));
  return 1.0;
}

}  // namespace steradian::app
