// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/child_process.hpp"

#include "edgeproof/io/process_cleanup.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>

extern char** environ; // NOLINT: POSIX names it so

namespace edgeproof::io {
namespace {

constexpr int look_every_ms = 100;
constexpr int look_for_the_end_every_ms = 2;
constexpr std::size_t most_bytes_at_once = 1'000'000; // bytes read before the time is checked

struct Descriptor {
    int fd = -1;

    Descriptor() = default;
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { close(); }
    void close() {
        if (fd >= 0) {
            ::close(fd);
        }
        fd = -1;
    }
};

struct Pipe {
    Descriptor read;
    Descriptor write;

    Pipe() {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
            throw Error(std::string("cannot make a pipe: ") + std::strerror(errno));
        }
        read.fd = ends[0];
        write.fd = ends[1];
    }
};

/// A file without a name that contains the text, at its beginning.
std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_with(const std::string& text) {
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), &std::fclose);
    if (file == nullptr || std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() ||
        std::fflush(file.get()) != 0 || ::lseek(::fileno(file.get()), 0, SEEK_SET) != 0) {
        throw Error(std::string("cannot write the input of a program: ") + std::strerror(errno));
    }
    return file;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    pointers.reserve(texts.size() + 1);
    for (std::string& text : texts) {
        pointers.push_back(text.data());
    }
    pointers.push_back(nullptr);
    return pointers;
}

std::vector<std::string> own_environment() {
    std::vector<std::string> variables;
    for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable) {
        variables.emplace_back(*variable);
    }
    return variables;
}

/// Starts the program in a process group of its own, with no signal blocked or ignored.
pid_t start(const ProgramCall& call, const std::string& mark, int in, int out, int err) {
    std::vector<std::string> arguments = call.arguments;
    std::vector<std::string> environment = own_environment();
    environment.push_back(mark);
    const std::vector<char*> argv = pointers_to(arguments);
    const std::vector<char*> variables = pointers_to(environment);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, err, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    sigset_t usual;
    sigemptyset(&usual);
    for (const int signal : {SIGPIPE, SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
        sigaddset(&usual, signal);
    }
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK |
                                              POSIX_SPAWN_SETSIGDEF);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    pid_t pid = 0;
    const int failed =
        ::posix_spawn(&pid, argv.front(), &actions, &attributes, argv.data(), variables.data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) {
        throw Error("cannot start " + call.arguments.front() + ": " + std::strerror(failed));
    }
    return pid;
}

/// Passes on the available output, up to most_bytes_at_once, without waiting. Returns false at the
/// end.
template <class Take> bool drain(int fd, const Take& take) {
    std::array<char, 65536> buffer{};
    for (std::size_t taken = 0; taken < most_bytes_at_once;) {
        const ssize_t n = ::read(fd, buffer.data(), buffer.size());
        if (n > 0) {
            taken += static_cast<std::size_t>(n);
            take(std::string_view(buffer.data(), static_cast<std::size_t>(n)));
        } else if (n < 0 && errno == EAGAIN) {
            return true;
        } else if (n == 0 || errno != EINTR) {
            return false;
        }
    }
    return true;
}

} // namespace

std::string ProgramRun::ending() const {
    if (timed_out) {
        return "was stopped: it took longer than --timeout allows";
    }
    if (too_much) {
        return "was stopped: it wrote without end";
    }
    if (signal != 0) {
        return "was ended by signal " + std::to_string(signal) + " (" + ::strsignal(signal) + ")";
    }
    return exit_code != 0 ? "ended with exit code " + std::to_string(exit_code) : "";
}

ProgramCall shell_call(const std::string& command) {
    ProgramCall call;
    call.arguments = {"/bin/sh", "-c", command};
    return call;
}

ProgramRun run_program(const ProgramCall& call) {
    using Clock = std::chrono::steady_clock;
    const auto begun = Clock::now();
    const auto late = [&] {
        return std::chrono::duration<double>(Clock::now() - begun).count() >= call.seconds;
    };
    const auto input = file_with(call.input);
    Pipe out;
    Pipe err;
    ProgramRun run;
    const std::string mark = new_mark();
    ChildGroup child(
        [&] { return start(call, mark, ::fileno(input.get()), out.write.fd, err.write.fd); }, mark);
    out.write.close();
    err.write.close();
    for (const int fd : {out.read.fd, err.read.fd}) {
        ::fcntl(fd, F_SETFL, O_NONBLOCK);
    }
    const auto keep = [&](std::string_view text) {
        const std::size_t space = call.most_output - run.output.size();
        run.output.append(text.substr(0, space));
        run.too_much = run.too_much || text.size() > space;
    };
    const auto hand_on = [&](std::string_view text) {
        if (call.said) {
            call.said(text);
        }
    };
    const auto listen = [&] {
        if (out.read.fd >= 0 && !drain(out.read.fd, keep)) {
            out.read.close();
        }
        if (err.read.fd >= 0 && !drain(err.read.fd, hand_on)) {
            err.read.close();
        }
    };
    while (!run.too_much && !run.timed_out) {
        // The end of the program is checked before its output is read, so that the output is
        // complete. Processes that it left may keep the pipes open; they are not waited for.
        const bool ended = child.ended();
        listen();
        check_interruption();
        if (ended) {
            break;
        }
        run.timed_out = late();
        std::array<pollfd, 2> ends{pollfd{out.read.fd, POLLIN, 0}, pollfd{err.read.fd, POLLIN, 0}};
        const bool silent = out.read.fd < 0;
        ::poll(ends.data(), ends.size(), silent ? look_for_the_end_every_ms : look_every_ms);
    }
    const bool killed = run.too_much || run.timed_out;
    child.end();
    const int status = child.wait();
    if (!killed) {
        // A pipe holds less than is read at once, so this reads all remaining output.
        listen();
    }
    run.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    return run;
}

} // namespace edgeproof::io
