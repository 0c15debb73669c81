// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/cli.hpp"

#include "edgeproof/precision/interruption.hpp"
#include "tests/cli/inputs.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/table.hpp"

#include <doctest/doctest.h>
#include <flint/flint.h>
#include <gmp.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace edgeproof::test;

namespace {

/// Returns the outcome of `f` in a process of its own.
Outcome in_a_process(const std::function<void()>& f) {
    const Folder folder;
    const std::string out = folder.path() / "out";
    const std::string err = folder.path() / "err";
    std::fflush(stdout);
    const pid_t pid = ::fork();
    if (pid == 0) {
        ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
        ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
        cli::take_aborts();
        f();
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(pid, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, file_text(out), file_text(err)};
}

} // namespace

TEST_CASE("an abort in a library, or an uncaught exception: one line, exit status 2") {
    struct Abort {
        const char* name;
        std::function<void()> run;
        const char* says;
    };
    const std::vector<Abort> all{
        {"abort", [] { std::abort(); }, "stopped inside a library"},
        {"FLINT", [] { flint_abort(); }, "beyond what the arithmetic libraries can hold"},
        {"GMP, no memory",
         [] {
             const rlimit little{1UL << 30U, 1UL << 30U};
             ::setrlimit(RLIMIT_AS, &little);
             mpz_t z;
             mpz_init(z);
             mpz_setbit(z, 1UL << 36U);
         },
         "out of memory"},
        {"an exception in a thread",
         [] { std::thread([] { throw std::runtime_error("what was wrong"); }).join(); },
         "what was wrong"},
        {"an interruption in a thread", [] { std::thread([] { throw Interrupted(); }).join(); },
         "interrupted"},
        {"no memory", [] { std::thread([] { throw std::bad_alloc(); }).join(); }, "out of memory"},
    };
    for (const Abort& a : all) {
        CAPTURE(a.name);
        const Outcome o = in_a_process(a.run);
        CHECK(o.code == 2);
        CHECK(o.out.empty());
        CAPTURE(o.err);
        CHECK(lines(o.err).size() == 1);
        CHECK(has(o.err, a.says));
    }
}

TEST_CASE(
    "signals end a program that never checks for them; a signal that nohup ignores does not") {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        CAPTURE(signal);
        const Outcome o = in_a_process([signal] {
            std::signal(SIGHUP, SIG_DFL);
            cli::take_signals();
            ::kill(::getpid(), signal);
            ::pause();
        });
        CHECK(o.code == 128 + signal);
        CHECK(o.err == "interrupted\n");
    }
    const Outcome ignored = in_a_process([] {
        std::signal(SIGHUP, SIG_IGN);
        cli::take_signals();
        ::kill(::getpid(), SIGHUP);
        ::usleep(50'000);
    });
    CHECK(ignored.code == 0);
}

TEST_CASE("deep, long and huge formulas: an answer or one line, never a crash") {
    const std::vector<std::string> formulas{
        repeated("(", 100'000) + "x" + repeated(")", 100'000),
        repeated("(", 199) + "x" + repeated(")", 199),
        repeated("1+", 1'000'000) + "1",
        repeated("x+", 5'000) + "x",
        repeated("-", 199) + "x",
        repeated("2^", 150) + "2",
        "2^(2^(2^64))",
        "exp(exp(exp(100)))",
        "gamma(10^30)",
        "x^(10^18)",
        "(x+Pi)^(10^30)",
        "10^-100000*x",
        "((((10^1000)^100)^10)^10)*x",
        "sinh(10^30)",
        repeated("1", 19'000),
    };
    for (const std::string& f : formulas) {
        const Folder folder;
        folder.write("own.toml", hertz_head + hertz_claim("c", f));
        const Outcome o = run(folder, "verify own.toml --digits 20");
        CAPTURE(f.substr(0, 60));
        CHECK(o.code >= 0); // no signal ended it
        CHECK(o.code <= 2);
        CHECK(lines(o.err).size() <= 1);
    }
}
