#include "steradian/core/base/diagnostics.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace steradian {
namespace {

TEST(Diagnostics, FormatsPlaceExcerptCaretAndSuggestion) {
  const Diagnostic diagnostic{Severity::Error, {"box.pbrt", 2, 10, 8}, "unknown material \"difuse\"", "diffuse"};
  EXPECT_EQ(format(diagnostic, "# a box\nMaterial \"difuse\"\n"),
            "box.pbrt:2:10: error: unknown material \"difuse\" (did you mean \"diffuse\"?)\n"
            "    2 | Material \"difuse\"\n"
            "      |          ^~~~~~~~");
  EXPECT_EQ(format(diagnostic), "box.pbrt:2:10: error: unknown material \"difuse\" (did you mean \"diffuse\"?)");
}

TEST(Diagnostics, LeavesOutWhatIsNotKnown) {
  EXPECT_EQ(format({Severity::Warning, {}, "odd", {}}), "warning: odd");
  EXPECT_EQ(format({Severity::Error, {"a.exr", 0, 0, 0}, "bad", {}}, "text"), "a.exr: error: bad");
  EXPECT_EQ(format({Severity::Error, {"a", 7, 3, 1}, "bad", {}}, "one line"), "a:7:3: error: bad");
  EXPECT_EQ(format({Severity::Error, {"a", 1, 0, 0}, "bad", {}}, "one"), "a:1: error: bad\n    1 | one");
}

TEST(Diagnostics, CaretStandsBelowItsCharacter) {
  // A tab is one blank, and e with an accent is two bytes but one character.
  EXPECT_EQ(format({Severity::Error, {"a", 1, 5, 3}, "bad", {}}, "\t\xC3\xA9 xyz\r\n"),
            "a:1:5: error: bad\n    1 |  \xC3\xA9 xyz\n      |    ^~~");
  // A place behind the end of the line, as for something missing.
  EXPECT_EQ(format({Severity::Error, {"a", 1, 9, 4}, "bad", {}}, "abc"),
            "a:1:9: error: bad\n    1 | abc\n      |    ^");
}

TEST(Diagnostics, HostileTextIsHarmless) {
  const std::string text = format({Severity::Error, {"a", 1, 5000, 9}, "bad\x1b[2J\n", {}}, std::string(10000, '\x1b'));
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_LT(text.size(), 400u);
  const std::size_t caret = text.find('^');
  ASSERT_NE(caret, std::string::npos);
}

TEST(Diagnostics, AllErrorsAtOnce) {
  Diagnostics diagnostics;
  EXPECT_TRUE(diagnostics.empty());
  diagnostics.warning({"a", 1, 1, 1}, "first");
  EXPECT_NO_THROW(diagnostics.throwIfErrors(ErrorKind::Scene));
  diagnostics.error({"b", 2, 1, 1}, "second", "other");
  try {
    diagnostics.throwIfErrors(ErrorKind::Scene,
                              [](const std::string& file) { return file == "b" ? "x\ny" : std::string_view{}; });
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Scene);
    EXPECT_EQ(error.diagnostics().size(), 2u);
    EXPECT_STREQ(error.what(),
                 "a:1:1: warning: first\n"
                 "b:2:1: error: second (did you mean \"other\"?)\n    2 | y\n      | ^");
  }
}

TEST(Diagnostics, KeepsErrorsWhenThereAreTooMany) {
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < Diagnostics::capacity; ++i) diagnostics.warning({}, "w");
  for (int i = 0; i < 3; ++i) diagnostics.error({}, "e");
  EXPECT_EQ(diagnostics.items().size(), Diagnostics::capacity);
  EXPECT_EQ(diagnostics.errorCount(), 3u);
  EXPECT_EQ(diagnostics.items().back().severity, Severity::Error);
  EXPECT_TRUE(diagnostics.format().ends_with("\n... and 3 more"));
}

TEST(Diagnostics, EditDistance) {
  EXPECT_EQ(editDistance("", "abc"), 3u);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3u);
  EXPECT_EQ(editDistance("sobol", "osbol"), 1u);
  EXPECT_EQ(editDistance("ca", "abc"), 3u);  // 2 if a swapped pair could be edited again
  EXPECT_EQ(editDistance("PNG", "png"), 0u);
}

TEST(Diagnostics, DidYouMean) {
  const std::vector<std::string> scenes{"one-weekend", "cornell-box", "cornell-smoke", "quads"};
  EXPECT_EQ(didYouMean("cornel-box", scenes), "cornell-box");
  EXPECT_EQ(didYouMean("cornellbxo", scenes), "cornell-box");
  EXPECT_EQ(didYouMean("cornell", scenes), "cornell-box");
  EXPECT_EQ(didYouMean("bunny", scenes), "");
  EXPECT_EQ(didYouMean("", scenes), "");
  EXPECT_EQ(didYouMean(std::string(100000, 'x'), scenes), "");
  EXPECT_EQ(didYouMean("x", {"y", "z"}), "");
  EXPECT_EQ(didYouMean("mix", std::array<std::string_view, 2>{"bsdf", "mis"}), "mis");
}

}  // namespace
}  // namespace steradian
