# steradian_flags: how our own code is compiled. Nothing here reaches users of the installed package.
add_library(steradian_flags INTERFACE)
if(STERADIAN_WARNINGS)
  target_compile_options(steradian_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
endif()
target_compile_features(steradian_flags INTERFACE cxx_std_20)
target_compile_options(steradian_flags INTERFACE
  # The same picture from every compiler: IEEE arithmetic without contraction, and never -ffast-math, because
  # infinities carry meaning here (a Dirac density). These two only drop errno and floating-point traps.
  -fno-math-errno -fno-trapping-math
  # A shared library calls its own functions, as the static one does, not those that a program puts in their place.
  $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>
  # Optimising g++ 12 gives these two for correct uses of std::string in aggregates (GCC bugs 105651 and 105562);
  # clang++ and the sanitizers check for the same faults.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-maybe-uninitialized>
  # The calling convention of lanes wider than a register depends on the target: code for different targets never passes
  # lanes to each other (core/base/isa.h).
  -Wno-psabi)

if(BUILD_SHARED_LIBS)
  target_compile_definitions(steradian_flags INTERFACE STERADIAN_SHARED)
endif()

if(STERADIAN_WERROR)
  target_compile_options(steradian_flags INTERFACE -Werror)
endif()

if(STERADIAN_ARCH)
  target_compile_options(steradian_flags INTERFACE -march=${STERADIAN_ARCH})
endif()

if(STERADIAN_SANITIZE)
  target_compile_options(steradian_flags INTERFACE
    -fsanitize=${STERADIAN_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
    # g++ 12 warns about its own instrumented code.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow -Wno-array-bounds>)
  target_compile_definitions(steradian_flags INTERFACE _GLIBCXX_ASSERTIONS)
  target_link_options(steradian_flags INTERFACE -fsanitize=${STERADIAN_SANITIZE})
endif()

# Colours also when Ninja collects the output, and a compiler cache where there is one (it has to be told that a
# precompiled header may stand for its text).
if(PROJECT_IS_TOP_LEVEL)
  set(CMAKE_COLOR_DIAGNOSTICS ON)
  find_program(STERADIAN_CCACHE ccache)
  mark_as_advanced(STERADIAN_CCACHE)
  if(STERADIAN_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER
      "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros "${STERADIAN_CCACHE}")
  endif()
endif()
