// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/all_commands.hpp"
#include "lab/lab.hpp"

int main(int argc, char** argv) {
    using namespace edgeproof::cli;
    const LabCommands lab{add_bounds, add_cost};
    return run_edgeproof(argc, argv, &lab);
}
