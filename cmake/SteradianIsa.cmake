# Hot code for several instruction sets in one binary (core/base/isa.h says how it is used).
#
# An object compiled for AVX2 also holds inline functions and templates that the baseline objects hold under the same
# names, as weak symbols: the linker would take either for all. So each such object is linked by itself, which dissolves
# its groups of weak symbols, and then keeps one global name, that of its table; tests/isa checks that.

# The sets beside the baseline as NAME=-march. STERADIAN_ARCH selects one target alone; so do sanitizers. Other
# processors and older compilers (clang++ below 18) cannot test the processor for these sets.
set(STERADIAN_ISAS "")
if(NOT STERADIAN_ARCH AND NOT STERADIAN_SANITIZE)
  include(CheckCXXSourceCompiles)
  check_cxx_source_compiles(
    "static_assert(sizeof(void*) == 8); int main() { return __builtin_cpu_supports(\"x86-64-v4\"); }"
    STERADIAN_DISPATCH_COMPILES)
  if(STERADIAN_DISPATCH_COMPILES)
    set(STERADIAN_ISAS avx2=x86-64-v3 avx512=x86-64-v4)
  endif()
endif()
set(STERADIAN_DISPATCH 0)
if(STERADIAN_ISAS)
  set(STERADIAN_DISPATCH 1)
elseif(NOT STERADIAN_ARCH AND NOT CMAKE_CROSSCOMPILING)
  set(STERADIAN_ARCH native)  # not cached
endif()

# g++ stops inlining where a function grows large; in these sources all is one loop, and each call passes lanes through
# memory (measured: a fifth of all instructions). clang++ inlines it by itself.
# The baseline is left out: it is seldom run, and has all widths to compile.
set(STERADIAN_HOT_OPTIONS "")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT STERADIAN_SANITIZE)
  set(STERADIAN_HOT_OPTIONS --param=max-inline-insns-auto=400 --param=max-inline-insns-single=1000
    --param=inline-unit-growth=400 --param=large-function-growth=2000 --param=large-function-insns=20000
    --param=large-stack-frame-growth=10000 --param=inline-min-speedup=1)
  # Values in lanes are some 300 bytes: a call of memcpy takes longer than the copy.
  if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
    list(APPEND STERADIAN_HOT_OPTIONS -mmemcpy-strategy=vector_loop:1024:noalign,libcall:-1:noalign)
  endif()
endif()

# steradian_isa_objects(LAYER SOURCE): adds SOURCE, NAME_kernels.isa.cpp, which defines the table nameKernels, once more
# to the library steradian_LAYER for each set.
function(steradian_isa_objects layer source)
  if(NOT STERADIAN_ISAS)
    set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS "${STERADIAN_HOT_OPTIONS}")
  endif()
  get_filename_component(name ${source} NAME_WE)
  string(REGEX REPLACE "_kernels$" "Kernels" table ${name})
  string(LENGTH ${table} table_length)
  get_target_property(libraries steradian_${layer} LINK_LIBRARIES)
  set(files "")
  foreach(entry IN LISTS STERADIAN_ISAS)
    string(REGEX MATCH "^(.*)=(.*)$" entry ${entry})
    set(isa ${CMAKE_MATCH_1})
    set(object steradian_${name}_${isa})
    add_library(${object} OBJECT ${source})
    set_target_properties(${object} PROPERTIES ${STERADIAN_OBJECT_PROPERTIES} INTERPROCEDURAL_OPTIMIZATION OFF)
    target_link_libraries(${object} PRIVATE ${libraries})
    target_include_directories(${object} PRIVATE "${PROJECT_BINARY_DIR}/include")
    # Unique names, which g++ gives to variables of templates, would stay global even so.
    target_compile_options(${object} PRIVATE ${STERADIAN_HOT_OPTIONS} -ffp-contract=off -fno-lto
      $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique> -march=${CMAKE_MATCH_2})
    target_compile_definitions(${object} PRIVATE STERADIAN_ISA=${isa})
    string(LENGTH ${isa} isa_length)
    set(file "${PROJECT_BINARY_DIR}/isa/${name}_${isa}.o")
    add_custom_command(OUTPUT "${file}"
      COMMAND ${CMAKE_COMMAND} -E make_directory "${PROJECT_BINARY_DIR}/isa"
      COMMAND ${CMAKE_LINKER} -r --force-group-allocation -o "${file}" $<TARGET_OBJECTS:${object}>
      COMMAND ${CMAKE_OBJCOPY} "--keep-global-symbol=_ZN9steradian${isa_length}${isa}${table_length}${table}E" "${file}"
      DEPENDS ${object} $<TARGET_OBJECTS:${object}> VERBATIM COMMAND_EXPAND_LISTS
      COMMENT "Keeping the names of ${isa} code local: ${name}_${isa}.o")
    list(APPEND files "${file}")
  endforeach()
  if(files)
    add_custom_target(steradian_${name}_isas DEPENDS ${files})
    target_sources(steradian_${layer} PRIVATE ${files})
    set_property(TARGET steradian_${layer} APPEND PROPERTY STERADIAN_ISA_OBJECTS ${files})
    add_dependencies(steradian_${layer} steradian_${name}_isas)
  endif()
endfunction()
