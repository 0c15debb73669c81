// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/process.hpp"

#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

/// Runs `f` in a process of its own, because clean_up() must be the last action of a process.
template <class F> int in_a_process(const F& f) {
    const pid_t pid = ::fork();
    if (pid == 0) {
        f();
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(pid, &status, 0);
    return status;
}

pid_t start_shell(const char* command) {
    const pid_t pid = ::fork();
    if (pid == 0) {
        ::setpgid(0, 0);
        ::execl("/bin/sh", "sh", "-c", command, nullptr);
        ::_exit(127);
    }
    ::setpgid(pid, pid);
    return pid;
}

} // namespace

TEST_CASE("clean_up: temporary paths are removed, kept ones remain") {
    const test::Folder own;
    const std::filesystem::path& folder = own.path();
    CHECK(in_a_process([&] {
              std::filesystem::create_directories(folder / "scratch" / "deep");
              std::ofstream(folder / "scratch" / "deep" / "file") << "x";
              std::ofstream(folder / "kept") << "x";
              std::ofstream(folder / "gone before") << "x";
              const TemporaryPath scratch(folder / "scratch");
              TemporaryPath kept(folder / "kept");
              { const TemporaryPath no_longer(folder / "gone before"); }
              {
                  const auto lock = hold_cleanup();
                  kept.keep_locked();
              }
              clean_up();
              ::_exit(0); // a destructor would wait
          }) == 0);
    CHECK_FALSE(std::filesystem::exists(folder / "scratch"));
    CHECK(std::filesystem::exists(folder / "kept"));
    CHECK(std::filesystem::exists(folder / "gone before"));
}

TEST_CASE("clean_up: an incomplete file is removed, a complete one remains") {
    const test::Folder own;
    const std::filesystem::path& folder = own.path();
    CHECK(in_a_process([&] {
              AtomicFile(folder / "done").commit("all");
              const AtomicFile open(folder / "open");
              clean_up();
              ::_exit(0);
          }) == 0);
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        CHECK(entry.path().filename() == "done");
        ++files;
    }
    CHECK(files == 1);
}

TEST_CASE("an interrupted process writes no result") {
    const test::Folder own;
    const std::filesystem::path& folder = own.path();
    request_interruption(SIGTERM);
    {
        AtomicFile result(folder / "result");
        CHECK_THROWS_AS(result.commit("of work cut off"), Interrupted);
    }
    withdraw_interruption();
    CHECK_FALSE(std::filesystem::exists(folder / "result"));
}

TEST_CASE("child programs end with the object, with clean_up(), and with their leader") {
    // The children hold the pipe's other end: the pipe ends when the last child ends.
    std::array<int, 2> ends{};
    REQUIRE(::pipe(ends.data()) == 0);
    {
        const ChildGroup child([] { return start_shell("sleep 100 & sleep 100"); });
        CHECK_FALSE(child.ended());
    }
    CHECK(in_a_process([] {
              const ChildGroup child([] { return start_shell("sleep 100 & sleep 100"); });
              clean_up();
              ::_exit(0); // without destructors
          }) == 0);
    ChildGroup leader([] { return start_shell("sleep 100 & exit 7"); });
    CHECK(WEXITSTATUS(leader.wait()) == 7);
    ::close(ends[1]);
    pollfd end{ends[0], POLLIN, 0};
    CHECK(::poll(&end, 1, 20'000) == 1);
    CHECK((end.revents & POLLHUP) != 0);
    ::close(ends[0]);
}

TEST_CASE("processes that a program leaves behind end with it, also in a session of their own") {
    std::array<int, 2> ends{};
    REQUIRE(::pipe(ends.data()) == 0); // all descendants of the program hold it
    const test::Folder own;
    const std::filesystem::path& folder = own.path();
    // Ends only after the other process has left its group.
    ProgramCall call = shell_call("setsid sh -c 'echo x > started; exec sleep 100' & "
                                  "until test -s started; do sleep 0.01; done");
    call.arguments.back().insert(0, "cd '" + folder.string() + "'; rm -f started; ");
    CHECK(run_program(call).ending().empty());
    // One that has no environment is found as a child of this process.
    CHECK(in_a_process([&] {
              adopt_orphans();
              const std::size_t at = call.arguments.back().find("sh -c");
              call.arguments.back().insert(at, "env -i /bin/");
              ::_exit(run_program(call).ending().empty() ? 0 : 1);
          }) == 0);
    ::close(ends[1]);
    pollfd end{ends[0], POLLIN, 0};
    CHECK(::poll(&end, 1, 20'000) == 1);
    CHECK((end.revents & POLLHUP) != 0);
    ::close(ends[0]);
}
