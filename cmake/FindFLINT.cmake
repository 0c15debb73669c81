# SPDX-License-Identifier: GPL-3.0-or-later
# Targets FLINT::FLINT and FLINT::Arb. FLINT 3 has Arb inside (<flint/arb.h>): FLINT::Arb then
# defines EDGEPROOF_ARB_IN_FLINT. Beside FLINT 2.9 Arb is a library of its own (<arb.h>), which
# Debian 12 calls flint-arb.
include(FindPackageHandleStandardArgs)
include(${CMAKE_CURRENT_LIST_DIR}/ImportLibrary.cmake)
import_library(FLINT HEADER flint/flint.h LIBRARY flint)
if(FLINT_FOUND AND NOT TARGET FLINT::Arb)
    add_library(FLINT::Arb INTERFACE IMPORTED)
    target_link_libraries(FLINT::Arb INTERFACE FLINT::FLINT)
    if(EXISTS "${FLINT_INCLUDE_DIR}/flint/arb.h")
        target_compile_definitions(FLINT::Arb INTERFACE EDGEPROOF_ARB_IN_FLINT)
    else()
        find_path(FLINT_ARB_INCLUDE_DIR arb.h)
        find_library(FLINT_ARB_LIBRARY NAMES flint-arb arb)
        mark_as_advanced(FLINT_ARB_INCLUDE_DIR FLINT_ARB_LIBRARY)
        find_package_handle_standard_args(FLINT
            REQUIRED_VARS FLINT_ARB_LIBRARY FLINT_ARB_INCLUDE_DIR)
        target_include_directories(FLINT::Arb SYSTEM INTERFACE "${FLINT_ARB_INCLUDE_DIR}")
        target_link_libraries(FLINT::Arb INTERFACE "${FLINT_ARB_LIBRARY}")
    endif()
endif()
