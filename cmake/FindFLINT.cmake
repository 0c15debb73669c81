# SPDX-License-Identifier: BSD-3-Clause
# The target FLINT::Arb: FLINT with Arb. FLINT 3 contains Arb (<flint/arb.h>); the target then
# defines EDGEPROOF_ARB_IN_FLINT. With FLINT 2.9, Arb is a separate library (<arb.h>), which Debian
# 12 calls flint-arb.
include(FindPackageHandleStandardArgs)
find_path(FLINT_INCLUDE_DIR flint/flint.h)
find_library(FLINT_LIBRARY flint)
if(EXISTS "${FLINT_INCLUDE_DIR}/flint/arb.h")
    find_package_handle_standard_args(FLINT REQUIRED_VARS FLINT_LIBRARY FLINT_INCLUDE_DIR)
    set(arb_in_flint EDGEPROOF_ARB_IN_FLINT)
else()
    find_path(FLINT_ARB_INCLUDE_DIR arb.h)
    find_library(FLINT_ARB_LIBRARY NAMES flint-arb arb)
    find_package_handle_standard_args(FLINT
        REQUIRED_VARS FLINT_LIBRARY FLINT_INCLUDE_DIR FLINT_ARB_LIBRARY FLINT_ARB_INCLUDE_DIR)
endif()
mark_as_advanced(FLINT_LIBRARY FLINT_INCLUDE_DIR FLINT_ARB_LIBRARY FLINT_ARB_INCLUDE_DIR)
if(FLINT_FOUND AND NOT TARGET FLINT::Arb)
    add_library(FLINT::Arb INTERFACE IMPORTED)
    target_include_directories(FLINT::Arb SYSTEM
        INTERFACE ${FLINT_ARB_INCLUDE_DIR} ${FLINT_INCLUDE_DIR})
    target_link_libraries(FLINT::Arb INTERFACE ${FLINT_ARB_LIBRARY} ${FLINT_LIBRARY})
    target_compile_definitions(FLINT::Arb INTERFACE ${arb_in_flint})
endif()
