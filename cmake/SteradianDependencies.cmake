# What Steradian links, as imported targets. This file serves the build and, installed beside SteradianConfig.cmake,
# the users of the package; it looks for nothing that the caller has already found.
include(CMakeFindDependencyMacro)

# These are looked for by header and library. Debian's package configurations of OpenImageIO and Imath also demand
# command-line tools, the OpenCV headers and Python bindings, some hundred megabytes that nothing here uses.
function(steradian_find_library target header libraries)
  if(TARGET ${target})
    return()
  endif()
  string(REGEX REPLACE ":.*" "" name ${target})
  find_path(STERADIAN_${name}_HEADERS ${header})
  set(files "")
  foreach(library IN LISTS libraries)
    find_library(STERADIAN_${library}_LIBRARY ${library})
    mark_as_advanced(STERADIAN_${library}_LIBRARY)
    list(APPEND files "${STERADIAN_${library}_LIBRARY}")
  endforeach()
  mark_as_advanced(STERADIAN_${name}_HEADERS)
  if(NOT STERADIAN_${name}_HEADERS OR "${files}" MATCHES "NOTFOUND")
    message(FATAL_ERROR "Steradian needs ${name}: ${header} and ${libraries} were not found")
  endif()
  list(POP_FRONT files first)
  add_library(${target} UNKNOWN IMPORTED)
  set_target_properties(${target} PROPERTIES
    IMPORTED_LOCATION "${first}"
    INTERFACE_INCLUDE_DIRECTORIES "${STERADIAN_${name}_HEADERS}"
    INTERFACE_LINK_LIBRARIES "${files}")
endfunction()

find_dependency(TBB CONFIG)
find_dependency(fmt CONFIG)
find_dependency(ZLIB)
find_dependency(Threads)
steradian_find_library(Imath::Imath Imath/ImathMatrix.h "Imath")
steradian_find_library(OpenImageIO::OpenImageIO OpenImageIO/imageio.h "OpenImageIO;OpenImageIO_Util")
steradian_find_library(OpenColorIO::OpenColorIO OpenColorIO/OpenColorIO.h "OpenColorIO")

# Embree 4 where there is one, else Embree 3. Both call their target `embree`.
if(NOT TARGET embree)
  find_package(embree 4 CONFIG QUIET)
  if(NOT embree_FOUND)
    find_dependency(embree 3.13 CONFIG)
  endif()
endif()
string(REGEX MATCH "^[0-9]+" STERADIAN_EMBREE_MAJOR "${embree_VERSION}")
