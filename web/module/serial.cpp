// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/parallel/parallel_for.hpp"

/// The work of a module with one thread, instead of src/edgeproof/parallel/parallel_for.cpp.
namespace edgeproof::parallel {

void parallel_for(std::size_t n, unsigned /*threads*/,
                  const std::function<void(std::size_t)>& work) {
    for (std::size_t p = 0; p < n; ++p) {
        work(p);
    }
}

} // namespace edgeproof::parallel
