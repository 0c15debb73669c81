// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/parallel/processes.hpp"

#include <memory>

namespace edgeproof::cli {

/// The processes that this one was started with by mpirun or srun; null where it was started alone,
/// which costs a look at the environment and no more. Throws InputError where it was started as one
/// of several and cannot tell the others: a build without MPI, or an srun that does not connect
/// them.
[[nodiscard]] std::unique_ptr<parallel::Processes> launched_together();

/// As how many it was started, 1 for alone.
[[nodiscard]] std::size_t launched_count();

} // namespace edgeproof::cli
