// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/program.hpp"

#include "edgeproof/conformance/reference.hpp"
#include "edgeproof/precision/error.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <utility>

namespace edgeproof {
namespace {

constexpr std::size_t most_output = 200'000'000;
constexpr int look_every_ms = 100;

[[noreturn]] void cannot(const char* what) {
    throw Error(std::string("cannot ") + what + ": " + std::strerror(errno));
}

class Descriptor {
public:
    explicit Descriptor(int fd) : fd_(fd) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { close(); }
    void close() {
        if (fd_ >= 0) {
            ::close(fd_);
        }
        fd_ = -1;
    }
    [[nodiscard]] int get() const { return fd_; }

private:
    int fd_;
};

/// A program that no longer reads must not end us: SIGPIPE is held back in this thread.
class NoBrokenPipe {
public:
    NoBrokenPipe() {
        sigemptyset(&pipe_);
        sigaddset(&pipe_, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
    }
    ~NoBrokenPipe() {
        const timespec at_once{};
        while (sigtimedwait(&pipe_, nullptr, &at_once) > 0) {
        }
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    NoBrokenPipe(const NoBrokenPipe&) = delete;
    NoBrokenPipe& operator=(const NoBrokenPipe&) = delete;

private:
    sigset_t pipe_{};
    sigset_t before_{};
};

/// The child with all that it started, ended when this is.
class Child {
public:
    explicit Child(pid_t pid) : pid_(pid) {}
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        if (pid_ > 0) {
            end();
            (void)wait();
        }
    }
    void end() const { ::kill(-pid_, SIGKILL); }
    int wait() {
        int status = 0;
        while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
        }
        pid_ = -1;
        return status;
    }
    /// Whether it has ended; it is still to be waited for.
    [[nodiscard]] bool ended() const {
        siginfo_t info{};
        return ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
               info.si_pid == pid_;
    }

private:
    pid_t pid_;
};

std::pair<int, int> make_pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        cannot("make a pipe");
    }
    return {ends[0], ends[1]};
}

pid_t start(const std::string& command, int in, int out) {
    const char* const arguments[] = {"sh", "-c", command.c_str(), nullptr};
    const pid_t pid = ::fork();
    if (pid < 0) {
        cannot("start a program");
    }
    if (pid == 0) {
        ::setpgid(0, 0);
        sigset_t none;
        sigemptyset(&none);
        ::sigprocmask(SIG_SETMASK, &none, nullptr);
        ::dup2(in, STDIN_FILENO);
        ::dup2(out, STDOUT_FILENO);
        ::execv("/bin/sh", const_cast<char* const*>(arguments));
        ::_exit(127);
    }
    ::setpgid(pid, pid); // whoever comes first
    return pid;
}

/// Writes what goes in without waiting. False when nothing is left to write, or nobody reads.
bool feed(int fd, const std::string& input, std::size_t& at) {
    while (at < input.size()) {
        const ssize_t n = ::write(fd, input.data() + at, input.size() - at);
        if (n > 0) {
            at += static_cast<std::size_t>(n);
        } else if (errno == EAGAIN) {
            return true;
        } else if (errno != EINTR) {
            return false;
        }
    }
    return false;
}

/// Reads what there is without waiting. False at the end.
bool drain(int fd, std::string& output) {
    std::array<char, 65536> buffer{};
    for (;;) {
        const ssize_t n = ::read(fd, buffer.data(), buffer.size());
        if (n > 0) {
            output.append(buffer.data(), static_cast<std::size_t>(n));
            if (output.size() > most_output) {
                return true;
            }
        } else if (n < 0 && errno == EAGAIN) {
            return true;
        } else if (n == 0 || errno != EINTR) {
            return false;
        }
    }
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

ProgramRun run_program(const std::string& command, const std::string& input, double seconds,
                       const std::atomic<bool>* stop) {
    using Clock = std::chrono::steady_clock;
    const auto last = Clock::now() + std::chrono::duration<double>(seconds);
    const NoBrokenPipe guard;
    const auto [their_in, our_out] = make_pipe();
    Descriptor reads(their_in);
    Descriptor writes(our_out);
    const auto [our_in, their_out] = make_pipe();
    Descriptor answers(our_in);
    Descriptor theirs(their_out);
    Child child(start(command, reads.get(), theirs.get()));
    reads.close();
    theirs.close();
    ::fcntl(writes.get(), F_SETFL, O_NONBLOCK);
    ::fcntl(answers.get(), F_SETFL, O_NONBLOCK);
    ProgramRun run;
    std::size_t written = 0;
    for (bool open = true; open;) {
        if (writes.get() >= 0 && !feed(writes.get(), input, written)) {
            writes.close();
        }
        open = drain(answers.get(), run.output);
        run.too_much = run.output.size() > most_output;
        run.timed_out = open && Clock::now() >= last;
        if (stop != nullptr && *stop) {
            throw Stopped("interrupted: nothing is written");
        }
        if (run.too_much || run.timed_out) {
            child.end();
            break;
        }
        if (open) {
            std::array<pollfd, 2> ends{pollfd{answers.get(), POLLIN, 0},
                                       pollfd{writes.get(), POLLOUT, 0}};
            ::poll(ends.data(), writes.get() >= 0 ? 2U : 1U, look_every_ms);
        }
    }
    // It may have closed its output and linger.
    while (!run.too_much && !run.timed_out && !child.ended()) {
        if (Clock::now() >= last) {
            run.timed_out = true;
            child.end();
        }
        ::poll(nullptr, 0, 1);
    }
    const int status = child.wait();
    run.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    return run;
}

} // namespace edgeproof
