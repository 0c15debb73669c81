# SPDX-License-Identifier: BSD-3-Clause
# Includes point down: the target include_order, on which every module depends, fails if a source
# includes a header of a folder above its own in src/edgeproof/folders.txt. It runs again when a
# source has changed.
file(GLOB_RECURSE edgeproof_sources CONFIGURE_DEPENDS src/edgeproof/*.cpp src/edgeproof/*.hpp)
set(include_order_checked ${PROJECT_BINARY_DIR}/include_order.checked)
add_custom_command(OUTPUT ${include_order_checked}
    COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR}
        -D STAMP=${include_order_checked} -P ${PROJECT_SOURCE_DIR}/cmake/include_order.cmake
    DEPENDS ${edgeproof_sources} ${PROJECT_SOURCE_DIR}/src/edgeproof/folders.txt
        ${PROJECT_SOURCE_DIR}/cmake/include_order.cmake
    COMMENT "Includes point down" VERBATIM)
add_custom_target(include_order ALL DEPENDS ${include_order_checked})
