// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/process_cleanup.hpp"

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

bool is_marked(const std::filesystem::path& process, const std::string& mark) {
    std::ifstream in(process / "environ", std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    return text.find(mark + '\0') != std::string::npos;
}

/// Kills the processes with this variable in their environment. Repeats until none is found, since
/// a process may start another one meanwhile.
void end_marked(const std::string& mark) {
    constexpr int most_rounds = 100;
    bool found = !mark.empty();
    for (int round = 0; found && round < most_rounds; ++round) {
        found = false;
        std::error_code ignored;
        for (const auto& entry : std::filesystem::directory_iterator("/proc", ignored)) {
            const std::string name = entry.path().filename().string();
            const char* const end = name.data() + name.size();
            pid_t process = 0;
            const auto [stop, error] = std::from_chars(name.data(), end, process);
            if (error == std::errc{} && stop == end && process != ::getpid() &&
                is_marked(entry.path(), mark)) {
                found = ::kill(process, SIGKILL) == 0 || found;
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
        for (const std::filesystem::path& path : all.paths) {
            std::error_code ignored;
            std::filesystem::remove_all(path, ignored);
        }
    } catch (...) { // out of memory
    }
}

} // namespace edgeproof::io
