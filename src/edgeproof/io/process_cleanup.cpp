// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/process_cleanup.hpp"

#include <sys/resource.h>
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
#include <string_view>
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
    std::string note;
};

/// Never destroyed: threads may still use it while the process ends.
Registered& registered() {
    static auto* const all = new Registered; // NOLINT(cppcoreguidelines-owning-memory)
    return *all;
}

/// Returns the number of a process with the mark in its environment; 0 for other entries of /proc.
pid_t marked_process(const std::filesystem::path& entry, const std::string& mark) {
    const std::string name = entry.filename().string();
    pid_t process = 0;
    const auto [stop, error] = std::from_chars(name.data(), name.data() + name.size(), process);
    if (error != std::errc{} || stop != name.data() + name.size() || process == ::getpid()) {
        return 0;
    }
    std::ifstream in(entry / "environ", std::ios::binary);
    const std::string variables((std::istreambuf_iterator<char>(in)), {});
    return variables.find(mark + '\0') == std::string::npos ? 0 : process;
}

/// Repeats until none is found, since a process may start another one meanwhile.
void end_marked(const std::string& mark) {
    constexpr int most_rounds = 100;
    bool found = !mark.empty();
    for (int round = 0; found && round < most_rounds; ++round) {
        found = false;
        std::error_code ignored;
        for (const auto& entry : std::filesystem::directory_iterator("/proc", ignored)) {
            if (const pid_t process = marked_process(entry.path(), mark); process != 0) {
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

int ChildGroup::wait(double* processor_seconds) {
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
    rusage used{};
    while (::wait4(pid_, &status, 0, &used) < 0 && errno == EINTR) {
    }
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    if (processor_seconds != nullptr) {
        *processor_seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
    }
    pid_ = -1;
    return status;
}

KeptNote::KeptNote(std::string text) {
    const auto lock = hold_cleanup();
    registered().note = std::move(text);
}

KeptNote::~KeptNote() {
    const auto lock = hold_cleanup();
    registered().note.clear();
}

std::string clean_up() noexcept {
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
        return all.note;
    } catch (...) { // out of memory
        return {};
    }
}

} // namespace edgeproof::io
