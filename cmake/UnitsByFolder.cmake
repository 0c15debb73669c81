# SPDX-License-Identifier: BSD-3-Clause

# edgeproof_units_by_folder(<target> <root> <sources>): compiles the sources of each folder below
# <root> as one unit, so that local names of different folders do not collide.
function(edgeproof_units_by_folder target root sources)
    foreach(source IN LISTS sources)
        cmake_path(GET source PARENT_PATH folder)
        cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${root})
        string(MAKE_C_IDENTIFIER "${folder}" folder)
        set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder})
    endforeach()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
