# SPDX-License-Identifier: GPL-3.0-or-later

# What every target of this build shares, and no installed target passes on (but -ffp-contract=off,
# which edgeproof_precision does).
function(edgeproof_own_flags target)
    target_compile_features(${target} PRIVATE cxx_std_20)
    # GNU extensions: Boost offers __float128 only with them.
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS ON)
    target_compile_options(${target} PRIVATE
        -Wall -Wextra -Wpedantic -Wshadow -Wconversion $<$<BOOL:${EDGEPROOF_WERROR}>:-Werror>)
    # Double words rest on each product and sum being rounded by itself. In every source: of an
    # inline function the linker keeps anyone's copy.
    target_compile_options(${target} PRIVATE -ffp-contract=off)
    # GCC 12 warns of copies in std::string, inlined, that cannot overlap or overrun (its bugs
    # 105651, 105329 and the like). The alarm comes and goes with inlining; the sanitizers watch
    # instead.
    target_compile_options(${target} PRIVATE
        "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict;-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread>")
    # So does GCC 14 of a string's move and of its copies, in tests.
    target_compile_options(${target} PRIVATE
        "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,13>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,15>>:-Wno-array-bounds;-Wno-stringop-overflow>")
    if(EDGEPROOF_PYTHON_BUILT)
        # The libraries become part of a shared one. Of everything, since a precompiled header is
        # that of all targets.
        target_compile_options(${target} PRIVATE -fPIC)
    endif()
    if(EDGEPROOF_SANITIZE)
        # GCC 12 takes what the sanitizers add to <regex> for uninitialized (its bug 105562).
        target_compile_options(${target} PRIVATE
            $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    endif()
    if(EDGEPROOF_PCH)
        if(target STREQUAL "edgeproof_precision")
            target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp)
        elseif(target STREQUAL "edgeproof_cli")
            # CLI11 is all header, and every source of the module includes it.
            target_precompile_headers(${target} PRIVATE
                ${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp <CLI/CLI.hpp>)
        else()
            target_precompile_headers(${target} REUSE_FROM edgeproof_precision)
        endif()
    endif()
    if(EDGEPROOF_UNITY)
        set_target_properties(${target} PROPERTIES UNITY_BUILD ON
            UNITY_BUILD_BATCH_SIZE ${EDGEPROOF_UNITY})
    endif()
endfunction()

# edgeproof_add_module(<module> [DEPENDS <modules below>] [LIBS <in its headers>]
#                    [PRIVATE_LIBS <in its sources only>])
# The static library edgeproof_<module>, alias edgeproof::<module>, of src/edgeproof/<module>/*.cpp.
# A module of headers alone is an interface library.
function(edgeproof_add_module module)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "DEPENDS;LIBS;PRIVATE_LIBS")
    set(target edgeproof_${module})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS src/edgeproof/${module}/*.cpp)
    list(FILTER sources EXCLUDE REGEX "/cli/main\\.cpp$")
    list(TRANSFORM arg_DEPENDS PREPEND edgeproof::)
    if(sources)
        set(usage PUBLIC)
        add_library(${target} STATIC ${sources})
        edgeproof_own_flags(${target})
        if(EDGEPROOF_UNITY)
            # Folder by folder, so that local names are apart in different folders.
            foreach(source IN LISTS sources)
                cmake_path(GET source PARENT_PATH folder)
                cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/src/edgeproof)
                string(MAKE_C_IDENTIFIER "${folder}" folder)
                set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder})
            endforeach()
            set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
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
    add_dependencies(${target} include_order)
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${module})
    add_library(edgeproof::${module} ALIAS ${target})
    install(TARGETS ${target} EXPORT edgeproof)
endfunction()
