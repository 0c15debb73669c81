# SPDX-License-Identifier: BSD-3-Clause
include(${CMAKE_CURRENT_LIST_DIR}/UnitsByFolder.cmake)

# edgeproof_own_flags(<target> [QUICK]): settings that every target of this build shares. Installed
# targets do not pass them on, except -ffp-contract=off, which edgeproof_precision does.
# QUICK: release builds compile the target with -Og, in about half of the compiler's time. It spends
# its time in MPFR, in Arb and in the operators of precision, which has full optimization.
function(edgeproof_own_flags target)
    cmake_parse_arguments(PARSE_ARGV 1 arg "QUICK" "" "")
    target_compile_features(${target} PRIVATE cxx_std_20)
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
    target_compile_options(${target} PRIVATE
        -Wall -Wextra -Wpedantic -Wshadow -Wconversion $<$<BOOL:${EDGEPROOF_WERROR}>:-Werror>)
    # Double words need each product and sum to be rounded separately. The flag is set for every
    # source, because the linker may keep any source's copy of an inline function.
    target_compile_options(${target} PRIVATE -ffp-contract=off)
    # Most calls go to MPFR and Arb. Commands take up to 3 % less time without a stub for each such
    # call, and if functions may be inlined in spite of -fPIC.
    target_compile_options(${target} PRIVATE
        $<$<CXX_COMPILER_ID:GNU,Clang>:-fno-plt$<SEMICOLON>-fno-semantic-interposition>)
    # GCC 12 warns of inlined copies in std::string that cannot overlap or overrun (its bugs 105651,
    # 105329 and similar ones). The warnings depend on inlining; the sanitizers check instead.
    target_compile_options(${target} PRIVATE
        "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict;-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread>")
    # GCC 14 has similar warnings of moves and copies of strings, in tests.
    target_compile_options(${target} PRIVATE
        "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,13>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,15>>:-Wno-array-bounds;-Wno-stringop-overflow>")
    if(EDGEPROOF_PYTHON_BUILT)
        # The libraries become part of a shared one. All targets need the flag, because they share a
        # precompiled header.
        target_compile_options(${target} PRIVATE -fPIC)
    endif()
    if(EDGEPROOF_SANITIZE)
        # GCC 12 warns that the sanitizers' code in <regex> is uninitialized (its bug 105562).
        target_compile_options(${target} PRIVATE
            $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    endif()
    set(headers_of edgeproof_precision)
    if(arg_QUICK)
        target_compile_options(${target} PRIVATE
            $<$<AND:$<CXX_COMPILER_ID:GNU,Clang>,$<CONFIG:Release>>:-Og>)
        # GCC takes the level of optimization from a precompiled header, whatever the command line
        # says. So these targets share another one.
        set(headers_of edgeproof_quick_headers)
    endif()
    if(EDGEPROOF_PCH AND target STREQUAL headers_of)
        target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp)
    elseif(EDGEPROOF_PCH)
        target_precompile_headers(${target} REUSE_FROM ${headers_of})
    endif()
    if(EDGEPROOF_UNITY)
        set_target_properties(${target} PROPERTIES UNITY_BUILD ON
            UNITY_BUILD_BATCH_SIZE ${EDGEPROOF_UNITY})
    endif()
endfunction()

# edgeproof_add_units(<target> STATIC|OBJECT <root> <sources> [QUICK]): a library of sources below
# <root>, with the flags above and, in unity builds, one unit for each folder.
function(edgeproof_add_units target kind root sources)
    add_library(${target} ${kind} ${sources})
    edgeproof_own_flags(${target} ${ARGN})
    add_dependencies(${target} include_order)
    if(EDGEPROOF_UNITY)
        edgeproof_units_by_folder(${target} ${root} "${sources}")
    endif()
endfunction()

# edgeproof_add_module(<module> [QUICK] [OPTIMIZED <folders>] [DEPENDS <modules below>]
#                    [LIBS <in its headers>] [PRIVATE_LIBS <in its sources only>])
# QUICK: see edgeproof_own_flags; the folders after OPTIMIZED are compiled without it.
# Adds the static library edgeproof_<module>, alias edgeproof::<module>, of
# src/edgeproof/<module>/*.cpp. A module without sources is an interface library.
function(edgeproof_add_module module)
    cmake_parse_arguments(PARSE_ARGV 1 arg "QUICK" "" "OPTIMIZED;DEPENDS;LIBS;PRIVATE_LIBS")
    set(target edgeproof_${module})
    set(root ${PROJECT_SOURCE_DIR}/src/edgeproof)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${root}/${module}/*.cpp)
    list(FILTER sources EXCLUDE REGEX "/cli/main\\.cpp$")
    list(TRANSFORM arg_DEPENDS PREPEND edgeproof::)
    if(sources)
        set(usage PUBLIC)
        set(quick)
        if(arg_QUICK)
            set(quick QUICK)
        endif()
        set(optimized)
        if(arg_OPTIMIZED)
            list(JOIN arg_OPTIMIZED "|" folders)
            set(optimized ${sources})
            list(FILTER optimized INCLUDE REGEX "/(${folders})/[^/]*$")
            list(REMOVE_ITEM sources ${optimized})
        endif()
        edgeproof_add_units(${target} STATIC ${root} "${sources}" ${quick})
        if(optimized)
            edgeproof_add_units(${target}_optimized OBJECT ${root} "${optimized}")
            target_link_libraries(${target}_optimized PRIVATE ${arg_DEPENDS} ${arg_LIBS})
            target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_optimized>)
        endif()
        target_link_libraries(${target} PRIVATE ${arg_PRIVATE_LIBS})
    else()
        set(usage INTERFACE)
        add_library(${target} INTERFACE)
    endif()
    target_compile_features(${target} ${usage} cxx_std_20)
    target_include_directories(${target} ${usage}
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_libraries(${target} ${usage} ${arg_DEPENDS} ${arg_LIBS})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${module})
    add_library(edgeproof::${module} ALIAS ${target})
    install(TARGETS ${target} EXPORT edgeproof)
endfunction()
