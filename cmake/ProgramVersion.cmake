# SPDX-License-Identifier: BSD-3-Clause

# edgeproof_add_version(<target>)
# Adds a source with the version and the commit. Every build checks it, and compiles it if one of
# them has changed: only this small file depends on the commit.
function(edgeproof_add_version target)
    find_package(Git QUIET)
    set(output ${PROJECT_BINARY_DIR}/program_version.cpp)
    add_custom_target(program_version BYPRODUCTS ${output}
        COMMAND ${CMAKE_COMMAND} -D SOURCE=${CMAKE_CURRENT_FUNCTION_LIST_DIR}/.. -D VERSION=${PROJECT_VERSION}
            -D OUTPUT=${output} -D GIT=${GIT_EXECUTABLE}
            -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/program_version.cmake
        COMMENT "The version and the commit" VERBATIM)
    set_source_files_properties(${output} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    target_sources(${target} PRIVATE ${output})
    add_dependencies(${target} program_version)
endfunction()
