# SPDX-License-Identifier: BSD-3-Clause
# Fails if a file of src/edgeproof includes a header of a folder that folders.txt lists after
# its own; see IncludeOrder.cmake. A module's own header, <module>/<module>.hpp, may include all of
# the module. The Python module includes edgeproof.hpp and nothing else of the project, the command
# line that one and report.
file(STRINGS ${SOURCE}/src/edgeproof/folders.txt folders REGEX "^[a-z]")
list(TRANSFORM folders REPLACE " .*" "")
file(GLOB_RECURSE files RELATIVE ${SOURCE} ${SOURCE}/src/edgeproof/*.cpp
    ${SOURCE}/src/edgeproof/*.hpp)
list(REMOVE_ITEM files src/edgeproof/edgeproof.hpp) # it includes only errors and interruption
set(wrong "")
foreach(file IN LISTS files)
    string(REGEX REPLACE "^src/edgeproof/" "" place "${file}")
    cmake_path(GET place PARENT_PATH folder)
    list(FIND folders "${folder}" own)
    if(own LESS 0)
        string(APPEND wrong "${file}: folders.txt does not name its folder\n")
        continue()
    endif()
    if(place STREQUAL "${folder}/${folder}.hpp")
        continue()
    endif()
    file(STRINGS ${SOURCE}/${file} includes REGEX "^#include \"edgeproof/")
    foreach(include IN LISTS includes)
        string(REGEX REPLACE "^#include \"(edgeproof/)?([^\"]+)\".*" "\\2" included "${include}")
        cmake_path(GET included PARENT_PATH folder)
        list(FIND folders "${folder}" other)
        if((place MATCHES "^python/" AND NOT included MATCHES "^(edgeproof.hpp$|python/)") OR
                (place MATCHES "^cli/" AND NOT place STREQUAL "cli/main.cpp" AND NOT included MATCHES "^(edgeproof.hpp$|cli/|report/)"))
            string(APPEND wrong "${file}: includes ${included}, which lies behind edgeproof.hpp\n")
        endif()
        if((other LESS 0 OR other GREATER own) AND NOT place STREQUAL "cli/main.cpp"
                AND NOT included STREQUAL "edgeproof.hpp")
            string(APPEND wrong "${file}: includes ${included}, of a folder above\n")
        endif()
    endforeach()
endforeach()
if(wrong)
    message(FATAL_ERROR "Includes are to point down (src/edgeproof/folders.txt):\n${wrong}")
endif()
file(TOUCH ${STAMP})
