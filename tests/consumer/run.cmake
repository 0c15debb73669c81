# SPDX-License-Identifier: BSD-3-Clause
# cmake -D BUILD=<build> -D WORK=<scratch> -D CXX=<compiler> -D SANITIZE=<as the build>
#       -D EXAMPLES=<folder of the build's examples> -P run.cmake
# Installs the build into a scratch folder, builds the project in this folder against it, runs it,
# and compares its output with expected.txt. The installed examples are also built and run there,
# and must print the same as those of the build, which test_cli checks.
set(COMPILE_OPTIONS "")
if(SANITIZE)
    set(COMPILE_OPTIONS "-fsanitize=${SANITIZE}")
endif()

function(run)
    execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output
        RESULT_VARIABLE status)
    if(status)
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "${command}: ${status}\n${output}")
    endif()
endfunction()

# Builds a project against the installed package.
function(build_outside source name)
    run(${CMAKE_COMMAND} -G Ninja -S ${source} -B ${WORK}/${name}
        -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_CXX_FLAGS=${COMPILE_OPTIONS}
        -D CMAKE_PREFIX_PATH=${WORK}/installed -D CMAKE_EXPORT_COMPILE_COMMANDS=ON)
    run(${CMAKE_COMMAND} --build ${WORK}/${name})
endfunction()
function(expect_output program expected)
    execute_process(COMMAND ${WORK}/${program} OUTPUT_VARIABLE printed RESULT_VARIABLE status)
    if(status OR expected STREQUAL "" OR NOT printed STREQUAL expected)
        message(FATAL_ERROR "${program} (exit ${status}) printed\n${printed}instead of\n${expected}")
    endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed)
set(here ${CMAKE_CURRENT_LIST_DIR})
build_outside(${here} build)
file(READ ${WORK}/build/compile_commands.json commands)
if(NOT commands MATCHES " -ffp-contract=off ")
    message(FATAL_ERROR "what double words rest on is not passed on: ${commands}")
endif()
file(READ ${here}/expected.txt expected)
expect_output(build/consumer "${expected}")

# The examples name one module, several, or none (edgeproof::edgeproof).
build_outside(${WORK}/installed/share/edgeproof/examples/cpp examples)
foreach(example proved_pressure coefficients extent table_in_threads ledger)
    execute_process(COMMAND ${EXAMPLES}/${example} OUTPUT_VARIABLE inside)
    expect_output(examples/${example} "${inside}")
endforeach()

# The installed files must not contain a path of the source or build tree.
file(GLOB_RECURSE configs ${WORK}/installed/*.cmake)
foreach(config IN LISTS configs)
    file(READ ${config} text)
    cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH tests)
    cmake_path(GET tests PARENT_PATH source)
    string(FIND "${text}" "${source}/" found)
    if(NOT found EQUAL -1)
        message(FATAL_ERROR "${config} names the source tree ${source}")
    endif()
endforeach()
message(STATUS "the installed package works")
