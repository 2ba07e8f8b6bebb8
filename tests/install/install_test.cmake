# Builds TARGETS of the build tree BUILD, installs them below WORK, moves the installation to where no path points yet,
# and builds and runs the project OUTSIDE against it with COMPILER and FLAGS. All of these are given with -D.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nfailed with ${status}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${WORK}")
run(${CMAKE_COMMAND} --build "${BUILD}" --target ${TARGETS})
run(${CMAKE_COMMAND} --install "${BUILD}" --prefix "${WORK}/installed")
# A package must not remember where it was installed or built.
file(RENAME "${WORK}/installed" "${WORK}/prefix")
file(GLOB_RECURSE package "${WORK}/prefix/*.cmake")
if(NOT package)
  message(FATAL_ERROR "no CMake package was installed")
endif()
get_filename_component(source "${OUTSIDE}/../../.." ABSOLUTE)
foreach(file IN LISTS package)
  file(READ "${file}" text)
  string(FIND "${text}" "${source}" found)
  if(NOT found EQUAL -1)
    message(FATAL_ERROR "${file} mentions the source tree ${source}")
  endif()
endforeach()

run(${CMAKE_COMMAND} -S "${OUTSIDE}" -B "${WORK}/outside" -G Ninja
  -D CMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}"
  "-DCMAKE_PREFIX_PATH=${WORK}/prefix")
run(${CMAKE_COMMAND} --build "${WORK}/outside")
run("${WORK}/outside/outside")
message(STATUS "outside says: ${output}")

# The program runs from where it was moved to.
if(EXISTS "${WORK}/prefix/bin/steradian")
  run("${WORK}/prefix/bin/steradian" scenes)
endif()
