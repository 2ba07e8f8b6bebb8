/// apps/books/README.md: every file that its tables name exists, and contains the words listed with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace steradian::books {
namespace {

std::string textOf(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The third cell of each row but the heads.
std::vector<std::string> placesOf(const std::string& readme) {
  std::vector<std::string> places;
  std::istringstream lines(readme);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| ") || line.starts_with("| section")) continue;
    std::istringstream row(line);
    std::string cell;
    for (int i = 0; i <= 3; ++i) std::getline(row, cell, '|');  // before the first bar is nothing
    places.push_back(cell);
  }
  return places;
}

bool hasWord(const std::string& text, const std::string& word) {
  const auto isPart = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !isPart(text[at - 1])) && (end == text.size() || !isPart(text[end]))) return true;
  }
  return false;
}

TEST(BooksReadme, FilesExistAndHaveTheNames) {
  const std::filesystem::path root = STERADIAN_SOURCE_DIR;
  const std::vector<std::string> places = placesOf(textOf(root / "apps/books/README.md"));
  EXPECT_GT(places.size(), 60u);
  // [path](../../path): `Name`, `name`; [path](../../path): ...
  const std::regex place(R"(\[([^\]]+)\]\(\.\./\.\./([^)]+)\): ((`[^`]+`(, )?)+))"), name("`([^`]+)`");
  for (const std::string& cell : places) {
    SCOPED_TRACE(cell);
    std::size_t found = 0;
    for (std::sregex_iterator at(cell.begin(), cell.end(), place), end; at != end; ++at, ++found) {
      const std::string path = (*at)[1], names = (*at)[3];
      EXPECT_EQ(path, (*at)[2].str());
      ASSERT_TRUE(std::filesystem::is_regular_file(root / path)) << path;
      const std::string text = textOf(root / path);
      for (std::sregex_iterator word(names.begin(), names.end(), name); word != end; ++word)
        EXPECT_TRUE(hasWord(text, (*word)[1])) << (*word)[1] << " is not in " << path;
    }
    EXPECT_GT(found, 0u);
    EXPECT_EQ(found, static_cast<std::size_t>(std::count(cell.begin(), cell.end(), '[')))
        << "a place is not understood";
  }
}

TEST(BooksReadme, WordsAreWhole) {
  EXPECT_TRUE(hasWord("struct Lambert {", "Lambert"));
  EXPECT_FALSE(hasWord("struct LambertMaterial {", "Lambert"));
}

}  // namespace
}  // namespace steradian::books
