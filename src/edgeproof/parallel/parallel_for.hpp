// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>

namespace edgeproof::parallel {

/// Calls work(p) for p = 0, ..., n - 1 in this order, on the given number of threads (0: the
/// processors available to this process). If calls throw, the exception of the lowest p is thrown
/// at the end, independent of the number of threads; work after that p may be left undone.
void parallel_for(std::size_t n, unsigned threads, const std::function<void(std::size_t)>& work);

/// Processor time of this thread so far, in seconds.
[[nodiscard]] double thread_seconds();

} // namespace edgeproof::parallel
