/// apps/books/README.md: every file that its tables name exists, and contains the words listed with it.
#include <gtest/gtest.h>

#include "steradian/tests/apps/named_places.h"

namespace steradian::test {
namespace {

TEST(BooksReadme, FilesExistAndHaveTheNames) {
  const std::filesystem::path root = STERADIAN_SOURCE_DIR;
  const std::vector<std::string> places = columnOf(textOf(root / "apps/books/README.md"), "section", 2);
  EXPECT_GT(places.size(), 60u);
  for (const std::string& cell : places) expectPlaces(cell, "apps/books");
}

}  // namespace
}  // namespace steradian::test
