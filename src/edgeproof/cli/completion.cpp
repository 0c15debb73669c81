// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/command_tree.hpp"
#include "edgeproof/cli/manual.hpp"

#include <cctype>
#include <string_view>

namespace edgeproof::cli {
namespace {

/// Puts a backslash before each of the characters of `special`.
std::string escaped(std::string_view text, std::string_view special) {
    std::string out;
    for (const char c : text) {
        out += (special.find(c) != std::string_view::npos ? "\\" : "") + std::string(1, c);
    }
    return out;
}

/// Returns an unquoted word for zsh.
std::string zsh_word(std::string_view text) {
    std::string out;
    for (const char c : text) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                           static_cast<unsigned char>(c) >= 0x80;
        out += (plain ? "" : "\\") + std::string(1, c);
    }
    return out;
}

/// Returns the text in single quotes for a POSIX shell.
std::string single_quoted(std::string_view text) {
    std::string out = "'";
    for (const char c : text) {
        out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return out + "'";
}

std::string words_of(const CLI::App& app) {
    std::string words;
    for (const CLI::App* sub : subcommands(app)) {
        words += sub->get_name() + " ";
    }
    for (const CLI::Option* option : shown_options(app)) {
        for (const std::string& name : names_of(*option)) {
            words += name + " ";
        }
    }
    words.pop_back(); // the last character is a space: there is at least --help
    return words;
}

/// Returns a line for each command: the words typed so far, and those that may follow.
std::string bash_cases(const CLI::App& app, const std::string& typed) {
    std::string out = "        '" + typed + "') words='" + words_of(app) + "' ;;\n";
    for (const CLI::App* sub : subcommands(app)) {
        out += bash_cases(*sub, typed.empty() ? sub->get_name() : typed + " " + sub->get_name());
    }
    return out;
}

std::string all_commands(const CLI::App& app) {
    std::string out;
    for (const CLI::App* sub : subcommands(app)) {
        out += (out.empty() ? "" : "|") + sub->get_name();
        const std::string deeper = all_commands(*sub);
        out += deeper.empty() ? "" : "|" + deeper;
    }
    return out;
}

std::string zsh_function(const CLI::App& app, const std::string& function) {
    std::string out = function + "() {\n    local line state\n    _arguments -C \\\n";
    for (const CLI::Option* option : shown_options(app)) {
        for (const std::string& name : names_of(*option)) {
            out += "        " +
                   single_quoted(name + "[" + escaped(option->get_description(), "[]:\\") + "]" +
                                 (takes_value(*option) ? ":value:_files" : "")) +
                   " \\\n";
        }
    }
    const auto subs = subcommands(app);
    if (subs.empty()) {
        return out + "        '*:file:_files'\n}\n\n";
    }
    std::string list;
    std::string cases;
    std::string deeper;
    for (const CLI::App* sub : subs) {
        list += " " + sub->get_name() + "\\:" + zsh_word(sub->get_description());
        cases += "                " + sub->get_name() + ") " + function + "_" + sub->get_name() +
                 " ;;\n";
        deeper += zsh_function(*sub, function + "_" + sub->get_name());
    }
    out += "        " + single_quoted("1:subcommand:((" + list + "))") +
           " \\\n"
           "        '*::arguments:->rest'\n"
           "    case $state in\n        rest)\n            case $line[1] in\n" +
           cases + "            esac ;;\n    esac\n}\n\n";
    return out + deeper;
}

std::string fish_quoted(std::string_view text) { return "'" + escaped(text, "'\\") + "'"; }

std::string fish_lines(const CLI::App& app, const std::string& program, const std::string& when) {
    std::string out;
    for (const CLI::Option* option : shown_options(app)) {
        out += "complete -c " + program + " -n " + fish_quoted(when);
        for (const std::string& name : option->get_snames()) {
            out += " -s " + name;
        }
        for (const std::string& name : option->get_lnames()) {
            out += " -l " + name;
        }
        out += (takes_value(*option) ? " -r" : "") + std::string(" -d ") +
               fish_quoted(option->get_description()) + "\n";
    }
    std::string names;
    for (const CLI::App* sub : subcommands(app)) {
        names += " " + sub->get_name();
    }
    for (const CLI::App* sub : subcommands(app)) {
        out += "complete -c " + program + " -f -n " +
               fish_quoted(when + "; and not __fish_seen_subcommand_from" + names) + " -a " +
               sub->get_name() + " -d " + fish_quoted(sub->get_description()) + "\n";
        out += fish_lines(*sub, program, "__fish_seen_subcommand_from " + sub->get_name());
    }
    return out;
}

} // namespace

std::string bash_completion(const CLI::App& app) {
    const std::string name = app.get_name();
    return "# Completion of " + name + " for bash.\n_" + name +
           "() {\n    local typed= word words i\n"
           "    for ((i = 1; i < COMP_CWORD; ++i)); do\n"
           "        word=${COMP_WORDS[i]}\n"
           "        case $word in\n            " +
           all_commands(app) +
           ") typed+=${typed:+ }$word ;;\n        esac\n    done\n    case $typed in\n" +
           bash_cases(app, "") +
           "    esac\n"
           "    COMPREPLY=($(compgen -W \"$words\" -- \"${COMP_WORDS[COMP_CWORD]}\"))\n}\n"
           "complete -o bashdefault -o default -F _" +
           name + " " + name + "\n";
}

std::string zsh_completion(const CLI::App& app) {
    const std::string name = app.get_name();
    return "#compdef " + name + "\n# Completion of " + name + " for zsh.\n\n" +
           zsh_function(app, "_" + name) + "_" + name + " \"$@\"\n";
}

std::string fish_completion(const CLI::App& app) {
    const std::string name = app.get_name();
    return "# Completion of " + name + " for fish.\n" + fish_lines(app, name, "true");
}

} // namespace edgeproof::cli
