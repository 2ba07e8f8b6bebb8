#include <cstdio>
#include <exception>
#include <string>

#include "outside.h"
#if defined(HAS_STERADIAN)
#include <steradian/core/base/diagnostics.h>
using Expected = steradian::Error;
#else
using Expected = std::exception;
#endif

int main() {
  if (renderABit() != 0.5f) return 1;
  try {
    failALot();
  } catch (const Expected& error) {  // from another library
    std::printf("%s\n", error.what());
    return std::string(error.what()).find("ball") != std::string::npos ? 0 : 1;
  }
  return 1;
}
