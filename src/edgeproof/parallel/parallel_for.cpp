// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/parallel/parallel_for.hpp"

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <ctime>
#include <exception>
#include <limits>
#include <memory>
#include <mutex>

namespace edgeproof::parallel {

unsigned usual_threads() { return static_cast<unsigned>(tbb::info::default_concurrency()); }

PieceSource all_pieces(std::size_t n) {
    auto given = std::make_shared<std::atomic<std::size_t>>(0);
    return [n, given]() -> std::optional<std::size_t> {
        const std::size_t p = (*given)++;
        return p < n ? std::optional(p) : std::nullopt;
    };
}

void work_through(const PieceSource& next, unsigned threads,
                  const std::function<void(std::size_t)>& work) {
    std::mutex failing;
    std::exception_ptr error;
    std::atomic<std::size_t> failed{std::numeric_limits<std::size_t>::max()};
    const auto fail = [&](std::size_t p) {
        const std::lock_guard lock(failing);
        if (p < failed || !error) {
            failed = p;
            error = std::current_exception();
        }
    };
    const auto loop = [&] {
        std::optional<std::size_t> p;
        try {
            while ((p = next()) && *p < failed) {
                work(*p);
            }
        } catch (...) {
            fail(p.value_or(std::numeric_limits<std::size_t>::max()));
        }
    };
    // The threads of the pool live longer than this call, so that their tables and constants are
    // reused.
    const unsigned wanted = threads == 0 ? usual_threads() : threads;
    tbb::task_arena arena(static_cast<int>(wanted));
    arena.execute([&] {
        tbb::parallel_for(
            tbb::blocked_range<unsigned>(0, wanted, 1), [&](const auto&) { loop(); },
            tbb::simple_partitioner{});
    });
    if (error) {
        std::rethrow_exception(error);
    }
}

double thread_seconds() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

} // namespace edgeproof::parallel
