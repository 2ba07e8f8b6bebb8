# cmake --install: programs, library, headers under include/steradian, and the package for find_package(Steradian).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package "${CMAKE_INSTALL_LIBDIR}/cmake/Steradian")
get_property(programs GLOBAL PROPERTY STERADIAN_INSTALLED_PROGRAMS)
if(BUILD_SHARED_LIBS AND programs)
  file(RELATIVE_PATH to_library "/${CMAKE_INSTALL_BINDIR}" "/${CMAKE_INSTALL_LIBDIR}")
  set_target_properties(${programs} PROPERTIES INSTALL_RPATH "$ORIGIN/${to_library}")
endif()

install(TARGETS steradian_library EXPORT SteradianTargets INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
if(programs)
  install(TARGETS ${programs})
endif()
install(DIRECTORY core accel materials lights integrators
  DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/steradian"
  FILES_MATCHING PATTERN "*.h" PATTERN "accel/embree_*" EXCLUDE)
install(EXPORT SteradianTargets NAMESPACE Steradian:: DESTINATION "${package}")
install(FILES LICENSE NOTICE DESTINATION "${CMAKE_INSTALL_DOCDIR}")

configure_package_config_file(cmake/SteradianConfig.cmake.in "${PROJECT_BINARY_DIR}/SteradianConfig.cmake"
  INSTALL_DESTINATION "${package}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/SteradianConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/SteradianConfig.cmake"
  "${PROJECT_BINARY_DIR}/SteradianConfigVersion.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/SteradianDependencies.cmake"
  DESTINATION "${package}")
