// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::cli {
namespace {

constexpr const char* usual_group = "Usual options";

/// The example of a command, and the options that its help shows; no options: all of them.
struct CommandHelp {
    std::string_view command;
    std::string_view example;
    std::array<std::string_view, 5> usual = {};
};
constexpr CommandHelp helps[] = {
    {"pressure",
     "edgeproof pressure --hertz --R 100 --P 120 --E 115e3 --nu 0.32 --u 1e-3 0.1",
     {"--u", "--edge", "--terms", "--digits", "--format"}},
    {"expand",
     "edgeproof expand fretting-pad --terms 3",
     {"--terms", "--edge", "--digits", "--format", "--out"}},
    {"extent",
     "edgeproof extent --flat-and-rounded --t 1 --R 50 --P 100 --E 115e3 --nu 0.32 --tolerance 1%",
     {"--tolerance", "--terms", "--edge", "--digits", "--figure"}},
    {"slip",
     "edgeproof slip --hertz --R 100 --P 120 --E 115e3 --nu 0.32 --friction 0.5 --q-ratio 0.6",
     {"--q-ratio", "--friction", "--terms", "--digits", "--format"}},
    {"stress",
     "edgeproof stress stress --point 0,1/2",
     {"--point", "--body", "--digits", "--format", "--out"}},
    {"displacement",
     "edgeproof displacement stress --x 0 2",
     {"--x", "--reference", "--body", "--digits", "--format"}},
    {"plot",
     "edgeproof plot fretting-pad --tolerance 1% --out pad.svg",
     {"--out", "--tolerance", "--terms", "--edge", "--u"}},
    {"relations", "edgeproof relations left.c1 left.c0 b1 --degree 2", {}},
    {"design",
     "edgeproof design --flat-and-rounded --t 0..0.9 --R 10 --a 1 --contact-modulus 1 --tolerance "
     "5% --digits 4 --gap 1e-2",
     {"--tolerance", "--terms", "--edge", "--digits", "--figure"}},
    {"table", "edgeproof table power-law --check --every 200", {}},
    {"points", "edgeproof points power-law", {}},
    {"check",
     "edgeproof check --ledger moore-hills",
     {"--exec", "--ledger", "--digits", "--format", "--figure"}},
    {"compare",
     "edgeproof compare examples/compare/cylinder.toml examples/compare/mesh-192.csv --edge-zone "
     "2e",
     {"--columns", "--tolerance", "--format", "--figures", "--junit"}},
    {"verify",
     "edgeproof verify moore-hills --only EQ18 --digits 20",
     {"--out-dir", "--only", "--digits", "--strict", "--record"}},
};

const CommandHelp* help_of(const CLI::App& app) {
    const auto* const found = std::ranges::find(helps, app.get_name(), &CommandHelp::command);
    return found == std::end(helps) ? nullptr : found;
}

/// Shows the usual options of a command and its example; all options for --help-all.
class CommandFormatter : public CLI::Formatter {
public:
    [[nodiscard]] std::string make_help(const CLI::App* app, std::string name,
                                        CLI::AppFormatMode mode) const override {
        const CommandHelp* const help = help_of(*app);
        if (help == nullptr || help->usual[0].empty() || mode == CLI::AppFormatMode::All) {
            return CLI::Formatter::make_help(app, std::move(name), mode);
        }
        std::vector<const CLI::Option*> usual;
        for (const std::string_view option : help->usual) {
            usual.push_back(app->get_option(std::string(option)));
        }
        return make_description(app) + make_usage(app, std::move(name)) + make_positionals(app) +
               make_group(usual_group, false, usual) + "All options: edgeproof " +
               std::string(help->command) + " --help-all\n\n" + make_footer(app);
    }
    [[nodiscard]] std::string make_usage(const CLI::App* app, std::string name) const override {
        const CommandHelp* const help = help_of(*app);
        return CLI::Formatter::make_usage(app, std::move(name)) +
               (help == nullptr ? "" : "Example: " + std::string(help->example) + "\n");
    }
};

} // namespace

void set_help(CLI::App& app) {
    const auto formatter = std::make_shared<CommandFormatter>();
    const auto every = [](const CLI::App*) { return true; };
    for (CLI::App* sub : app.get_subcommands(every)) {
        if (help_of(*sub) != nullptr) {
            sub->formatter(formatter);
        }
        if (sub->get_subcommands(every).empty()) {
            sub->set_help_all_flag("--help-all", "show all options");
        }
    }
}

} // namespace edgeproof::cli
