# Copyright 2026 The spigolo authors
# SPDX-License-Identifier: Apache-2.0
#
# cmake --install: static libraries, public headers and the package that
# find_package(spigolo CONFIG REQUIRED) finds, with the target spigolo::spigolo
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/spigolo)

get_property(layers GLOBAL PROPERTY SPIGOLO_LAYERS)
install(TARGETS spigolo ${layers} EXPORT spigolo ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT spigolo FILE spigoloTargets.cmake NAMESPACE spigolo:: DESTINATION ${package_dir})

# *-inl.h are private: they may include third-party headers.
install(
  DIRECTORY src/spigolo
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING
  PATTERN "*.h"
  PATTERN "*-inl.h" EXCLUDE)

configure_package_config_file(cmake/spigoloConfig.cmake.in spigoloConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(spigoloConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/spigoloConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/spigoloConfigVersion.cmake DESTINATION ${package_dir})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
