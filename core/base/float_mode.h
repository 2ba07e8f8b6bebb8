#pragma once
/// The floating-point mode of render tasks.
#if defined(__SSE__)
#include <xmmintrin.h>
#endif
#include <cstdint>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

/// While it lives, this thread takes denormal numbers as zero and rounds results that would be denormal to zero: they
/// cost a hundred cycles each on many processors, and every thread must do the same for pictures to be the same to the
/// bit. The caller's mode is restored afterwards.
class FlushDenormals {
 public:
#if defined(__SSE__)
  FlushDenormals() : saved_(_mm_getcsr()) { _mm_setcsr(static_cast<std::uint32_t>(saved_) | 0x8040u); }
  ~FlushDenormals() { _mm_setcsr(static_cast<std::uint32_t>(saved_)); }
#elif defined(__aarch64__)
  FlushDenormals() {
    asm volatile("mrs %0, fpcr" : "=r"(saved_));
    asm volatile("msr fpcr, %0" ::"r"(saved_ | (std::uint64_t{1} << 24)));
  }
  ~FlushDenormals() { asm volatile("msr fpcr, %0" ::"r"(saved_)); }
#else
  FlushDenormals() = default;
#endif
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  std::uint64_t saved_ = 0;
};

}  // namespace steradian
