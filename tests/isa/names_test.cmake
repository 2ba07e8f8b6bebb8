# Each of OBJECTS, isa/TABLE_ISA.o, has one global name: its table. NM lists them. Both are given with -D.
cmake_minimum_required(VERSION 3.25)

if(NOT OBJECTS)
  message(FATAL_ERROR "there are no objects to look at")
endif()
foreach(object IN LISTS OBJECTS)
  execute_process(COMMAND "${NM}" --defined-only --extern-only --format=just-symbols --demangle "${object}"
    OUTPUT_VARIABLE names OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE "^.*/(.*)_kernels_(.*)\\.o$" "steradian::\\2::\\1Kernels" expected "${object}")
  if(NOT names STREQUAL expected)
    message(FATAL_ERROR "${object} defines for all to see\n${names}\nbut should only define ${expected}")
  endif()
endforeach()
