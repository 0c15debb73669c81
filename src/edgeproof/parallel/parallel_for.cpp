// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/parallel/parallel_for.hpp"

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <ctime>
#include <exception>
#include <limits>
#include <mutex>

namespace edgeproof::parallel {

void parallel_for(std::size_t n, unsigned threads, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next{0};
    std::mutex failing;
    std::exception_ptr error;
    std::atomic<std::size_t> failed{std::numeric_limits<std::size_t>::max()};
    const auto fail = [&](std::size_t p) {
        const std::lock_guard lock(failing);
        if (p < failed) {
            failed = p;
            error = std::current_exception();
        }
    };
    const auto loop = [&] {
        std::size_t p = 0;
        try {
            while ((p = next++) < n && p < failed) {
                work(p);
            }
        } catch (...) {
            fail(p);
        }
    };
    // The threads of the pool live longer than this call, so that their tables and constants are
    // reused.
    const int wanted = threads == 0 ? tbb::info::default_concurrency() : static_cast<int>(threads);
    tbb::task_arena arena(wanted);
    arena.execute([&] {
        tbb::parallel_for(
            tbb::blocked_range<int>(0, wanted, 1), [&](const auto&) { loop(); },
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
