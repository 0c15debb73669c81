# SPDX-License-Identifier: BSD-3-Clause
# cmake -D SOURCE=<tree> -D WORK=<scratch> -D GIT=<git, or nothing> -P program_version.cmake
# Checks the commit in a build: an archive's, else git's (and whether files differ from it), else
# none. The source that contains it is written only if it changes.
set(script ${SOURCE}/cmake/program_version.cmake)
set(made ${WORK}/made.cpp)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/tree/cmake)

function(expect commit)
    execute_process(COMMAND ${CMAKE_COMMAND} -D SOURCE=${WORK}/tree -D VERSION=1.2.3
        -D OUTPUT=${made} -D GIT=${GIT} -P ${script} COMMAND_ERROR_IS_FATAL ANY)
    file(READ ${made} text)
    if(NOT text MATCHES "program_version = \"1.2.3\";" OR NOT text MATCHES
            "program_commit = \"${commit}\";")
        message(FATAL_ERROR "instead of the commit '${commit}':\n${text}")
    endif()
endfunction()

file(WRITE ${WORK}/tree/cmake/commit.txt "0123abcd\n")
expect("0123abcd")
file(WRITE ${WORK}/tree/cmake/commit.txt "$Format:%h$\n")
expect("")
file(TIMESTAMP ${made} before "%s.%f")
execute_process(COMMAND ${CMAKE_COMMAND} -E sleep 0.02)
expect("")
file(TIMESTAMP ${made} after "%s.%f")
if(NOT before STREQUAL after)
    message(FATAL_ERROR "the same commit is written again")
endif()
if(NOT GIT)
    message(STATUS "no git here: its part is left out")
    return()
endif()

function(git)
    execute_process(COMMAND ${GIT} -c user.name=a -c user.email=a@b ${ARGN}
        WORKING_DIRECTORY ${WORK}/tree OUTPUT_VARIABLE said OUTPUT_STRIP_TRAILING_WHITESPACE
        ERROR_VARIABLE ignored COMMAND_ERROR_IS_FATAL ANY)
    set(said "${said}" PARENT_SCOPE)
endfunction()
git(init)
configure_file(${SOURCE}/.gitattributes ${WORK}/tree/.gitattributes COPYONLY)
git(add .)
git(commit -m first)
git(rev-parse --short=12 HEAD)
expect("${said}")
file(WRITE ${WORK}/tree/cmake/other.txt "not tracked\n")
expect("${said}")
file(WRITE ${WORK}/tree/cmake/commit.txt "$Format:%H$ \n")
expect("${said}-modified")
git(checkout cmake/commit.txt)
git(rev-parse --short HEAD)
set(short ${said})
git(archive --output=${WORK}/archive.tar HEAD)
file(REMOVE_RECURSE ${WORK}/tree)
file(ARCHIVE_EXTRACT INPUT ${WORK}/archive.tar DESTINATION ${WORK}/tree)
expect("${short}")
