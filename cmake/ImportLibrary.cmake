# SPDX-License-Identifier: BSD-3-Clause
# import_library(<Package> HEADER <file> LIBRARY <names...>): the body of the find modules in this
# folder. Makes the imported target <Package>::<Package>; its headers count as system headers.
function(import_library package)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "HEADER" "LIBRARY")
    find_path(${package}_INCLUDE_DIR ${arg_HEADER})
    find_library(${package}_LIBRARY NAMES ${arg_LIBRARY})
    mark_as_advanced(${package}_INCLUDE_DIR ${package}_LIBRARY)
    find_package_handle_standard_args(${package}
        REQUIRED_VARS ${package}_LIBRARY ${package}_INCLUDE_DIR)
    set(${package}_FOUND ${${package}_FOUND} PARENT_SCOPE)
    if(${package}_FOUND AND NOT TARGET ${package}::${package})
        add_library(${package}::${package} UNKNOWN IMPORTED)
        set_target_properties(${package}::${package} PROPERTIES
            IMPORTED_LOCATION "${${package}_LIBRARY}"
            INTERFACE_INCLUDE_DIRECTORIES "${${package}_INCLUDE_DIR}")
    endif()
endfunction()
