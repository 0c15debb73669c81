// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/process.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

extern char** environ; // NOLINT: POSIX names it so

namespace edgeproof::io {

namespace {

/// A thread that holds the lock finishes its step much faster, unless a disk hangs.
constexpr std::chrono::milliseconds longest_wait_for_a_step{250};

struct Registered {
    std::timed_mutex mutex;
    std::multiset<std::filesystem::path> paths;
    std::map<pid_t, std::string> groups; ///< with their marks
};

/// Never destroyed: threads may still use it while the process ends.
Registered& registered() {
    static auto* const all = new Registered; // NOLINT(cppcoreguidelines-owning-memory)
    return *all;
}

std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Returns the numbers of all other processes.
std::vector<pid_t> all_processes() {
    std::vector<pid_t> all;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator("/proc", ignored)) {
        const auto process = read_whole<pid_t>(entry.path().filename().string());
        if (process && *process != ::getpid()) {
            all.push_back(*process);
        }
    }
    return all;
}

bool is_marked(pid_t process, const std::string& mark) {
    return text_of("/proc/" + std::to_string(process) + "/environ").find(mark + '\0') !=
           std::string::npos;
}

bool is_child(pid_t process) {
    const std::string stat = text_of("/proc/" + std::to_string(process) + "/stat");
    const std::size_t name_end = stat.rfind(") "); // "PID (NAME) STATE PARENT"
    return name_end != std::string::npos &&
           stat.substr(name_end + 4).starts_with(std::to_string(::getpid()) + " ");
}

constexpr int most_rounds = 100;

/// Repeats until none is found, since a process may start another one meanwhile.
void end_marked(const std::string& mark) {
    bool found = !mark.empty();
    for (int round = 0; found && round < most_rounds; ++round) {
        found = false;
        for (const pid_t process : all_processes()) {
            if (is_marked(process, mark)) {
                found = ::kill(process, SIGKILL) == 0 || found;
            }
        }
    }
}

std::atomic<bool> adopts{false};

/// Ends the children of this process that it did not start: the processes that a program left, as
/// they become children of this one (adopt_orphans). When one ends, its own children do, too.
void end_adopted(const std::map<pid_t, std::string>& started) {
    bool found = adopts;
    for (int round = 0; found && round < most_rounds; ++round) {
        found = false;
        for (const pid_t process : all_processes()) {
            if (!started.contains(process) && is_child(process)) {
                ::kill(process, SIGKILL);
                found = ::waitpid(process, nullptr, 0) == process || found;
            }
        }
    }
}

void forget(const std::filesystem::path& path) {
    auto& paths = registered().paths;
    if (const auto found = paths.find(path); found != paths.end()) {
        paths.erase(found);
    }
}

} // namespace

std::unique_lock<std::timed_mutex> hold_cleanup() { return std::unique_lock(registered().mutex); }

TemporaryPath::TemporaryPath(std::filesystem::path path)
    : TemporaryPath([&] { return std::move(path); }) {}

TemporaryPath::TemporaryPath(const std::function<std::filesystem::path()>& make) {
    const auto lock = hold_cleanup();
    path_ = std::filesystem::absolute(make());
    registered().paths.insert(path_);
}

TemporaryPath::~TemporaryPath() {
    if (registered_) {
        const auto lock = hold_cleanup();
        forget(path_);
    }
}

void TemporaryPath::keep_locked() noexcept {
    forget(path_);
    registered_ = false;
}

void adopt_orphans() {
#ifdef __linux__
    adopts = ::prctl(PR_SET_CHILD_SUBREAPER, 1) == 0;
#endif
}

std::string new_mark() {
    static std::atomic<unsigned long> count{0};
    return "EDGEPROOF_CHILD_" + std::to_string(::getpid()) + "_" + std::to_string(++count) + "=1";
}

ChildGroup::ChildGroup(const std::function<pid_t()>& start, std::string mark)
    : pid_(-1), mark_(std::move(mark)) {
    const auto lock = hold_cleanup();
    pid_ = start();
    registered().groups.emplace(pid_, mark_);
}

ChildGroup::~ChildGroup() {
    if (pid_ > 0) {
        end();
        (void)wait();
    }
}

void ChildGroup::end() const {
    ::kill(-pid_, SIGKILL);
    end_marked(mark_);
}

bool ChildGroup::ended() const {
    siginfo_t info{};
    return ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == pid_;
}

int ChildGroup::wait() {
    siginfo_t info{};
    while (::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOWAIT) != 0 &&
           errno == EINTR) {
    }
    end();
    {
        // After the wait, its number may belong to another process.
        const auto lock = hold_cleanup();
        if (registered().groups.size() == 1) { // else they may belong to another program
            end_adopted(registered().groups);
        }
        registered().groups.erase(pid_);
    }
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    return status;
}

void clean_up() noexcept {
    try {
        Registered& all = registered();
        // Never unlocked. If another step hangs, the registered things are removed anyway.
        (void)all.mutex.try_lock_for(longest_wait_for_a_step);
        for (const auto& [group, mark] : all.groups) {
            ::kill(-group, SIGKILL);
            end_marked(mark);
        }
        end_adopted({});
        for (const std::filesystem::path& path : all.paths) {
            std::error_code ignored;
            std::filesystem::remove_all(path, ignored);
        }
    } catch (...) { // out of memory
    }
}

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
