# SPDX-License-Identifier: BSD-3-Clause

# edgeproof_embed_files(<target> NAMESPACE <ns> HEADER <declares them> FILES <files>...)
# Adds each file as a `const std::string_view <name>_<extension>` in edgeproof::<ns>, in a source
# that is made when a file changes, so that the program needs no data folder.
function(edgeproof_embed_files target)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "NAMESPACE;HEADER" "FILES")
    list(TRANSFORM arg_FILES PREPEND ${PROJECT_SOURCE_DIR}/)
    string(MAKE_C_IDENTIFIER "${arg_NAMESPACE}" name)
    set(output ${PROJECT_BINARY_DIR}/embedded/${name}.cpp)
    set(script ${PROJECT_SOURCE_DIR}/cmake/embed.cmake)
    add_custom_command(OUTPUT ${output}
        COMMAND ${CMAKE_COMMAND} -D OUTPUT=${output} -D NAMESPACE=${arg_NAMESPACE}
            -D HEADER=${arg_HEADER} -D "FILES=${arg_FILES}" -P ${script}
        DEPENDS ${arg_FILES} ${script} VERBATIM)
    target_sources(${target} PRIVATE ${output})
endfunction()
