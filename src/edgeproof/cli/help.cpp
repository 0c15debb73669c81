// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <string>

namespace edgeproof::cli {
namespace {

constexpr const char* compute = "Compute";
constexpr const char* check = "Tables and checks";
constexpr const char* develop = "For developers";

struct CommandHelp {
    const char* command;
    const char* group;
    const char* example; ///< its arguments
};
constexpr CommandHelp helps[] = {
    {"pressure", compute, "kind=hertz R=100 P=120 E=115e3 nu=0.32 u=1e-3,0.1"},
    {"expand", compute, "fretting-pad terms=3"},
    {"extent", compute, "kind=flat-and-rounded t=1 R=50 P=100 E=115e3 nu=0.32 tolerance=1%"},
    {"slip", compute, "kind=hertz R=100 P=120 E=115e3 nu=0.32 friction=0.5 q_ratio=0.6"},
    {"stress", compute, "stress --point 0,1/2"},
    {"displacement", compute, "stress x=0,2"},
    {"plot", compute, "fretting-pad tolerance=1% --out pad.svg"},
    {"design", compute,
     "kind=flat-and-rounded t=0..0.9 R=10 a=1 contact_modulus=1 tolerance=5% --digits 4 --gap "
     "1e-2"},
    {"table", check, "power-law --check --every 200"},
    {"verify", check, "moore-hills --only EQ18 --digits 20"},
    {"check", check, "--ledger moore-hills"},
    {"compare", check,
     "examples/compare/cylinder.toml examples/compare/mesh-192.csv --edge-zone 2e"},
    {"relations", develop, "left.c1 left.c0 b1 --degree 2"},
    {"cost", develop, ""},
    {"points", "", "power-law"}};

using nlohmann::json;

/// Adds a line for each key of an object of a schema, and those of its parts.
void add_keys(std::string& text, const json& all, const json& object, const std::string& margin) {
    for (const char* const list : {"allOf", "anyOf", "oneOf"}) {
        for (const json& part : object.value(list, json::array())) {
            add_keys(text, all, part.contains("then") ? part["then"] : part, margin);
        }
    }
    if (object.contains("$ref")) {
        add_keys(text, all, all.at(json::json_pointer(object["$ref"].get<std::string>().substr(1))),
                 margin);
    }
    const json properties = object.value("properties", json::object());
    for (const auto& [key, value] : properties.items()) {
        if (!value.is_object()) {
            continue;
        }
        std::string says = value.value("description", "");
        for (const json& word : value.value("enum", json::array())) {
            says += (says.empty()               ? ""
                     : word == value["enum"][0] ? " "
                                                : ", ") +
                    (word.is_string() ? word.get<std::string>() : word.dump());
        }
        const std::string line =
            says.empty() ? margin + key + "\n"
                         : fmt::format("{}{:<{}}{}\n", margin, key + " ", 20 - margin.size(), says);
        if (text.find("\n" + line) == std::string::npos) {
            text += line;
        }
        for (const char* const of : {"items", "additionalProperties"}) {
            if (value.contains(of) && value[of].is_object()) {
                add_keys(text, all, value[of], margin + "  ");
            }
        }
        add_keys(text, all, value, margin + "  ");
    }
}

} // namespace

void set_help(CLI::App& app) {
    for (const CommandHelp& help : helps) {
        for (CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
            if (sub->get_name() == help.command) {
                sub->group(help.group);
                if (*help.example != '\0') {
                    sub->footer(fmt::format("{}{}Example: edgeproof {} {}", sub->get_footer(),
                                            sub->get_footer().empty() ? "" : "\n", help.command,
                                            help.example));
                }
            }
        }
    }
}

std::string help_of_keys(const std::string& kind) {
    const std::filesystem::path file = shipped("schemas") / (kind + ".schema.json");
    const json schema = json::parse(io::read_text(file.string(), "JSON schema"));
    std::string text = schema.at("title").get<std::string>() + "\n\n";
    add_keys(text, schema, schema, "");
    return text;
}

} // namespace edgeproof::cli
