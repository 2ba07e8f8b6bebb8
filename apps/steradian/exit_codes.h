#pragma once
/// What the program's exit codes mean (those of sysexits.h where it has one).
#include "steradian/core/base/diagnostics.h"

namespace steradian::app {

enum ExitCode : int {
  kExitSuccess = 0,
  kExitOther = 1,
  kExitUsage = 2,
  kExitScene = 65,  ///< bad scene or asset
  kExitMemory = 71,
  kExitOutput = 74,   ///< a result could not be written
  kExitStopped = 75,  ///< interrupted; the unfinished picture was saved
};

inline ExitCode exitCodeOf(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::Usage:
      return kExitUsage;
    case ErrorKind::Scene:
      return kExitScene;
    case ErrorKind::Memory:
      return kExitMemory;
    case ErrorKind::Output:
      return kExitOutput;
    case ErrorKind::Other:
      return kExitOther;
  }
  return kExitOther;
}

}  // namespace steradian::app
