# SPDX-License-Identifier: BSD-3-Clause
# cmake -D SOURCE=<source tree> -D VERSION=<version> -D OUTPUT=<C++ source> [-D GIT=<git>] -P ...
# Writes the version and the commit as a C++ source, if they differ from those in it. The commit is
# that of a release's archive (cmake/commit.txt, .gitattributes), else git's; else none.
file(STRINGS ${SOURCE}/cmake/commit.txt commit LIMIT_COUNT 1)
if(commit MATCHES "Format")
    set(commit "")
    if(GIT AND EXISTS ${SOURCE}/.git)
        set(ENV{GIT_OPTIONAL_LOCKS} 0)
        execute_process(
            COMMAND ${GIT} describe --always --abbrev=12 --exclude=* --dirty=-modified
            WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE commit ERROR_QUIET
            OUTPUT_STRIP_TRAILING_WHITESPACE)
    endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
// Made by cmake/program_version.cmake.
#include "edgeproof/report/text/program_line.hpp"

namespace edgeproof::report {
const std::string_view program_version = "@VERSION@";
const std::string_view program_commit = "@commit@";
} // namespace edgeproof::report
]])
