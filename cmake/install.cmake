# SPDX-License-Identifier: MIT
# Install rules and package files: find_package(bolide [COMPONENTS gsl png hdf5]) gives the same targets as add_subdirectory.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(bolide_package_dir ${CMAKE_INSTALL_DATADIR}/cmake/bolide) # no compiled code: the same for every architecture
foreach(target bolide bolide_gsl bolide_png bolide_hdf5)
  if(NOT TARGET ${target})
    continue()
  endif()
  if(CMAKE_VERSION VERSION_GREATER_EQUAL 3.23)
    install(TARGETS ${target} EXPORT ${target}_export FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  else()
    install(TARGETS ${target} EXPORT ${target}_export)
  endif()
  install(EXPORT ${target}_export NAMESPACE bolide:: DESTINATION ${bolide_package_dir} FILE ${target}Targets.cmake)
endforeach()
if(CMAKE_VERSION VERSION_LESS 3.23)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/bolide DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
endif()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/bolideConfig.cmake.in ${PROJECT_BINARY_DIR}/bolideConfig.cmake
  INSTALL_DESTINATION ${bolide_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/bolideConfigVersion.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/bolideConfig.cmake ${PROJECT_BINARY_DIR}/bolideConfigVersion.cmake ${PROJECT_SOURCE_DIR}/cmake/hdf5.cmake
  DESTINATION ${bolide_package_dir})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
