#include "steradian/core/base/isa.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "steradian/core/base/diagnostics.h"

namespace steradian {
namespace {

constexpr std::array kNames{std::string_view("baseline"), std::string_view("avx2"), std::string_view("avx512")};
constexpr std::array kAll{Isa::Baseline, Isa::Avx2, Isa::Avx512};

bool processorHas([[maybe_unused]] Isa isa) {
#if STERADIAN_DISPATCH
  if (isa == Isa::Avx2) return __builtin_cpu_supports("x86-64-v3") != 0;
  if (isa == Isa::Avx512) return __builtin_cpu_supports("x86-64-v4") != 0;
#endif
  return true;
}

}  // namespace

std::span<const Isa> compiledIsas() { return std::span(kAll).first(STERADIAN_DISPATCH ? kAll.size() : 1); }

bool isUsable(Isa isa) {
  const std::span<const Isa> compiled = compiledIsas();
  return std::find(compiled.begin(), compiled.end(), isa) != compiled.end() && processorHas(isa);
}

Isa bestIsa() {
  Isa best = Isa::Baseline;
  for (const Isa isa : compiledIsas()) {
    if (isUsable(isa)) best = isa;
  }
  return best;
}

void requireUsable(Isa isa) {
  if (isUsable(isa)) return;
  const std::span<const Isa> compiled = compiledIsas();
  const bool there = std::find(compiled.begin(), compiled.end(), isa) != compiled.end();
  throw Error(ErrorKind::Usage, fmt::format("{} has no {}{}", there ? "this processor" : "this build", nameOf(isa),
                                            there ? "" : ": it is for one target"));
}

Isa isaOf(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) {
    throw Error(
        ErrorKind::Usage,
        Diagnostic{Severity::Error, {}, fmt::format("unknown instruction set \"{}\"", name), didYouMean(name, kNames)});
  }
  return kAll[static_cast<std::size_t>(found - kNames.begin())];
}

std::string_view nameOf(Isa isa) { return kNames[static_cast<std::size_t>(isa)]; }

}  // namespace steradian
