// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/parallel/distributed_work.hpp"

#include <memory>

namespace edgeproof::cli {

/// Returns the processes that mpirun or srun started together with this one, or null if it was
/// started alone (then only the environment is read). Throws InputError if it is one of several
/// processes that it cannot reach: in a build without MPI, or under an srun that does not connect
/// them.
[[nodiscard]] std::unique_ptr<parallel::Processes> launched_together();

/// Returns the number of processes started together, 1 for one alone.
[[nodiscard]] std::size_t launched_count();

} // namespace edgeproof::cli
