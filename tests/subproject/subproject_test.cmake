# Configures the project OUTSIDE, which adds the folder STERADIAN, in WORK with COMPILER, LAUNCHER and FLAGS: with a
# static library, then with a shared one. If COMPILE is true also builds and runs it, and checks by NM which symbols the
# libraries export. All of these are given with -D.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nfailed with ${status}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

# The mangled names that a library exports.
function(names_of library)
  run("${NM}" --dynamic --defined-only --format=just-symbols "${library}")
  string(REGEX REPLACE "\n+" ";" names "${output}")
  list(FILTER names INCLUDE REGEX ".")
  set(names "${names}" PARENT_SCOPE)
endfunction()

# Fails with MESSAGE and the names that match PATTERN, if there are any.
function(refuse message pattern)
  list(FILTER names INCLUDE REGEX "${pattern}")
  if(names)
    list(JOIN names "\n" names)
    message(FATAL_ERROR "${message}:\n${names}")
  endif()
endfunction()

# # The commands that compile sources.
function(check_commands build)
  file(READ "${build}/compile_commands.json" commands)
  string(REGEX REPLACE "-Wno-[a-z-]+" "" commands "${commands}")
  if(commands MATCHES " (-O[1-3s]|-DNDEBUG|-W[a-z]+|-fdiagnostics-color[a-z=]*)")
    message(FATAL_ERROR "something is compiled with ${CMAKE_MATCH_1}, which the parent did not ask for")
  endif()
  if(commands MATCHES "-std=[a-z+]*(20|2a)")
    message(FATAL_ERROR "something is compiled with ${CMAKE_MATCH_0}, and not in the parent's language")
  endif()
endfunction()

function(check_that_no_rules_came_in build)
  run(${CMAKE_COMMAND} --install "${build}" --prefix "${build}/installed")
  file(GLOB installed "${build}/installed/*")
  if(installed)
    message(FATAL_ERROR "installed although the parent installs nothing: ${installed}")
  endif()
  run(${CMAKE_CTEST_COMMAND} --test-dir "${build}" --show-only)
  if(NOT output MATCHES "Total Tests: 0")
    message(FATAL_ERROR "tests came in:\n${output}")
  endif()
endfunction()

# # The symbols that the libraries export.
function(check_names build shared)
  names_of("${build}/liboutside.so")
  if(NOT "_Z10renderABitv" IN_LIST names)
    message(FATAL_ERROR "liboutside.so shows no function of its own")
  endif()
  if(NOT shared)
    refuse("liboutside.so shows what it took from the static library" "9steradian")
    return()
  endif()
  names_of("${build}/steradian/libsteradian.so")
  refuse("libsteradian.so shows kernels" "9steradian(8baseline|4avx2|6avx512|11filmKernels|10pathKernel)")
  refuse("libsteradian.so shows its boundary to Embree" "^_Z(T[ISTV])?NK?9steradian6embree")
  # A constructor and a function, with any arguments; what exceptions and derived classes need.
  foreach(name IN ITEMS _ZN9steradian5SceneC1E _ZN9steradian6renderE _ZTIN9steradian5ErrorE
      _ZTVN9steradian18RadianceIntegratorE)
    if(NOT names MATCHES "${name}")
      message(FATAL_ERROR "libsteradian.so does not show ${name}")
    endif()
  endforeach()
  list(FILTER names EXCLUDE REGEX "^_Z(G[RV])?(T[ISTVhv])?[n0-9_]*Z*NK?9steradian")
  refuse("libsteradian.so shows names of others" ".")
endfunction()

set(ENV{CMAKE_CXX_COMPILER_LAUNCHER} "${LAUNCHER}")
file(REMOVE_RECURSE "${WORK}")
foreach(shared IN ITEMS OFF ON)
  set(build "${WORK}/shared-${shared}")
  # The library is compiled twice: without optimisation, which does not affect what is checked here.
  run(${CMAKE_COMMAND} -S "${OUTSIDE}" -B "${build}" -G Ninja
    -D "STERADIAN=${STERADIAN}" -D CMAKE_BUILD_TYPE=Outside -D CMAKE_CXX_FLAGS_OUTSIDE=-O0 -D BUILD_SHARED_LIBS=${shared}
    "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}")
  check_commands("${build}")
  check_that_no_rules_came_in("${build}")
  if(COMPILE)
    run(${CMAKE_COMMAND} --build "${build}")
    run("${build}/program")
    check_names("${build}" ${shared})
  endif()
endforeach()
