// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/process_cleanup.hpp"

#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

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
        const std::string name = entry.path().filename().string();
        const char* const end = name.data() + name.size();
        pid_t process = 0;
        const auto [stop, error] = std::from_chars(name.data(), end, process);
        if (error == std::errc{} && stop == end && process != ::getpid()) {
            all.push_back(process);
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

} // namespace edgeproof::io
