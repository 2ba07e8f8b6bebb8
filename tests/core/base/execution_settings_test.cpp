#include "steradian/core/base/execution_settings.h"

#include <gtest/gtest.h>

namespace steradian {
namespace {

std::size_t complaintsAbout(const ExecutionSettings& settings) {
  try {
    requireUsable(settings);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Usage);
    return error.diagnostics().size();
  }
  return 0;
}

TEST(ExecutionSettings, TheDefaultsAreUsable) {
  EXPECT_EQ(complaintsAbout({}), 0u);
  EXPECT_EQ(ExecutionSettings{}.isa, bestIsa());
  EXPECT_EQ(ExecutionSettings{}.width, 0u);
}

TEST(ExecutionSettings, WidthsAreThoseThatKernelsAreCompiledFor) {
  for (std::uint32_t width = 0; width <= 33; ++width) {
    const bool known = width == 0 || width == 1 || width == 4 || width == 8 || width == 16;
    EXPECT_EQ(complaintsAbout({.width = width}), known ? 0u : 1u) << width;
  }
}

TEST(ExecutionSettings, TheInstructionSetMustBeUsable) {
  for (const Isa isa : {Isa::Baseline, Isa::Avx2, Isa::Avx512}) {
    EXPECT_EQ(complaintsAbout({.isa = isa}), isUsable(isa) ? 0u : 1u);
    EXPECT_EQ(complaintsAbout({.isa = isa, .width = 3}), isUsable(isa) ? 1u : 2u) << "all at once";
  }
}

}  // namespace
}  // namespace steradian
