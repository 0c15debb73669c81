// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <atomic>
#include <string>
#include <utility>

namespace edgeproof {

/// Thrown when the work has been asked to end. This is not an Error and not a std::exception,
/// because code that catches those continues with other work. Code that catches everything (`catch
/// (...)`) rethrows it.
class Interrupted {
public:
    explicit Interrupted(std::string what = "interrupted: nothing is written")
        : what_(std::move(what)) {}
    /// The one line that a user reads.
    [[nodiscard]] const std::string& what() const noexcept { return what_; }

private:
    std::string what_;
};

namespace detail {
inline std::atomic<int> interruption{0};
static_assert(std::atomic<int>::is_always_lock_free);
} // namespace detail

/// Asks all work of this process to end. `reason` (not 0) is the number of a signal; the first
/// request is kept. May be called from any thread and in a signal handler.
inline void request_interruption(int reason) noexcept {
    int none = 0;
    detail::interruption.compare_exchange_strong(none, reason);
}
/// Withdraws the request, for a process that continues with other work.
inline void withdraw_interruption() noexcept { detail::interruption = 0; }

/// Returns the reason of the request; 0 if there is none.
[[nodiscard]] inline int interruption_requested() noexcept {
    return detail::interruption.load(std::memory_order_relaxed);
}

/// Throws Interrupted if there is a request. The cost is one read of memory: loops that may be long
/// call it in every iteration. It cannot interrupt a single operation on very long numbers; a
/// program that must end in time needs another means in addition (cli/signals.cpp).
inline void check_interruption() {
    if (interruption_requested() != 0) {
        throw Interrupted();
    }
}

} // namespace edgeproof
