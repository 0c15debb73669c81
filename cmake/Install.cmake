# SPDX-License-Identifier: BSD-3-Clause
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/edgeproof)

install(DIRECTORY src/edgeproof TYPE INCLUDE FILES_MATCHING PATTERN "*.hpp"
    PATTERN cli EXCLUDE)
install(EXPORT edgeproof NAMESPACE edgeproof:: FILE edgeproofTargets.cmake
    DESTINATION ${package_dir})
configure_package_config_file(cmake/edgeproofConfig.cmake.in edgeproofConfig.cmake
    INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(edgeproofConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
    ${PROJECT_BINARY_DIR}/edgeproofConfig.cmake
    ${PROJECT_BINARY_DIR}/edgeproofConfigVersion.cmake
    cmake/ImportLibrary.cmake cmake/FindGMP.cmake cmake/FindMPFR.cmake cmake/FindFLINT.cmake
    DESTINATION ${package_dir})
install(DIRECTORY examples/cpp examples/scenes examples/recipes examples/compare examples/design
    DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)
