// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "lab/lab.hpp"

int main(int argc, char** argv) {
    using namespace edgeproof;
    cli::open_standard_streams();
    cli::take_aborts();
    cli::take_signals();
    return cli::run_program(argc, argv,
                            {cli::add_pressure,  cli::add_expand,     cli::add_extent,
                             cli::add_slip,      cli::add_stress,     cli::add_displacement,
                             cli::add_plot,      cli::add_slip_table, cli::add_explain,
                             cli::add_relations, cli::add_design,     cli::add_table,
                             cli::add_points,    cli::add_check,      cli::add_compare,
                             cli::add_pack,      cli::add_mutate,     cli::add_certify,
                             cli::add_bounds,    cli::add_cost,       cli::add_verify});
}
