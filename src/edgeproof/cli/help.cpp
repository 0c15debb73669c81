// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/report/report.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace edgeproof::cli {
namespace {

struct OptionHelp {
    std::string names;
    std::string marks;
    std::string text;
};
struct CommandHelp {
    std::string text;
    std::string group;
    std::string example; ///< its arguments
    std::string footer;
    std::vector<OptionHelp> options;
};

/// Reads share/edgeproof/commands.txt, which describes its format.
std::map<std::string, CommandHelp> read_help() {
    std::map<std::string, CommandHelp> all;
    CommandHelp* now = nullptr;
    std::istringstream lines{std::string(commands_txt)};
    for (std::string line; std::getline(lines, line);) {
        const std::size_t colon = std::min(line.find(": "), line.size());
        const std::string key = line.substr(0, colon);
        std::string text = line.substr(std::min(colon + 2, line.size()));
        if (line.empty() || line.starts_with('#')) {
            continue;
        }
        if (key.starts_with("  ") && colon < line.size()) {
            const std::size_t marks = std::min(key.find(" ("), key.size() - 1);
            now->options.push_back({std::string(io::trimmed(key.substr(2, marks - 1))),
                                    std::string(io::trimmed(key.substr(marks + 1), "()")), text});
        } else if (key.starts_with("  ")) {
            for (const std::string_view name : io::split_words(line)) {
                now->options.push_back(
                    *std::ranges::find(all["any"].options, name, &OptionHelp::names));
            }
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

void add_option(CLI::App& sub, const OptionHelp& of, Options::Value& value) {
    const std::vector<std::string_view> marks = io::split_words(of.marks);
    const auto has = [&](std::string_view mark) {
        return std::ranges::find(marks, mark) != marks.end();
    };
    CLI::Option* const option = has("?")                 ? sub.add_flag(of.names, value.flag)
                                : has("...") || has("+") ? sub.add_option(of.names, value.list)
                                                         : sub.add_option(of.names, value.text);
    option->description(of.text)->required(has("!"));
    if (has("+")) {
        option->allow_extra_args(false);
    }
    if (has("-")) {
        option->group("");
    }
    for (const std::string_view mark : marks) {
        if (mark.front() == '=' || mark.front() == '~') {
            value.text = mark.substr(1);
        } else if (mark.size() > 1 && mark != "...") {
            option->type_name(std::string(mark));
        }
    }
    if (of.marks.find('=') != std::string::npos) {
        option->capture_default_str();
    }
}

using nlohmann::json;

/// The words that a value may have, also those of a list.
std::string words_of(const json& value) {
    for (const json& part : value.value("oneOf", json::array())) {
        if (part.contains("enum")) {
            return words_of(part);
        }
    }
    std::string words;
    for (const json& word : value.value("enum", json::array())) {
        words += (words.empty() ? "" : ", ") +
                 (word.is_string() ? word.get<std::string>() : word.dump());
    }
    return words;
}

/// Adds a line for each key of an object of a schema, and those of its parts; its lines begin at
/// `from`.
void add_keys(std::string& text, const json& all, const json& object, const std::string& margin,
              std::size_t from = 0) {
    for (const char* const list : {"allOf", "anyOf", "oneOf"}) {
        for (const json& part : object.value(list, json::array())) {
            add_keys(text, all, part.contains("then") ? part["then"] : part, margin, from);
        }
    }
    if (object.contains("$ref")) {
        add_keys(text, all, all.at(json::json_pointer(object["$ref"].get<std::string>().substr(1))),
                 margin, from);
    }
    const json properties = object.value("properties", json::object());
    for (const auto& [key, value] : properties.items()) {
        if (!value.is_object()) {
            continue;
        }
        std::string says = value.value("description", "");
        const std::string words = words_of(value);
        says += (says.empty() || words.empty() ? "" : " ") + words;
        const std::string line =
            says.empty() ? margin + key + "\n"
                         : fmt::format("{}{:<{}}{}\n", margin, key + " ", 20 - margin.size(), says);
        if (text.find("\n" + line, from) == std::string::npos) {
            text += line;
        }
        const std::size_t inner = margin.empty() ? text.rfind("\n" + line) + line.size() : from;
        for (const char* const of : {"items", "additionalProperties"}) {
            if (value.contains(of) && value[of].is_object()) {
                add_keys(text, all, value[of], margin + "  ", inner);
            }
        }
        add_keys(text, all, value, margin + "  ", inner);
    }
}

} // namespace

const Options::Value& Options::value(std::string_view name) const {
    static const Value none;
    const auto found = values.find(name);
    return found == values.end() ? none : found->second;
}

void add_command(CLI::App& app, int& code, const Command& command) {
    static const std::map<std::string, CommandHelp> all = read_help();
    const CommandHelp& help = all.at(command.name);
    CLI::App* const sub = app.add_subcommand(command.name, help.text);
    sub->group(help.group);
    const std::string footer = help.footer.empty() ? sub->get_footer() : help.footer;
    sub->footer(help.example.empty()
                    ? footer
                    : footer + (footer.empty() ? "" : "\n") + "Example: edgeproof " + command.name +
                          " " + help.example);
    const auto options = std::make_shared<Options>();
    for (const OptionHelp& of : help.options) {
        add_option(*sub, of, options->values[of.names.substr(0, of.names.find(','))]);
    }
    if (command.run != nullptr) {
        sub->callback([options, run = command.run, &code] { code = run(*options); });
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
