#pragma once
/// The text by which users choose an integrator: `name{:key=value}`, such as `path:strategy=mis:max-depth=4`.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "steradian/core/base/diagnostics.h"

namespace STERADIAN_API steradian {

/// One key of an integrator, for --help and for "did you mean".
struct IntegratorKey {
  std::string_view name, defaultValue, help;
};
struct IntegratorInfo {
  std::string_view name, help;
  std::span<const IntegratorKey> keys;
};

/// A parsed spec. The readers leave the given value alone when the key is absent, and collect what is wrong with it
/// otherwise, so that the user sees all mistakes at once.
class IntegratorSpec {
 public:
  /// Splits the text; complains about parts that are no `key=value` and about keys given twice.
  explicit IntegratorSpec(std::string_view text);

  const std::string& name() const { return name_; }

  /// A whole number in [low, high].
  void read(std::string_view key, std::uint32_t& value, std::uint32_t low, std::uint32_t high);
  void read(std::string_view key, std::optional<std::uint32_t>& value, std::uint32_t low, std::uint32_t high);
  /// A number in [low, high]; +inf is allowed if `high` is.
  void read(std::string_view key, float& value, float low, float high);
  void read(std::string_view key, std::optional<float>& value, float low, float high);
  /// Comma-separated names, none of them empty.
  void read(std::string_view key, std::vector<std::string>& value);
  /// One of the names; enumerators must be 0, 1, 2, ... in their order.
  template <class Enum>
  void read(std::string_view key, Enum& value, std::span<const std::string_view> names) {
    if (const std::optional<std::size_t> choice = readChoice(key, names)) value = static_cast<Enum>(*choice);
  }

  /// Complains if the key was given: "KEY " + why.
  void refuse(std::string_view key, std::string_view why);

  /// Complains about the name if it is not among `integrators`, otherwise about keys that it does not have.
  const IntegratorInfo* find(std::span<const IntegratorInfo> integrators);
  /// Throws Error (kind Usage) with all complaints.
  void throwIfWrong() const;

 private:
  const std::string* valueOf(std::string_view key) const;
  std::optional<std::size_t> readChoice(std::string_view key, std::span<const std::string_view> names);
  void wrong(std::string message, std::string suggestion = {});

  std::string name_;
  std::vector<std::pair<std::string, std::string>> values_;
  Diagnostics diagnostics_;
};

}  // namespace steradian
