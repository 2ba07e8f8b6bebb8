#include "steradian/tests/apps/named_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <regex>
#include <sstream>

namespace steradian::test {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = STERADIAN_SOURCE_DIR;

std::string cellOf(const std::string& row, int column) {
  std::istringstream cells(row);
  std::string cell;
  for (int i = -1; i <= column; ++i) std::getline(cells, cell, '|');  // before the first bar is nothing
  return cell;
}

std::vector<std::sregex_iterator::value_type> matchesOf(const std::string& text, const std::regex& pattern) {
  return {std::sregex_iterator(text.begin(), text.end(), pattern), std::sregex_iterator()};
}

}  // namespace

std::string textOf(const fs::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

bool hasWord(std::string_view text, std::string_view word) {
  const auto isPart = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !isPart(text[at - 1])) && (end == text.size() || !isPart(text[end]))) return true;
  }
  return false;
}

std::vector<std::string> columnOf(const std::string& markdown, std::string_view head, int column) {
  std::vector<std::string> cells;
  std::istringstream lines(markdown);
  bool inTable = false, isWanted = false;
  for (std::string line; std::getline(lines, line);) {
    const bool isRow = line.starts_with("|");
    if (isRow && !inTable) isWanted = line.starts_with("| " + std::string(head) + " |");
    if (isRow && inTable && isWanted && !line.starts_with("|-")) cells.push_back(cellOf(line, column));
    inTable = isRow;
  }
  return cells;
}

void expectPlaces(const std::string& cell, const fs::path& folder) {
  SCOPED_TRACE(cell);
  static const std::regex place(R"(\[([^\]]+)\]\(([^)]+)\): ((`[^`]+`(, )?)+))"), name("`([^`]+)`");
  std::size_t found = 0;
  for (const std::smatch& at : matchesOf(cell, place)) {
    const std::string path = at[1], link = at[2], names = at[3];
    ++found;
    EXPECT_EQ((folder / link).lexically_normal(), fs::path(path)) << "the link leads elsewhere";
    ASSERT_TRUE(fs::is_regular_file(kRoot / path)) << path;
    const std::string text = textOf(kRoot / path);
    for (const std::smatch& word : matchesOf(names, name))
      EXPECT_TRUE(hasWord(text, word[1].str())) << word[1] << " is not in " << path;
  }
  EXPECT_GT(found, 0u);
  EXPECT_EQ(found, static_cast<std::size_t>(std::count(cell.begin(), cell.end(), '['))) << "a place is not understood";
}

void expectPathsExist(const std::string& markdown) {
  static const std::regex path("`((?:core|accel|materials|lights|integrators|apps|tests|cmake|docs)/[a-z0-9_./-]+)`");
  const auto paths = matchesOf(markdown, path);
  EXPECT_FALSE(paths.empty());
  for (const std::smatch& at : paths) EXPECT_TRUE(fs::exists(kRoot / at[1].str())) << at[1];
}

}  // namespace steradian::test
