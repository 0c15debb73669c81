# SPDX-License-Identifier: GPL-3.0-or-later
# Writes OUTPUT, a C++ source that contains the text of FILES, and the table TABLE if it is given;
# see EmbedFiles.cmake.
set(source "// Made by cmake/embed.cmake.\n#include \"${HEADER}\"\n\nnamespace edgeproof::${NAMESPACE} {\n")
foreach(file IN LISTS FILES)
    file(READ "${file}" text)
    if(text MATCHES "\\)embedded\"")
        message(FATAL_ERROR "${file} holds the end mark of a raw string")
    endif()
    cmake_path(GET file FILENAME name)
    set(file_name "${name}")
    string(MAKE_C_IDENTIFIER "${name}" name)
    string(APPEND source "const std::string_view ${name} = R\"embedded(${text})embedded\";\n")
    string(APPEND table "    {\"${file_name}\", ${name}},\n")
endforeach()
if(TABLE)
    set(type "std::pair<std::string_view, std::string_view>")
    string(APPEND source "static const ${type} all_files[] = {\n${table}};\n"
        "const std::span<const ${type}> ${TABLE}(all_files);\n")
endif()
string(APPEND source "} // namespace edgeproof::${NAMESPACE}\n")
file(WRITE "${OUTPUT}" "${source}")
