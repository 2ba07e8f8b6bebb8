#include "steradian/core/base/isa.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "steradian/core/base/diagnostics.h"

namespace steradian {
namespace {

std::string complaintOf(Isa isa) {
  try {
    requireUsable(isa);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Usage);
    return error.what();
  }
  return "";
}

TEST(Isa, TheBaselineIsAlwaysThere) {
  ASSERT_FALSE(compiledIsas().empty());
  EXPECT_EQ(compiledIsas().front(), Isa::Baseline);
  EXPECT_TRUE(isUsable(Isa::Baseline));
}

TEST(Isa, TheBestIsTheWidestUsableOne) {
  for (const Isa isa : {Isa::Baseline, Isa::Avx2, Isa::Avx512}) {
    EXPECT_TRUE(!isUsable(isa) || isa <= bestIsa());
  }
  EXPECT_TRUE(isUsable(bestIsa()));
}

TEST(Isa, WhatIsMissingIsSaid) {
  for (const Isa isa : {Isa::Baseline, Isa::Avx2, Isa::Avx512}) {
    const auto compiled = compiledIsas();
    const bool there = std::find(compiled.begin(), compiled.end(), isa) != compiled.end();
    const std::string expected = (there ? "this processor has no " : "this build has no ") + std::string(nameOf(isa));
    const std::string complaint = complaintOf(isa);
    EXPECT_EQ(complaint.empty(), isUsable(isa));
    EXPECT_TRUE(isUsable(isa) || complaint.find(expected) != std::string::npos) << complaint;
  }
}

TEST(Isa, Names) {
  for (const Isa isa : {Isa::Baseline, Isa::Avx2, Isa::Avx512}) EXPECT_EQ(isaOf(nameOf(isa)), isa);
  for (const char* name : {"", "AVX2", "native"}) EXPECT_THROW(isaOf(name), Error) << name;
}

}  // namespace
}  // namespace steradian
