/// `steradian-books --quick` as a user runs it, and the commands of its pages.
#include <fstream>
#include <regex>
#include <sstream>

#include "steradian/apps/books/picture.h"
#include "steradian/tests/apps/cli_test.h"

namespace steradian::cli {
namespace {

using books::NumberedPicture;

class Book : public CliTest {
 protected:
  Outcome book(std::vector<std::string> arguments) const {
    return launch({.arguments = std::move(arguments), .program = STERADIAN_BOOKS});
  }
  std::string text(const std::string& name) const {
    std::ifstream file(path(name));
    std::stringstream all;
    all << file.rdbuf();
    return all.str();
  }
};

TEST_F(Book, WritesEveryPictureAndEveryPage) {
  const Outcome outcome = book({"--quick"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_EQ(outcome.error, "");
  for (const auto& [name, pictures] : {std::pair("book/rest-of-your-life.html", &books::restOfYourLife()),
                                       std::pair("book/in-one-weekend.html", &books::oneWeekend())}) {
    const std::string html = text(name);
    for (const NumberedPicture& picture : *pictures) {
      SCOPED_TRACE(picture.id);
      EXPECT_NE(html.find("<img src=\"" + picture.file() + "\""), std::string::npos);
      EXPECT_GT(readImage(path("book/" + picture.file())).width(), 8);
      EXPECT_NE(outcome.output.find(picture.id), std::string::npos) << "progress";
    }
  }
  for (const char* name : {"book/rest-of-your-life.html", "book/in-one-weekend.html", "book/claims.html"}) {
    SCOPED_TRACE(name);
    const std::string html = text(name);
    EXPECT_GT(html.size(), 2000u);
    EXPECT_FALSE(std::regex_search(html, std::regex("\\b-?(nan|inf)\\b"))) << "a number is missing";
    EXPECT_EQ(html.find("http"), std::string::npos) << "the pages load nothing";
    // Every local link leads somewhere.
    const std::regex local("(href|src)=\"([^\"#]*)(#([^\"]*))?\"");
    for (std::sregex_iterator link(html.begin(), html.end(), local), end; link != end; ++link) {
      const std::string there = (*link)[2], place = (*link)[4];
      const std::string file = there.empty() ? std::string(name) : "book/" + there;
      EXPECT_TRUE(std::filesystem::exists(path(file))) << file;
      if (place.empty()) continue;
      EXPECT_NE(text(file).find("id=\"" + place + "\""), std::string::npos) << place;
    }
  }
}

// (That they all parse is books_test.cpp's: starting the program takes long.)
TEST_F(Book, TheProgramTakesTheCommandsOfThePages) {
  for (const auto* pictures : {&books::restOfYourLife(), &books::oneWeekend()}) {
    for (const NumberedPicture& picture : *pictures) {
      SCOPED_TRACE(picture.id);
      if (picture.mistake != books::Mistake::None || std::stoi(picture.title.substr(6)) % 4 != 2) continue;
      std::vector<std::string> words = picture.command;
      words.insert(words.end(), {"-o", picture.file(), "-q", "--spp", "1"});
      if (!picture.enlarged) words.insert(words.end(), {"--size", "16x9"});
      const Outcome outcome = run(words);
      EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
      EXPECT_TRUE(std::filesystem::exists(path(picture.file())));
    }
  }
}

TEST_F(Book, OnePictureAlone) {
  const Outcome outcome = book({"--quick", "--only", "rest-of-your-life-04", "-o", "."});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_EQ(files(), std::set<std::string>{"rest-of-your-life-04.png"});
  expectComplaints(book({"--only", "rest-of-your-life-99", "--quik"}), 2,
                   {"unknown picture \"rest-of-your-life-99\"", R"("--quik" (did you mean "--quick"?))"});
  EXPECT_NE(book({"--list"}).output.find("in-one-weekend-23"), std::string::npos);
}

}  // namespace
}  // namespace steradian::cli
