#include "steradian/core/base/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <random>
#include <string>
#include <system_error>
#include <utility>

#include "steradian/core/base/diagnostics.h"

namespace steradian {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& target, int error) {
  throw Error(ErrorKind::Output, "cannot write \"" + target.string() + "\": " + std::generic_category().message(error));
}

class FileDescriptor {
 public:
  explicit FileDescriptor(int fd) : fd_(fd) {}
  FileDescriptor(FileDescriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  FileDescriptor& operator=(FileDescriptor&&) = delete;
  ~FileDescriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }
  /// The result matters: network file systems report a full disk here.
  int close() { return ::close(std::exchange(fd_, -1)); }

 private:
  int fd_;
};

/// Removes the file unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path path) : path_(std::move(path)) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!renamed_) ::unlink(path_.c_str());
  }
  bool renameTo(const fs::path& target) { return renamed_ = ::rename(path_.c_str(), target.c_str()) == 0; }

 private:
  fs::path path_;
  bool renamed_ = false;
};

/// What the links lead to; it need not exist.
fs::path followLinks(const fs::path& target) {
  constexpr int maxLinks = 40;  // as Linux does
  fs::path path = target;
  std::error_code error;
  for (int i = 0; fs::is_symlink(fs::symlink_status(path, error)); ++i) {
    if (i == maxLinks) fail(target, ELOOP);
    const fs::path next = fs::read_symlink(path, error);
    if (error) fail(target, error.value());
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  return path;
}

fs::path directoryOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// Writes all, in pieces if need be. Returns 0 or the error number.
int writeAll(int fd, std::span<const std::byte> data) {
  while (!data.empty()) {
    // Linux writes at most 2 GiB a call; smaller pieces also let a signal handler stop us between them.
    const ssize_t written = ::write(fd, data.data(), std::min<std::size_t>(data.size(), std::size_t{1} << 26));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    if (written == 0) return EIO;
    data = data.subspan(static_cast<std::size_t>(written));
  }
  return 0;
}

std::pair<FileDescriptor, fs::path> createTemporary(const fs::path& target, const fs::path& directory) {
  constexpr int attempts = 100;
  std::random_device random;
  for (int i = 0; i < attempts; ++i) {
    // Not derived from the target's name, which may already be as long as names can be.
    fs::path path = directory / (".steradian-" + std::to_string(::getpid()) + "-" + std::to_string(random()) + ".tmp");
    const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0) return {FileDescriptor(fd), std::move(path)};
    if (errno != EEXIST) fail(target, errno);
  }
  fail(target, EEXIST);
}

void writeInPlace(const fs::path& target, std::span<const std::byte> data) {
  FileDescriptor file(::open(target.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.get() < 0) fail(target, errno);
  if (const int error = writeAll(file.get(), data)) fail(target, error);
  if (file.close() != 0) fail(target, errno);
}

void replaceFile(const fs::path& target, const fs::path& path, const struct stat* old,
                 std::span<const std::byte> data) {
  const fs::path directory = directoryOf(path);
  auto [file, temporaryPath] = createTemporary(target, directory);
  TemporaryFile temporary(temporaryPath);
  if (const int error = writeAll(file.get(), data)) fail(target, error);
  if (old && ::fchmod(file.get(), old->st_mode & 0777) != 0) fail(target, errno);
  if (::fsync(file.get()) != 0) fail(target, errno);
  struct stat written {};
  if (::fstat(file.get(), &written) != 0) fail(target, errno);
  if (static_cast<std::size_t>(written.st_size) != data.size()) fail(target, EIO);
  if (file.close() != 0) fail(target, errno);
  if (!temporary.renameTo(path)) fail(target, errno);
  // Makes the new name durable; errors are ignored, because some file systems cannot sync a folder.
  const FileDescriptor folder(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() >= 0) ::fsync(folder.get());
}

/// The state of the existing file, or an empty optional if there is none; throws if it is known to be not writable.
std::optional<struct stat> examine(const fs::path& target, const fs::path& path) {
  struct stat state {};
  if (::stat(path.c_str(), &state) != 0) {
    if (errno == ENOENT && path.has_filename()) return std::nullopt;
    fail(target, errno == ENOENT ? EISDIR : errno);
  }
  if (S_ISDIR(state.st_mode)) fail(target, EISDIR);
  if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) fail(target, errno);
  return state;
}

}  // namespace

void writeFileAtomically(const fs::path& target, std::span<const std::byte> data) {
  if (target == "-") {
    if (const int error = writeAll(STDOUT_FILENO, data)) fail("standard output", error);
    return;
  }
  const fs::path path = followLinks(target);
  const auto old = examine(target, path);
  if (old && !S_ISREG(old->st_mode)) return writeInPlace(target, data);
  replaceFile(target, path, old ? &*old : nullptr, data);
}

void checkWritable(const fs::path& target) {
  if (target == "-") {
    const int flags = ::fcntl(STDOUT_FILENO, F_GETFL);
    if (flags < 0) fail("standard output", errno);
    if ((flags & O_ACCMODE) == O_RDONLY) fail("standard output", EBADF);
    return;
  }
  const fs::path path = followLinks(target);
  const auto old = examine(target, path);
  if (old && !S_ISREG(old->st_mode)) return;
  const fs::path directory = directoryOf(path);
  if (::faccessat(AT_FDCWD, directory.c_str(), W_OK | X_OK, AT_EACCESS) != 0) fail(target, errno);
}

}  // namespace steradian
