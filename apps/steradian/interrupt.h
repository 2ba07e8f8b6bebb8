#pragma once
/// Ctrl-C and SIGTERM as a stop token.
#include <atomic>
#include <csignal>
#include <stop_token>
#include <thread>

namespace steradian::app {

/// While it lives, SIGINT and SIGTERM request a stop instead of ending the program; a second one ends it at once.
/// Make it before any other thread starts: they inherit the blocked signals, and a thread of its own waits for them.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  std::stop_token token() const { return source_.get_token(); }
  bool happened() const { return source_.stop_requested(); }

 private:
  void wait();

  sigset_t signals_;
  std::stop_source source_;
  std::atomic<bool> done_{false};
  std::thread waiter_;
};

}  // namespace steradian::app
