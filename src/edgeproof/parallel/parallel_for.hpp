// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <functional>
#include <optional>

namespace edgeproof::parallel {

/// Returns the numbers of pieces of work, ascending, then nothing. Called from any thread.
using PieceSource = std::function<std::optional<std::size_t>()>;

/// Calls work(p) for every p that `next` returns, on the given number of threads (0:
/// usual_threads()). If calls throw, the exception of the lowest p is thrown at the end,
/// independent of the number of threads; work after that p may be left undone.
void work_through(const PieceSource& next, unsigned threads,
                  const std::function<void(std::size_t)>& work);

/// The number of threads for 0: the processors available to this process.
[[nodiscard]] unsigned usual_threads();

/// The numbers 0, ..., n - 1.
[[nodiscard]] PieceSource all_pieces(std::size_t n);

/// Processor time of this thread so far, in seconds.
[[nodiscard]] double thread_seconds();

} // namespace edgeproof::parallel
