// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/cli.hpp"

#include <flint/flint.h>
#include <sys/types.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>

struct rusage;
/// There are no child processes, and Emscripten's library does not have this function.
extern "C" pid_t wait4(pid_t, int*, int, rusage*) {
    errno = ECHILD;
    return -1;
}

/// The end of the program in a browser, instead of src/edgeproof/cli/signals.cpp: there are no
/// signals and no second thread; the page stops a computation by ending its worker.
namespace edgeproof::cli {
namespace {

constexpr int bad_input = 2;

__attribute__((noreturn)) void on_flint_abort() {
    say_at_the_end("edgeproof: a number grows beyond what the arithmetic libraries can hold; ask "
                   "for fewer digits, or for smaller exponents");
    std::exit(bad_input);
}

} // namespace

void say_at_the_end(const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); }

int interrupted_status() { return bad_input; }

void take_aborts() { flint_set_abort(on_flint_abort); }

} // namespace edgeproof::cli
