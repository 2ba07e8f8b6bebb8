#include "steradian/tests/apps/run_program.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace steradian::cli {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

int openTarget(Stream stream, const fs::path& capture) {
  if (stream == Stream::Captured) return ::open(capture.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (stream == Stream::FullDisk) return ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return -1;
  ::close(ends[0]);
  return ends[1];
}

void redirect(Stream stream, int descriptor, const fs::path& capture) {
  if (stream == Stream::Closed) {
    ::close(descriptor);
  } else if (::dup2(openTarget(stream, capture), descriptor) < 0) {
    ::_exit(126);
  }
}

/// In the child process.
[[noreturn]] void become(const Launch& launch, const fs::path& directory, const fs::path& streams) {
  if (::chdir(directory.c_str()) != 0) ::_exit(126);
  for (const std::string& variable : launch.environment) {
    const std::size_t equals = variable.find('=');
    ::setenv(variable.substr(0, equals).c_str(), variable.substr(equals + 1).c_str(), 1);
  }
  redirect(launch.output, STDOUT_FILENO, streams / "output");
  redirect(launch.error, STDERR_FILENO, streams / "error");
  if (launch.fileSizeLimit) {
    const rlimit limit{*launch.fileSizeLimit, *launch.fileSizeLimit};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(126);
  }
  std::vector<std::string> words{fs::path(launch.program).filename()};
  words.insert(words.end(), launch.arguments.begin(), launch.arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(launch.program.c_str(), pointers.data());
  ::_exit(127);
}

}  // namespace

std::vector<std::string> Outcome::errorLines() const {
  std::vector<std::string> lines;
  std::istringstream text(error);
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

Program::Program(const Launch& launch, const fs::path& directory) {
  std::string name = (fs::temp_directory_path() / "steradian-streams-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a directory for streams");
  streams_ = name;
  process_ = ::fork();
  if (process_ < 0) throw std::runtime_error("cannot fork");
  if (process_ == 0) become(launch, directory, streams_);
}

Program::~Program() {
  if (!ended(false)) {
    send(SIGKILL);
    ended(true);
  }
  std::error_code ignored;
  fs::remove_all(streams_, ignored);
}

bool Program::ended(bool block) {
  int status = 0;
  if (!status_ && ::waitpid(process_, &status, block ? 0 : WNOHANG) == process_) status_ = status;
  return status_.has_value();
}

void Program::send(int signal) const { ::kill(process_, signal); }

bool Program::waitForError(const std::string& text) {
  using namespace std::chrono_literals;
  for (int i = 0; i < 6000; ++i) {
    const bool last = ended(false);
    if (contentOf(streams_ / "error").find(text) != std::string::npos) return true;
    if (last) return false;
    std::this_thread::sleep_for(10ms);
  }
  return false;
}

Outcome Program::wait() {
  ended(true);
  const int status = status_.value_or(0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), contentOf(streams_ / "output"),
          contentOf(streams_ / "error")};
}

}  // namespace steradian::cli
