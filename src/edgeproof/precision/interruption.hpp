// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <atomic>
#include <string>
#include <utility>

namespace edgeproof {

/// Thrown where somebody asked for the work to end. Not an Error, nor a std::exception: whoever
/// catches those goes on with something else, and nothing may go on here. What catches everything
/// (`catch (...)`) passes it on.
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

/// Asks all work of this process to end; `reason` (not 0) is a signal's number. The first one
/// asked for stays. Safe from any thread, and in a signal handler.
inline void request_interruption(int reason) noexcept {
    int none = 0;
    detail::interruption.compare_exchange_strong(none, reason);
}
/// Takes the request back, for a process that goes on with other work.
inline void withdraw_interruption() noexcept { detail::interruption = 0; }

/// The reason that was given; 0 where nobody asked.
[[nodiscard]] inline int interruption_requested() noexcept {
    return detail::interruption.load(std::memory_order_relaxed);
}

/// Throws Interrupted where it was asked for. One read of memory: loops that may be long call it in
/// each turn. It does not reach into a single operation on very long numbers: a program that must
/// end in time needs a last resort besides (cli/signals.hpp).
inline void check_interruption() {
    if (interruption_requested() != 0) {
        throw Interrupted();
    }
}

} // namespace edgeproof
