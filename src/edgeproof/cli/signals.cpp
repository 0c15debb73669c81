// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/report/report.hpp"

#include <fcntl.h>
#include <flint/flint.h>
#include <gmp.h>
#include <stdio_ext.h>
#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>
#include <system_error>
#include <thread>

namespace edgeproof::cli {
namespace {

constexpr int bad_input = 2;
constexpr int signalled = 128;
/// The time for the work to notice the interruption and to report it.
constexpr std::chrono::seconds grace{1};
/// The time for ending children and removing files; if a disk hangs, files remain.
constexpr suseconds_t longest_cleanup_us = 500'000;

std::atomic<int> last_status{bad_input};
/// The main thread, which notices an interruption, and the thread that waits for a second signal
/// may both reach the program's end: the first one gives the reason.
std::atomic<bool> reason_said{false};
std::atomic<bool> reason_written{false};

extern "C" void end_now(int) { ::_exit(last_status); }

void write_error(const char* text) { (void)!::write(STDERR_FILENO, text, std::strlen(text)); }

/// Ends the process without its threads. `line`: the message; empty: the message of an
/// interruption.
[[noreturn]] void end_without_threads(int status, const char* line) {
    last_status = status;
    std::signal(SIGALRM, end_now);
    const itimerval limit{{0, 0}, {0, longest_cleanup_us}};
    ::setitimer(ITIMER_REAL, &limit, nullptr);
    sigset_t alarm;
    sigemptyset(&alarm);
    sigaddset(&alarm, SIGALRM);
    pthread_sigmask(SIG_UNBLOCK, &alarm, nullptr);
    io::clean_up();
    if (reason_said.exchange(true)) {
        while (!reason_written) { // at the latest the alarm ends the process
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        ::_exit(status);
    }
    if (::isatty(STDERR_FILENO) == 1) {
        write_error("\r\033[K"); // clears the line of Progress
    }
    write_error(*line != '\0' ? line : "interrupted");
    write_error("\n");
    ::_exit(status);
}

sigset_t ending_signals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    struct sigaction hangup {};
    if (::sigaction(SIGHUP, nullptr, &hangup) == 0 && hangup.sa_handler != SIG_IGN) {
        sigaddset(&set, SIGHUP);
    }
    return set;
}

void wait_for_signals(const sigset_t& set) {
    int signal = 0;
    while (sigwait(&set, &signal) != 0) {
    }
    request_interruption(signal);
    const auto last = std::chrono::steady_clock::now() + grace;
    for (auto left = std::chrono::nanoseconds(grace); left.count() > 0;
         left = last - std::chrono::steady_clock::now()) {
        const auto whole = std::chrono::duration_cast<std::chrono::seconds>(left);
        const timespec time{static_cast<time_t>(whole.count()),
                            static_cast<long>((left - whole).count())};
        if (sigtimedwait(&set, nullptr, &time) > 0) {
            break;
        }
    }
    end_without_threads(interrupted_status(), "");
}

/// Runs once: an abort while the process already ends must not come back here.
[[noreturn]] void give_up(const char* line) {
    static std::atomic<bool> begun{false};
    if (begun.exchange(true)) {
        ::_exit(interruption_requested() != 0 ? interrupted_status() : bad_input);
    }
    // FLINT has written a line of its own to stdout.
    __fpurge(stdout);
    end_without_threads(bad_input, line);
}

constexpr const char* no_memory =
    "edgeproof: out of memory; ask for fewer digits, points or scenes";
constexpr const char* beyond_library =
    "edgeproof: a number grows beyond what the arithmetic libraries can hold; ask for fewer "
    "digits, or for smaller exponents";

// FLINT's parameter has this type for clang; [[noreturn]] is not a part of it.
__attribute__((noreturn)) void on_flint_abort() { give_up(beyond_library); }
extern "C" void on_abort(int) {
    give_up(
        "edgeproof: stopped inside a library, as a rule by a number beyond what it can hold; ask "
        "for fewer digits");
}
[[noreturn]] void on_terminate() {
    static std::string line;
    line = "edgeproof: stopped by an error inside";
    try {
        if (const auto error = std::current_exception()) {
            std::rethrow_exception(error);
        }
    } catch (const Interrupted& e) {
        line = e.what();
    } catch (const std::bad_alloc&) {
        line = no_memory;
    } catch (const std::exception& e) {
        line = std::string("edgeproof: ") + e.what();
    } catch (...) {
    }
    if (interruption_requested() != 0) {
        end_without_threads(interrupted_status(), "");
    }
    give_up(line.c_str());
}

// GMP's own functions would print a line and abort.
void* allocate(std::size_t size) {
    void* const memory = std::malloc(size);
    if (memory == nullptr) {
        give_up(no_memory);
    }
    return memory;
}
void* reallocate(void* old, std::size_t, std::size_t size) {
    void* const memory = std::realloc(old, size);
    if (memory == nullptr) {
        give_up(no_memory);
    }
    return memory;
}
void release(void* memory, std::size_t) { std::free(memory); }

} // namespace

int interrupted_status() {
    const int signal = interruption_requested();
    return signalled + (signal != 0 ? signal : SIGTERM);
}

void say_at_the_end(const std::string& line) {
    if (reason_said.exchange(true)) {
        for (;;) {
            ::pause();
        }
    }
    wipe_progress();
    std::fprintf(stderr, "%s\n", line.c_str());
    reason_written = true;
}

void open_standard_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) < 0) { // open() takes the lowest free number: this stream's
            (void)!::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        }
    }
}

void take_signals() {
    io::adopt_orphans();
    const sigset_t set = ending_signals();
    for (const int signal : {SIGINT, SIGTERM}) {
        std::signal(signal,
                    SIG_DFL); // a shell starts background programs with SIGINT ignored
    }
    sigset_t before;
    pthread_sigmask(SIG_BLOCK, &set, &before);
    try {
        std::thread([set] { wait_for_signals(set); }).detach();
    } catch (const std::system_error&) { // no more threads: the signals keep their default action
        pthread_sigmask(SIG_SETMASK, &before, nullptr);
    }
}

void take_aborts() {
    std::set_terminate(on_terminate);
    mp_set_memory_functions(allocate, reallocate, release);
    flint_set_abort(on_flint_abort);
    std::signal(SIGABRT, on_abort);
}

} // namespace edgeproof::cli
