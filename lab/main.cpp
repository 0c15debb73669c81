// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/cli.hpp"
#include "lab/cost/command.hpp"

int main(int argc, char** argv) {
    return edgeproof::cli::run_edgeproof(argc, argv, edgeproof::cli::cost);
}
