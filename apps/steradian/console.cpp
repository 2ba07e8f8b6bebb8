#include "steradian/apps/steradian/console.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <span>

#include "steradian/core/base/atomic_file.h"

namespace steradian::app {

void printOut(std::string_view text) { writeFileAtomically("-", std::as_bytes(std::span(text.data(), text.size()))); }

void printErr(std::string_view text) noexcept {
  while (!text.empty()) {
    const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void openMissingStreams() {
  for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; ++fd) {
    if (::fcntl(fd, F_GETFD) >= 0 || errno != EBADF) continue;
    // open() returns the lowest free descriptor, the missing one. Opened in the wrong direction, its use is still an
    // error.
    if (::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

}  // namespace steradian::app
