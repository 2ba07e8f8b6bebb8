#pragma once
/// Runs the program `steradian`, or another one, as a user would.
#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace steradian::cli {

/// Where a stream of the program leads.
enum class Stream { Captured, Closed, FullDisk, BrokenPipe };

struct Launch {
  std::vector<std::string> arguments;
  Stream output = Stream::Captured, error = Stream::Captured;
  std::vector<std::string> environment{};        ///< "NAME=value", beside the inherited
  std::optional<std::uint64_t> fileSizeLimit{};  ///< bytes, as `ulimit -f` sets it
  std::string program = STERADIAN_PROGRAM;
};

struct Outcome {
  int exitCode = 0;  ///< minus the signal if one ended it
  std::string output, error;

  std::vector<std::string> errorLines() const;
};

/// A running program. Its directory is `directory`, its captured streams are files elsewhere.
class Program {
 public:
  Program(const Launch& launch, const std::filesystem::path& directory);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void send(int signal) const;
  /// Waits until standard error contains the text. False if the program ended before, or after a minute.
  bool waitForError(const std::string& text);
  Outcome wait();

 private:
  bool ended(bool block);

  std::filesystem::path streams_;
  pid_t process_ = -1;
  std::optional<int> status_;
};

}  // namespace steradian::cli
