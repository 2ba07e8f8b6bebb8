#pragma once
/// The numbered pictures of the books, each with the command that renders it.
#include <string>
#include <vector>

#include "steradian/apps/books/book_integrator.h"

namespace steradian::books {

struct NumberedPicture {
  std::string id;                    ///< the name of its file, without .png
  std::string title;                 ///< "Image 4: what is new in it"
  std::string section;               ///< of the book
  std::vector<std::string> command;  ///< for `steradian`: render, a scene, options; -o left out
  std::string note;                  ///< HTML: what the picture shows, or where we differ from the book
  Mistake mistake = Mistake::None;
  std::string bias{};     ///< why its expected value is not that of its scene; empty: unbiased
  bool enlarged = false;  ///< some pixels of a picture, to be shown larger

  std::string file() const { return id + ".png"; }
  /// As a user types it; "-o FILE" at the end.
  std::string commandLine() const;
};

/// "The Rest of Your Life" v4: Image 1 to 15, and Image 4 put right.
const std::vector<NumberedPicture>& restOfYourLife();
/// "In One Weekend" v4: Image 4 to 23.
const std::vector<NumberedPicture>& oneWeekend();
/// nullptr if there is none.
const NumberedPicture* findPicture(const std::string& id);

}  // namespace steradian::books
