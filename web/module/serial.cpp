// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/parallel/parallel_for.hpp"

#include <memory>

/// The work of a module with one thread, instead of src/edgeproof/parallel/parallel_for.cpp.
namespace edgeproof::parallel {

unsigned usual_threads() { return 1; }

PieceSource all_pieces(std::size_t n) {
    return [n, given = std::make_shared<std::size_t>(0)]() -> std::optional<std::size_t> {
        return *given < n ? std::optional((*given)++) : std::nullopt;
    };
}

void work_through(const PieceSource& next, unsigned /*threads*/,
                  const std::function<void(std::size_t)>& work) {
    while (const std::optional<std::size_t> p = next()) {
        work(*p);
    }
}

} // namespace edgeproof::parallel
