// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/cli.hpp"

#include <iterator>

/// The program with the subcommands for one scene. JavaScript calls it with its arguments.
int main(int argc, char** argv) {
    using namespace edgeproof;
    cli::take_aborts();
    return cli::run_program(argc, argv,
                            {std::begin(cli::scene_commands), std::end(cli::scene_commands)});
}
