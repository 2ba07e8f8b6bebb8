# Functions that make our targets; what each folder becomes can be read off the root CMakeLists.txt.

# A source for rooms that hold headers only.
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/header_only.cpp" CONTENT "// This room has headers only.\n")

# Users link our objects into shared libraries of theirs. core/base/api.h explains the visibility of names.
set(STERADIAN_OBJECT_PROPERTIES
  POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)

# steradian_layer(NAME GLOBS pattern... [DEPENDS layer...] [LIBRARIES target...])
# One room as the static library steradian_NAME. LIBRARIES are private: no public header includes them. *_kernels.isa.cpp
# are compiled once per instruction set.
function(steradian_layer name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "GLOBS;DEPENDS;LIBRARIES")
  list(TRANSFORM arg_DEPENDS PREPEND steradian_)
  file(GLOB sources CONFIGURE_DEPENDS ${arg_GLOBS})
  if(NOT sources)
    set(sources "${PROJECT_BINARY_DIR}/header_only.cpp")
  endif()
  add_library(steradian_${name} STATIC ${sources})
  set_target_properties(steradian_${name} PROPERTIES ${STERADIAN_OBJECT_PROPERTIES})
  target_link_libraries(steradian_${name}
    PUBLIC ${arg_DEPENDS} Imath::Imath TBB::tbb
    PRIVATE steradian_flags ${arg_LIBRARIES})
  target_include_directories(steradian_${name} PUBLIC "${PROJECT_BINARY_DIR}/include")
  target_compile_options(steradian_${name} PUBLIC -ffp-contract=off)
  target_compile_definitions(steradian_${name} PRIVATE STERADIAN_ISA=baseline STERADIAN_DISPATCH=${STERADIAN_DISPATCH})
  list(FILTER sources INCLUDE REGEX "_kernels\\.isa\\.cpp$")
  foreach(source IN LISTS sources)
    steradian_isa_objects(${name} ${source})
  endforeach()
endfunction()

# steradian_library(layer...): libsteradian, made of the objects of all layers.
function(steradian_library)
  set(objects "")
  set(libraries "")
  foreach(layer IN LISTS ARGN)
    list(APPEND objects $<TARGET_OBJECTS:steradian_${layer}> $<TARGET_PROPERTY:steradian_${layer},STERADIAN_ISA_OBJECTS>)
    get_target_property(linked steradian_${layer} LINK_LIBRARIES)
    list(APPEND libraries ${linked})
  endforeach()
  list(REMOVE_DUPLICATES libraries)
  list(FILTER libraries EXCLUDE REGEX "^steradian_")
  list(REMOVE_ITEM libraries Imath::Imath TBB::tbb)
  add_library(steradian_library ${objects})
  add_library(Steradian::steradian ALIAS steradian_library)
  set_target_properties(steradian_library PROPERTIES
    OUTPUT_NAME steradian EXPORT_NAME steradian LINKER_LANGUAGE CXX
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_link_libraries(steradian_library
    PUBLIC Imath::Imath TBB::tbb
    PRIVATE ${libraries} Threads::Threads $<BUILD_INTERFACE:steradian_flags>)
  target_compile_features(steradian_library PUBLIC cxx_std_20)
  target_include_directories(steradian_library PUBLIC "$<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>")
  if(BUILD_SHARED_LIBS)
    target_compile_definitions(steradian_library PUBLIC STERADIAN_SHARED)
    set(exports "${PROJECT_SOURCE_DIR}/cmake/steradian.exports")
    target_link_options(steradian_library PRIVATE "-Wl,--version-script=${exports}")
    set_property(TARGET steradian_library APPEND PROPERTY LINK_DEPENDS "${exports}")
  endif()
  # Templates of our headers that a user instantiates give the same bits as ours only without contraction.
  target_compile_options(steradian_library PUBLIC
    $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:-ffp-contract=off>)
endfunction()

# steradian_scenes(FOLDER): the built-in scenes, shared by programs, tests and benchmarks.
function(steradian_scenes folder)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  if(NOT sources)
    set(sources "${PROJECT_BINARY_DIR}/header_only.cpp")
  endif()
  add_library(steradian_scenes STATIC ${sources})
  target_link_libraries(steradian_scenes PUBLIC Steradian::steradian PRIVATE steradian_flags fmt::fmt)
endfunction()

# steradian_program(NAME FOLDER [LIBRARIES target...] [INSTALL] [OPTIONAL])
# FOLDER/main.cpp becomes the program build/<preset>/NAME; the rest of FOLDER is the library NAME_parts, which tests
# can link. OPTIONAL programs are built on request only. Nothing happens while there is no main.cpp.
function(steradian_program name folder)
  cmake_parse_arguments(PARSE_ARGV 2 arg "INSTALL;OPTIONAL" "" "LIBRARIES")
  file(GLOB main CONFIGURE_DEPENDS ${folder}/main.cpp)
  file(GLOB parts CONFIGURE_DEPENDS ${folder}/*.cpp)
  list(FILTER parts EXCLUDE REGEX "/main\\.cpp$")
  if(NOT parts)
    set(parts "${PROJECT_BINARY_DIR}/header_only.cpp")
  endif()
  add_library(${name}_parts STATIC EXCLUDE_FROM_ALL ${parts})
  target_link_libraries(${name}_parts
    PUBLIC steradian_scenes Steradian::steradian fmt::fmt ${arg_LIBRARIES} PRIVATE steradian_flags)
  target_compile_definitions(${name}_parts PUBLIC STERADIAN_VERSION="${PROJECT_VERSION}")
  if(NOT main)
    return()
  endif()
  add_executable(${name} ${main})
  target_link_libraries(${name} PRIVATE ${name}_parts steradian_flags)
  set_target_properties(${name} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}" EXCLUDE_FROM_ALL ${arg_OPTIONAL})
  if(arg_INSTALL)
    set_property(GLOBAL APPEND PROPERTY STERADIAN_INSTALLED_PROGRAMS ${name})
  endif()
endfunction()
