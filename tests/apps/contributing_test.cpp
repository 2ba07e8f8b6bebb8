/// CONTRIBUTING.md and README.md: every file that they name exists, and the table of what is where is true.
#include <gtest/gtest.h>

#include "steradian/tests/apps/named_places.h"

namespace steradian::test {
namespace {

const std::filesystem::path kRoot = STERADIAN_SOURCE_DIR;

TEST(Contributing, FilesOfTheTableExistAndHaveTheNames) {
  const std::vector<std::string> places = columnOf(textOf(kRoot / "CONTRIBUTING.md"), "what", 1);
  EXPECT_GT(places.size(), 40u);
  for (const std::string& cell : places) expectPlaces(cell, "");
}

TEST(Contributing, PathsInTheTextExist) {
  for (const char* document : {"CONTRIBUTING.md", "README.md", "BENCHMARKS.md"}) {
    SCOPED_TRACE(document);
    expectPathsExist(textOf(kRoot / document));
  }
}

}  // namespace
}  // namespace steradian::test
