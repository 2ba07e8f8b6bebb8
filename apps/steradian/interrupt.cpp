#include "steradian/apps/steradian/interrupt.h"

#include <unistd.h>

#include <ctime>

#include "steradian/apps/steradian/console.h"
#include "steradian/apps/steradian/exit_codes.h"

namespace steradian::app {

Interrupt::Interrupt() {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  waiter_ = std::thread([this] { wait(); });
}

Interrupt::~Interrupt() {
  done_ = true;
  waiter_.join();
  pthread_sigmask(SIG_UNBLOCK, &signals_, nullptr);
}

void Interrupt::wait() {
  const timespec patience{.tv_sec = 0, .tv_nsec = 50'000'000};
  while (!done_) {
    if (sigtimedwait(&signals_, nullptr, &patience) < 0) continue;
    if (source_.stop_requested()) _exit(kExitOther);  // second request: the user does not want to wait for the picture
    printErr("\nstopping and saving; once more to end at once\n");
    source_.request_stop();
  }
}

}  // namespace steradian::app
