# SPDX-License-Identifier: BSD-3-Clause
# Writes OUTPUT, a C++ source that contains the text of FILES; see EmbedFiles.cmake.
set(source "// Made by cmake/embed.cmake.\n#include \"${HEADER}\"\n\nnamespace edgeproof::${NAMESPACE} {\n")
foreach(file IN LISTS FILES)
    file(READ "${file}" text)
    if(text MATCHES "\\)embedded\"")
        message(FATAL_ERROR "${file} holds the end mark of a raw string")
    endif()
    cmake_path(GET file FILENAME name)
    string(MAKE_C_IDENTIFIER "${name}" name)
    string(APPEND source "const std::string_view ${name} = R\"embedded(${text})embedded\";\n")
endforeach()
string(APPEND source "} // namespace edgeproof::${NAMESPACE}\n")
file(WRITE "${OUTPUT}" "${source}")
