#pragma once
/// What the books claim in passing, measured.
#include <filesystem>

#include "steradian/apps/books/pages.h"
#include "steradian/apps/books/rendering.h"

namespace steradian::books {

/// Writes claims.html and its pictures into `folder`; `tally` is of the renders so far. Throws Error.
void writeClaims(const std::filesystem::path& folder, const Effort& effort, Tally tally);

}  // namespace steradian::books
