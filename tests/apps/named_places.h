#pragma once
/// Tables in our documents that lead to the sources: their cells name files, and what is declared or used there. The
/// tests keep them true.
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace steradian::test {

std::string textOf(const std::filesystem::path& path);

/// Whether `word` stands in the text other than as a part of a longer name.
bool hasWord(std::string_view text, std::string_view word);

/// One column, counted from 0, of those tables of a Markdown text whose first head is `head`; without heads.
std::vector<std::string> columnOf(const std::string& markdown, std::string_view head, int column);

/// Expects a cell to consist of places, [path](link): `Name`, `name`; [path](link): ..., of which the files exist and
/// have the names as whole words. Paths are relative to the root of the sources, links to `folder` there.
void expectPlaces(const std::string& cell, const std::filesystem::path& folder);

/// Expects all files and folders to exist that the text names in `code` and that begin with a folder of the sources.
void expectPathsExist(const std::string& markdown);

}  // namespace steradian::test
