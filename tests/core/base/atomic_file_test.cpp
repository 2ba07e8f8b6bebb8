#include "steradian/core/base/atomic_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <string_view>

#include "steradian/core/base/diagnostics.h"
#include "steradian/tests/support/temporary_folder.h"

namespace steradian {
namespace {

namespace fs = std::filesystem;

class AtomicFile : public test::TemporaryFolder {};

void write(const fs::path& path, std::string_view text) { writeFileAtomically(path, std::as_bytes(std::span(text))); }

std::string contentOf(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::string failureOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Output);
    return error.what();
  }
  return "";
}

TEST_F(AtomicFile, CreatesAndReplaces) {
  write(folder_ / "a", "one");
  EXPECT_EQ(contentOf(folder_ / "a"), "one");
  ::chmod((folder_ / "a").c_str(), 0640);
  write(folder_ / "a", "second");
  EXPECT_EQ(contentOf(folder_ / "a"), "second");
  EXPECT_EQ(fs::status(folder_ / "a").permissions(), fs::perms(0640));
  write(folder_ / "a", "");
  EXPECT_EQ(contentOf(folder_ / "a"), "");
  EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(AtomicFile, LongestNameIsPossible) {
  const fs::path path = folder_ / std::string(255, 'n');
  write(path, "x");
  EXPECT_EQ(contentOf(path), "x");
  const fs::path tooLong = folder_ / std::string(256, 'n');
  EXPECT_NE(failureOf([&] { checkWritable(tooLong); }), "");
  EXPECT_NE(failureOf([&] { write(tooLong, "x"); }), "");
}

TEST_F(AtomicFile, LinksStay) {
  fs::create_directory(folder_ / "deep");
  fs::create_symlink("deep/target", folder_ / "link");
  fs::create_symlink("link", folder_ / "link2");
  checkWritable(folder_ / "link2");
  write(folder_ / "link2", "through");  // the target does not exist yet
  write(folder_ / "link2", "again");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link2"));
  EXPECT_EQ(contentOf(folder_ / "deep" / "target"), "again");
  fs::create_symlink("circle", folder_ / "circle");
  EXPECT_NE(failureOf([&] { write(folder_ / "circle", "x"); }), "");
}

TEST_F(AtomicFile, ReplacesWhileAReaderHoldsTheOldOne) {
  write(folder_ / "a", "old");
  std::ifstream reader(folder_ / "a");
  write(folder_ / "a", "new and longer");
  std::string text;
  reader >> text;
  EXPECT_EQ(text, "old");
}

TEST_F(AtomicFile, DevicesAreWrittenInPlace) {
  checkWritable("/dev/null");
  EXPECT_EQ(failureOf([] { write("/dev/null", "x"); }), "");
  const std::string full = failureOf([] { write("/dev/full", "x"); });
  EXPECT_NE(full.find("\"/dev/full\""), std::string::npos) << full;
  EXPECT_NE(full.find("No space left on device"), std::string::npos) << full;
}

TEST_F(AtomicFile, PipesAreWrittenInPlace) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  checkWritable(pipe);  // must not wait for a reader
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  write(pipe, "hello");
  std::array<char, 16> buffer{};
  EXPECT_EQ(::read(reader, buffer.data(), buffer.size()), 5);
  ::close(reader);
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(AtomicFile, DashIsStandardOutput) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    write("-", "bytes");
    ::_exit(0);
  }
  ::close(ends[1]);
  std::array<char, 16> buffer{};
  EXPECT_EQ(::read(ends[0], buffer.data(), buffer.size()), 5);
  EXPECT_EQ(std::string_view(buffer.data(), 5), "bytes");
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  EXPECT_FALSE(fs::exists("-"));
}

TEST_F(AtomicFile, UnwritablePlacesAreFoundBeforehand) {
  std::ofstream(folder_ / "file") << "x";
  for (const fs::path& path : {folder_, folder_ / "", folder_ / "missing" / "a", folder_ / "file" / "a", fs::path()}) {
    SCOPED_TRACE(path);
    const std::string before = failureOf([&] { checkWritable(path); });
    EXPECT_NE(before, "");
    EXPECT_EQ(before, failureOf([&] { write(path, "x"); }));
  }
  EXPECT_EQ(failureOf([&] { checkWritable(folder_ / "new"); }), "");
  EXPECT_EQ(filesInFolder(), 1u);
}

/// As a user without privileges, if the tests run as root.
TEST_F(AtomicFile, PermissionsAreRespected) {
  fs::create_directory(folder_ / "closed");
  std::ofstream(folder_ / "protected") << "x";
  ::chmod((folder_ / "protected").c_str(), 0444);
  ::chmod((folder_ / "closed").c_str(), 0555);
  ::chmod(folder_.c_str(), 0777);
  const pid_t child = ::fork();
  if (child == 0) {
    if (::geteuid() == 0 && ::seteuid(65534) != 0) ::_exit(9);
    int failures = 0;
    for (const fs::path& path : {folder_ / "closed" / "a", folder_ / "protected"}) {
      failures += failureOf([&] { checkWritable(path); }).find("Permission denied") == std::string::npos;
      failures += failureOf([&] { write(path, "x"); }).find("Permission denied") == std::string::npos;
    }
    ::_exit(failures);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  ::chmod((folder_ / "closed").c_str(), 0755);
}

}  // namespace
}  // namespace steradian
