# SPDX-License-Identifier: BSD-3-Clause
# cmake -D SOURCE=<tree> -D WORK=<scratch> -D CXX=<compiler> -P flags.cmake
# A newer compiler may have new warnings, which must not break a user's build. Therefore -Werror is
# in the commands of the preset `ci`, but not in those of `release` or of a configuration without a
# preset; each developer preset sets it. -ffp-contract=off, on which double words depend, is in
# every command of all of them.
function(compiled_with_werror result)
    file(REMOVE_RECURSE ${WORK}/build)
    execute_process(COMMAND ${CMAKE_COMMAND} ${ARGN} -G Ninja -B ${WORK}/build
            -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_EXPORT_COMPILE_COMMANDS=ON -D EDGEPROOF_MPI=OFF
        WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE output ERROR_VARIABLE output
        RESULT_VARIABLE status)
    if(status)
        message(FATAL_ERROR "cmake ${ARGN}: ${status}\n${output}")
    endif()
    file(STRINGS ${WORK}/build/compile_commands.json commands REGEX "\"command\":")
    list(LENGTH commands all)
    set(contracting ${commands})
    list(FILTER contracting EXCLUDE REGEX " -ffp-contract=off ")
    if(contracting)
        message(FATAL_ERROR "cmake ${ARGN}: without -ffp-contract=off:\n${contracting}")
    endif()
    list(FILTER commands INCLUDE REGEX " -Werror")
    list(LENGTH commands strict)
    if(all EQUAL 0)
        message(FATAL_ERROR "cmake ${ARGN}: nothing to compile")
    endif()
    message(STATUS "cmake ${ARGN}: ${strict} of ${all} commands have -Werror")
    set(${result} ${strict}/${all} PARENT_SCOPE)
    set(all ${all} PARENT_SCOPE)
endfunction()

foreach(lenient "--preset;release" "-S;.")
    compiled_with_werror(found ${lenient})
    if(NOT found STREQUAL "0/${all}")
        message(FATAL_ERROR "${found} commands of cmake ${lenient} have -Werror; none should")
    endif()
endforeach()
compiled_with_werror(found --preset ci)
if(NOT found STREQUAL "${all}/${all}")
    message(FATAL_ERROR "${found} commands of preset ci have -Werror; all should")
endif()

file(READ ${SOURCE}/CMakePresets.json presets)
string(JSON count LENGTH "${presets}" configurePresets)
math(EXPR last "${count} - 1")
foreach(i RANGE ${last})
    string(JSON name GET "${presets}" configurePresets ${i} name)
    string(JSON werror ERROR_VARIABLE absent
        GET "${presets}" configurePresets ${i} cacheVariables EDGEPROOF_WERROR)
    if(name MATCHES "^(ci|debug|asan-ubsan|tsan|clang-tidy)$" AND NOT werror STREQUAL "ON")
        message(FATAL_ERROR "preset ${name} does not make warnings errors")
    endif()
endforeach()

file(READ ${SOURCE}/.ci/run ci)
if(NOT ci MATCHES "scripts/test --preset ci")
    message(FATAL_ERROR ".ci/run does not build by the preset ci")
endif()
