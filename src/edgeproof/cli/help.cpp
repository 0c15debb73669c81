// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/report/report.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <utility>

namespace edgeproof::cli {
namespace {

struct CommandHelp {
    std::string text;
    std::string group;
    std::string example; ///< its arguments
    std::string footer;
    std::map<std::string, std::pair<std::string, std::string>> options; ///< marks and help
};

/// Reads share/edgeproof/commands.txt, which describes its format.
std::map<std::string, CommandHelp> read_help() {
    std::map<std::string, CommandHelp> all;
    CommandHelp* now = nullptr;
    std::istringstream lines{std::string(commands_txt)};
    for (std::string line; std::getline(lines, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with('#') || colon == std::string::npos) {
            continue;
        }
        const std::string key = line.substr(0, colon);
        std::string text = line.substr(colon + 2);
        if (key.starts_with("  ")) {
            const std::size_t marks = std::min(key.find(" ("), key.size());
            now->options[key.substr(2, marks - 2)] = {key.substr(marks), text};
        } else if (key == "group" || key == "example") {
            (key == "group" ? now->group : now->example) = text;
        } else if (key == "footer") {
            boost::replace_all(text, "\\n", "\n");
            now->footer = text;
        } else {
            now = &all[key];
            now->text = text;
        }
    }
    return all;
}

const CommandHelp& help_of(const std::string& command) {
    static const std::map<std::string, CommandHelp> all = read_help();
    return all.at(command);
}

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

CLI::App* add_subcommand(CLI::App& app, const std::string& name) {
    const CommandHelp& help = help_of(name);
    CLI::App* const sub = app.add_subcommand(name, help.text);
    sub->group(help.group);
    const std::string footer = help.footer.empty() ? sub->get_footer() : help.footer;
    sub->footer(help.example.empty() ? footer
                                     : footer + (footer.empty() ? "" : "\n") +
                                           "Example: edgeproof " + name + " " + help.example);
    return sub;
}

void describe(const CLI::App& sub, CLI::Option& option, const std::string& names) {
    const auto& own = help_of(sub.get_name()).options;
    const auto found = own.find(names);
    const auto& [marks, text] =
        found == own.end() ? help_of("any").options.at(names) : found->second;
    option.description(text);
    if (marks.find('=') != std::string::npos) {
        option.capture_default_str();
    }
    option.required(marks.find('!') != std::string::npos);
    if (const std::size_t type = marks.find_first_not_of(" (=!)"); type != std::string::npos) {
        option.type_name(marks.substr(type, marks.size() - 1 - type));
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
