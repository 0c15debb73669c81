// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/process.hpp"

#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/error.hpp"
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

/// A pipe that all processes hold which are started after it; it ends when the last of them ends.
class HeldPipe {
public:
    HeldPipe() { REQUIRE(::pipe(ends_.data()) == 0); }
    ~HeldPipe() { ::close(ends_[0]); }
    HeldPipe(const HeldPipe&) = delete;
    HeldPipe& operator=(const HeldPipe&) = delete;
    void check_all_ended() {
        ::close(ends_[1]);
        pollfd end{ends_[0], POLLIN, 0};
        CHECK(::poll(&end, 1, 20'000) == 1);
        CHECK((end.revents & POLLHUP) != 0);
    }

private:
    std::array<int, 2> ends_{};
};

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

TEST_CASE("an interrupted process writes no result") {
    const test::Folder own;
    const std::filesystem::path& folder = own.path();
    request_interruption(SIGTERM);
    CHECK_THROWS_AS(write_whole(folder / "result", "of work cut off"), Interrupted);
    withdraw_interruption();
    CHECK_FALSE(std::filesystem::exists(folder / "result"));
}

TEST_CASE("child programs end with the object, with clean_up(), and with their leader") {
    HeldPipe children;
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
    children.check_all_ended();
}

TEST_CASE("processes that a program leaves behind end with it, also in a session of their own") {
    HeldPipe descendants;
    for (const char* left :
         {"sleep 1000 &", "(sleep 1000 &)", "(sleep 1000 </dev/null >/dev/null 2>&1 &)",
          "(trap '' HUP TERM INT; sleep 1000) &"}) {
        CAPTURE(left);
        CHECK(run_program(shell_call(left)).ending().empty());
    }
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
    descendants.check_all_ended();
}

TEST_CASE("a program: its standard error is handed on or dropped, and never stops it") {
    ProgramCall call = shell_call("head -c 3000000 /dev/zero >&2; echo done");
    CHECK(run_program(call).output == "done\n");
    std::size_t bytes = 0;
    call.said = [&](std::string_view text) { bytes += text.size(); };
    CHECK(run_program(call).output == "done\n");
    CHECK(bytes == 3'000'000);
    call = shell_call("cat /dev/zero >&2");
    call.seconds = 0.3;
    CHECK(run_program(call).timed_out);
    call = shell_call("exec cat");
    call.input = std::string(5'000'000, 'x');
    CHECK(run_program(call).output == call.input);
    call.most_output = 1000;
    const ProgramRun cut = run_program(call);
    CHECK(cut.too_much);
    CHECK(cut.output == std::string(1000, 'x'));
    call.arguments = {"/nowhere/at/all"};
    CHECK_THROWS_AS((void)run_program(call), Error);
}
