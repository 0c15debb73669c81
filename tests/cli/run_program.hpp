// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/support/folder.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/paths.hpp"

#include <doctest/doctest.h>

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

/// Runs the program as a user does.
namespace edgeproof::test {

struct Outcome {
    int code = -1;
    std::string out;
    std::string err;
};

/// Copies the files of tests/cli/files into the folder.
inline void copy_files(const Folder& folder) {
    std::filesystem::copy(source_dir() / "tests" / "cli" / "files", folder.path(),
                          std::filesystem::copy_options::overwrite_existing |
                              std::filesystem::copy_options::recursive);
}

/// The program, for a command of a shell.
inline std::string called(const std::string& arguments) {
    return "'" + program().string() + "' " + arguments;
}

/// True if a command of the machine succeeds; a test says that it leaves out what needs it.
inline bool shell_has(const char* command) {
    const bool there = std::system((std::string(command) + " >/dev/null 2>&1").c_str()) == 0;
    if (!there) {
        MESSAGE("skipped: not here: ", std::string(command));
    }
    return there;
}

/// Runs a shell command in the folder. A file that it redirects to standard input comes after
/// /dev/null, and counts. Standard error goes through a pipe: a limit on files does not apply to
/// it.
inline Outcome in_shell(const Folder& folder, const std::string& command) {
    const Folder aside;
    const std::string all = "cd '" + folder.path().string() + "' && { ( " + command + "\n) >'" +
                            (aside.path() / "out").string() + "'; echo $? >'" +
                            (aside.path() / "code").string() + "'; } 2>&1 </dev/null | cat >'" +
                            (aside.path() / "err").string() + "'";
    (void)std::system(all.c_str());
    return {std::stoi(file_text(aside.path() / "code")), file_text(aside.path() / "out"),
            file_text(aside.path() / "err")};
}

/// Runs `edgeproof ARGUMENTS` in `folder` (the shell splits the arguments).
inline Outcome run(const Folder& folder, const std::string& arguments) {
    const Folder aside;
    // A file that the arguments redirect to standard input comes after /dev/null, and counts.
    const std::string command = "cd '" + folder.path().string() + "' && '" + program().string() +
                                "' </dev/null " + arguments + " >'" +
                                (aside.path() / "out").string() + "' 2>'" +
                                (aside.path() / "err").string() + "'";
    const int status = std::system(command.c_str());
    Outcome outcome;
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    outcome.out = file_text(aside.path() / "out");
    outcome.err = file_text(aside.path() / "err");
    return outcome;
}

} // namespace edgeproof::test
