// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "lab/cost/command.hpp"

int main(int argc, char** argv) {
    return edgeproof::cli::run_edgeproof(argc, argv, edgeproof::cli::cost);
}
