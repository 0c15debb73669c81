// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"

/// The program with the subcommands for one scene. JavaScript calls it with its arguments.
int main(int argc, char** argv) {
    using namespace edgeproof;
    cli::take_aborts();
    return cli::run_program(argc, argv,
                            {cli::add_pressure, cli::add_expand, cli::add_extent, cli::add_slip,
                             cli::add_stress, cli::add_displacement, cli::add_plot});
}
