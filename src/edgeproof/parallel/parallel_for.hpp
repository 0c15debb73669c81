// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <functional>
#include <optional>

namespace edgeproof::parallel {

/// Numbers of pieces of work, ascending, until there are no more. Asked from any thread.
using PieceSource = std::function<std::optional<std::size_t>()>;

/// Does work(p) for every p that `next` gives, on so many threads (0: as many as the processor has
/// for this process). Where some throw, the exception of the least p is thrown in the end, the same
/// whatever the number of threads; what comes after that p may be left undone.
void work_through(const PieceSource& next, unsigned threads,
                  const std::function<void(std::size_t)>& work);

/// The threads that 0 stands for.
[[nodiscard]] unsigned usual_threads();

/// 0, ..., n - 1.
[[nodiscard]] PieceSource all_pieces(std::size_t n);

} // namespace edgeproof::parallel
