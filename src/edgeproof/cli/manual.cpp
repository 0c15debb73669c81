// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/io/output_file.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace edgeproof::cli {
namespace {

std::vector<const CLI::App*> subcommands(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App* sub) { return !sub->get_group().empty(); });
}

/// Returns the names with their hyphens: "-h", "--help".
std::vector<std::string> names_of(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) {
        names.push_back("-" + name);
    }
    for (const std::string& name : option.get_lnames()) {
        names.push_back("--" + name);
    }
    return names;
}

bool takes_value(const CLI::Option& option) {
    return option.get_type_size() > 0 && option.get_expected_max() > 0;
}

/// Returns the options of a command, without its arguments and hidden options.
std::vector<const CLI::Option*> shown_options(const CLI::App& app) {
    return app.get_options([](const CLI::Option* option) {
        return !option->get_positional() && !option->get_group().empty();
    });
}

/// Returns the values of an option whose type is "csv|json|md", separated by blanks; empty for
/// another type.
std::string values_of(const CLI::Option& option) {
    std::string values = option.get_type_name();
    if (!takes_value(option) || values.find('|') == std::string::npos) {
        return "";
    }
    std::ranges::replace(values, '|', ' ');
    return values;
}

/// Returns the names of the shipped files that a command takes as its argument, separated by
/// blanks.
std::string shipped_files_of(const CLI::App& app) {
    std::string names;
    for (const CLI::Option* option : app.get_options()) {
        if (!option->get_positional()) {
            continue;
        }
        const std::string& argument = option->get_name();
        const std::string_view folder =
            argument == "scene"    ? (app.get_name() == "design" ? shipped_designs : shipped_scenes)
            : argument == "ledger" ? shipped_ledgers
            : argument == "recipe" ? shipped_recipes
                                   : std::string_view();
        for (const std::string& name :
             folder.empty() ? std::vector<std::string>() : shipped_names(folder)) {
            if (name != "hard-cases") { // no recipe
                names += (names.empty() ? "" : " ") + name;
            }
        }
    }
    return names;
}

/// Escapes a text for roff.
std::string roff(const std::string& text) {
    std::string out;
    for (const char c : text) {
        out += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    }
    return !out.empty() && (out.front() == '.' || out.front() == '\'') ? "\\&" + out : out;
}

std::string upper(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

/// Returns the entry of an option or an argument.
std::string option_entry(const CLI::Option& option) {
    if (option.get_positional()) {
        return ".TP\n\\fI" + roff(upper(option.get_name())) + "\\fR\n" +
               roff(option.get_description()) + "\n";
    }
    std::string names;
    for (const std::string& name : names_of(option)) {
        names += (names.empty() ? "\\fB" : ", \\fB") + roff(name) + "\\fR";
    }
    if (takes_value(option)) {
        names += " \\fI" +
                 roff(option.get_type_name().substr(0, option.get_type_name().find(':'))) + "\\fR";
    }
    std::string text = roff(option.get_description());
    if (!option.get_default_str().empty()) {
        text += " (default: " + roff(option.get_default_str()) + ")";
    }
    return ".TP\n" + names + "\n" + text + "\n";
}

std::string sections(const CLI::App& of) {
    std::string arguments;
    std::string options;
    for (const CLI::Option* option : of.get_options()) {
        if (option->get_positional() || !option->get_group().empty()) {
            (option->get_positional() ? arguments : options) += option_entry(*option);
        }
    }
    std::string out;
    if (!arguments.empty()) {
        out += ".SH ARGUMENTS\n" + arguments;
    }
    return options.empty() ? out : out + ".SH OPTIONS\n" + options;
}

std::string synopsis(const std::string& command, const CLI::App& of) {
    std::string text = "\\fB" + roff(command) + "\\fR [\\fIOPTIONS\\fR]";
    for (const CLI::Option* option : of.get_options()) {
        if (option->get_positional()) {
            const std::string name = "\\fI" + roff(upper(option->get_name())) + "\\fR";
            text += option->get_required() ? " " + name : " [" + name + "]";
        }
    }
    return text + (subcommands(of).empty() ? "" : " \\fISUBCOMMAND\\fR") + "\n";
}

/// Returns the page of one subcommand, or of the program (`of` is `app`), in roff's man macros.
std::string man_page(const CLI::App& app, const CLI::App& of, const std::string& version) {
    const bool whole = &of == &app;
    const std::string command = whole ? app.get_name() : app.get_name() + " " + of.get_name();
    const std::string page = whole ? app.get_name() : app.get_name() + "-" + of.get_name();
    std::string out = ".TH " + roff(upper(page)) + " 1 \"\" \"" + app.get_name() + " " +
                      roff(version) + "\" \"User Commands\"\n";
    out += ".SH NAME\n" + roff(page) + " \\- " + roff(of.get_description()) + "\n";
    out += ".SH SYNOPSIS\n" + synopsis(command, of);
    out += sections(of);
    std::string see = whole ? "" : ".BR " + app.get_name() + " (1)\n";
    if (!subcommands(of).empty()) {
        out += ".SH SUBCOMMANDS\n";
    }
    for (const CLI::App* sub : subcommands(of)) {
        if (whole) {
            out += ".TP\n\\fB" + roff(sub->get_name()) + "\\fR\n" + roff(sub->get_description()) +
                   "; see \\fB" + roff(app.get_name() + "-" + sub->get_name()) + "\\fR(1)\n";
            continue;
        }
        out += ".SS " + roff(command + " " + sub->get_name()) + "\n" +
               roff(sub->get_description()) + "\n";
        for (const CLI::Option* option : sub->get_options()) {
            out += option_entry(*option);
        }
    }
    if (!app.get_footer().empty()) {
        constexpr std::string_view head = "Exit status: ";
        const std::string& footer = app.get_footer();
        const std::size_t at = footer.find(head);
        out += ".SH EXIT STATUS\n" +
               roff(at != std::string::npos ? footer.substr(at + head.size()) : footer) + ".\n";
    }
    return see.empty() ? out : out + ".SH SEE ALSO\n" + see;
}

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

/// Returns a line for each option that has values: the words typed so far with the option.
std::string bash_values(const CLI::App& app, const std::string& typed) {
    std::string out;
    for (const CLI::Option* option : shown_options(app)) {
        const std::string values = values_of(*option);
        for (const std::string& name :
             values.empty() ? std::vector<std::string>() : names_of(*option)) {
            out += "        '" + typed + " " + name + "') words='" + values + "' ;;\n";
        }
    }
    for (const CLI::App* sub : subcommands(app)) {
        out += bash_values(*sub, typed.empty() ? sub->get_name() : typed + " " + sub->get_name());
    }
    return out;
}

/// Returns a line for each command that takes a shipped file.
std::string bash_files(const CLI::App& app) {
    std::string out;
    for (const CLI::App* sub : subcommands(app)) {
        const std::string names = shipped_files_of(*sub);
        out += names.empty()
                   ? ""
                   : "            '" + sub->get_name() + "') words+=' " + names + "' ;;\n";
    }
    return out;
}

/// Returns all commands as patterns of a case in bash: 'pressure'|'bounds'|'bounds cases'|...
std::string all_commands(const CLI::App& app, const std::string& typed = "") {
    std::string out;
    for (const CLI::App* sub : subcommands(app)) {
        const std::string path = typed.empty() ? sub->get_name() : typed + " " + sub->get_name();
        const std::string deeper = all_commands(*sub, path);
        out += (out.empty() ? "'" : "|'") + path + "'" + (deeper.empty() ? "" : "|" + deeper);
    }
    return out;
}

std::string zsh_function(const CLI::App& app, const std::string& function) {
    std::string out = function + "() {\n    local line state\n    _arguments -C \\\n";
    for (const CLI::Option* option : shown_options(app)) {
        for (const std::string& name : names_of(*option)) {
            out += "        " +
                   single_quoted(name + "[" + escaped(option->get_description(), "[]:\\") + "]" +
                                 (values_of(*option).empty()
                                      ? (takes_value(*option) ? ":value:_files" : "")
                                      : ":value:(" + values_of(*option) + ")")) +
                   " \\\n";
        }
    }
    const auto subs = subcommands(app);
    if (subs.empty()) {
        const std::string names = shipped_files_of(app);
        // Behind a blank, zsh adds no options of its own, which _alternative refuses.
        const std::string files = names.empty() ? "_files"
                                                : " _alternative \"shipped:shipped file:(" + names +
                                                      ")\" \"files:file:_files\"";
        return out + "        " + single_quoted("*:file:" + files) + "\n}\n\n";
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
        const std::string values = values_of(*option);
        out += (!values.empty()        ? " -x -a " + fish_quoted(values)
                : takes_value(*option) ? std::string(" -r")
                                       : std::string()) +
               " -d " + fish_quoted(option->get_description()) + "\n";
    }
    std::string names;
    for (const CLI::App* sub : subcommands(app)) {
        names += " " + sub->get_name();
    }
    for (const CLI::App* sub : subcommands(app)) {
        out += "complete -c " + program + " -f -n " +
               fish_quoted(when + "; and not __fish_seen_subcommand_from" + names) + " -a " +
               sub->get_name() + " -d " + fish_quoted(sub->get_description()) + "\n";
        const std::string inside = "__fish_seen_subcommand_from " + sub->get_name();
        out += fish_lines(*sub, program, inside);
        const std::string files = shipped_files_of(*sub);
        out += files.empty() ? ""
                             : "complete -c " + program + " -n " + fish_quoted(inside) + " -a " +
                                   fish_quoted(files) + " -d 'shipped file'\n";
    }
    return out;
}

std::string bash_completion(const CLI::App& app) {
    const std::string name = app.get_name();
    return "# Completion of " + name + " for bash.\n_" + name +
           "() {\n    local typed= word words i\n    COMPREPLY=()\n"
           "    for ((i = 1; i < COMP_CWORD; ++i)); do\n"
           "        word=\"${typed:+$typed }${COMP_WORDS[i]}\"\n"
           "        case $word in\n            " +
           all_commands(app) +
           ") typed=$word ;;\n        esac\n    done\n"
           "    local now=${COMP_WORDS[COMP_CWORD]} files=\n"
           "    case \"$typed ${COMP_WORDS[COMP_CWORD-1]}\" in\n" +
           bash_values(app, "") +
           "        *)\n"
           "            case $typed in\n" +
           bash_cases(app, "") +
           "            esac\n"
           "            case $typed in\n" +
           bash_files(app) +
           "                *) files=none ;;\n"
           "            esac\n"
           "            [[ $now == -* ]] && files=none\n"
           "            [[ -z $files ]] && COMPREPLY=($(compgen -f -- \"$now\"))\n"
           "            ;;\n"
           "    esac\n"
           "    COMPREPLY+=($(compgen -W \"$words\" -- \"$now\"))\n}\n"
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

} // namespace

std::string single_quoted(std::string_view text) {
    std::string out = "'";
    for (const char c : text) {
        out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return out + "'";
}

void write_manual(const CLI::App& app, const std::string& version,
                  const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder / "man1");
    io::write_whole(folder / "man1" / (app.get_name() + ".1"), man_page(app, app, version));
    for (const CLI::App* sub : subcommands(app)) {
        io::write_whole(folder / "man1" / (app.get_name() + "-" + sub->get_name() + ".1"),
                        man_page(app, *sub, version));
    }
    io::write_whole(folder / "man1" / "edgeproof-lab.1", ".so man1/" + app.get_name() + ".1\n");
    io::write_whole(folder / (app.get_name() + ".bash"), bash_completion(app));
    io::write_whole(folder / ("_" + app.get_name()), zsh_completion(app));
    io::write_whole(folder / (app.get_name() + ".fish"), fish_completion(app));
}

} // namespace edgeproof::cli
