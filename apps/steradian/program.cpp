#include "steradian/apps/steradian/program.h"

#include <csignal>
#include <exception>
#include <new>
#include <string>

#include "steradian/apps/steradian/console.h"
#include "steradian/apps/steradian/exit_codes.h"

namespace steradian::app {

int runMain(const std::function<int()>& work) noexcept {
  try {
    openMissingStreams();
    // A limit on file size or a closed pipe must end in an error message, not in a dead process.
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
    return work();
  } catch (const Error& error) {
    printErr(std::string(error.what()) + "\n");
    return exitCodeOf(error.kind());
  } catch (const std::bad_alloc&) {
    printErr("error: out of memory\n");
    return kExitMemory;
  } catch (const std::exception& error) {
    printErr(std::string("error: ") + error.what() + "\n");
    return kExitOther;
  }
}

}  // namespace steradian::app
