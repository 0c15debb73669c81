// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/cli.hpp"

int main(int argc, char** argv) { return edgeproof::cli::run_edgeproof(argc, argv, nullptr); }
