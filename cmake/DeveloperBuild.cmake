# SPDX-License-Identifier: BSD-3-Clause
# Settings for a build of Edgeproof itself, not for a project that includes it.
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

find_program(CCACHE ccache)
mark_as_advanced(CCACHE)
if(CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
    if(EDGEPROOF_PCH)
        # Without CCACHE_DEPEND, ccache takes an old precompiled header when only a comment of a
        # header changed; #pragma once compares whole files with it and then includes them twice.
        set(CMAKE_CXX_COMPILER_LAUNCHER
            ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_DEPEND=1
            ${CCACHE})
    endif()
endif()

if(EDGEPROOF_SANITIZE)
    add_compile_options(-fsanitize=${EDGEPROOF_SANITIZE} -fno-omit-frame-pointer
        -fno-sanitize-recover=all)
    add_link_options(-fsanitize=${EDGEPROOF_SANITIZE})
endif()

if(EDGEPROOF_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link)
endif()

if(EDGEPROOF_CLANG_TIDY)
    find_program(CLANG_TIDY NAMES clang-tidy REQUIRED)
    set(CMAKE_CXX_CLANG_TIDY ${CLANG_TIDY} --quiet)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU") # clang does not know GCC's warnings
        list(APPEND CMAKE_CXX_CLANG_TIDY --extra-arg=-Wno-unknown-warning-option)
    endif()
endif()
