// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/cli/cli.hpp"

namespace edgeproof::cli {

/// The command of the program edgeproof-lab, which edgeproof starts
/// (edgeproof/cli/cli.hpp).
int cost(Options& options);

} // namespace edgeproof::cli
