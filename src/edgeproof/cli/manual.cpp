// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/manual.hpp"

#include "edgeproof/cli/command_tree.hpp"
#include "edgeproof/io/output_file.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace edgeproof::cli {
namespace {

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

std::string line(const char* macro, const std::string& text) {
    return std::string(".") + macro + " " + roff(text) + "\n";
}

std::string option_entry(const CLI::Option& option) {
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
        if (option->get_positional()) {
            arguments += ".TP\n\\fI" + roff(upper(option->get_name())) + "\\fR\n" +
                         roff(option->get_description()) + "\n";
        } else if (!option->get_group().empty()) {
            options += option_entry(*option);
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

} // namespace

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
        out += line("SS", command + " " + sub->get_name()) + roff(sub->get_description()) + "\n";
        for (const CLI::Option* option : sub->get_options()) {
            out += option->get_positional() ? ".TP\n\\fI" + roff(upper(option->get_name())) +
                                                  "\\fR\n" + roff(option->get_description()) + "\n"
                                            : option_entry(*option);
        }
    }
    if (!app.get_footer().empty()) {
        constexpr std::string_view head = "Exit status: ";
        const std::string& footer = app.get_footer();
        out += ".SH EXIT STATUS\n" +
               roff(footer.rfind(head, 0) == 0 ? footer.substr(head.size()) : footer) + ".\n";
    }
    return see.empty() ? out : out + ".SH SEE ALSO\n" + see;
}

void write_manual(const CLI::App& app, const std::string& version,
                  const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder / "man1");
    io::write_whole(folder / "man1" / (app.get_name() + ".1"), man_page(app, app, version));
    for (const CLI::App* sub : subcommands(app)) {
        io::write_whole(folder / "man1" / (app.get_name() + "-" + sub->get_name() + ".1"),
                        man_page(app, *sub, version));
    }
    io::write_whole(folder / (app.get_name() + ".bash"), bash_completion(app));
    io::write_whole(folder / ("_" + app.get_name()), zsh_completion(app));
    io::write_whole(folder / (app.get_name() + ".fish"), fish_completion(app));
}

} // namespace edgeproof::cli
