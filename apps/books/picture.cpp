#include "steradian/apps/books/picture.h"

namespace steradian::books {
namespace {

/// As a word of the shell.
std::string quoted(const std::string& word) { return word.find(' ') == std::string::npos ? word : '"' + word + '"'; }

}  // namespace

std::string NumberedPicture::commandLine() const {
  if (mistake != Mistake::None) return "steradian-books --only " + id + " -o .";
  std::string line = "steradian";
  for (const std::string& word : command) line += " " + quoted(word);
  return line + " -o " + file();
}

const NumberedPicture* findPicture(const std::string& id) {
  for (const auto* pictures : {&restOfYourLife(), &oneWeekend()}) {
    for (const NumberedPicture& picture : *pictures) {
      if (picture.id == id) return &picture;
    }
  }
  return nullptr;
}

}  // namespace steradian::books
