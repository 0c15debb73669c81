// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cost/cost.hpp"

int main(int argc, char** argv) {
    return edgeproof::cli::run_edgeproof(argc, argv, edgeproof::cli::cost);
}
