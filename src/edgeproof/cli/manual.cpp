// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_command.hpp"

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <string_view>

namespace edgeproof::cli {
namespace {

std::vector<const CLI::App*> subcommands(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App* sub) { return !sub->get_group().empty(); });
}

/// Returns the names with their hyphens, or that of an argument.
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

/// Returns the folder of the shipped files that a command takes as its argument; empty for none.
std::string_view shipped_folder(const CLI::App& app) {
    return app.get_option_no_throw("scene") != nullptr
               ? (app.get_name() == "design" ? shipped_designs : shipped_scenes)
           : app.get_option_no_throw("ledger") != nullptr ? shipped_ledgers
           : app.get_option_no_throw("recipe") != nullptr ||
                   app.get_option_no_throw("answers") != nullptr
               ? shipped_recipes
               : std::string_view();
}

/// Returns lines of text in roff, as they are.
std::string roff(const std::string& text) {
    std::string out;
    for (const char c : text) {
        const bool starts_line = out.empty() || out.back() == '\n';
        out += starts_line && (c == '.' || c == '\'') ? "\\&" : "";
        out += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    }
    return out;
}

/// Returns the help of a command, or of the program, as a page in roff's man macros.
std::string man_page(const CLI::App& app, const CLI::App& of, const std::string& version) {
    const bool whole = &of == &app;
    const std::string page = app.get_name() + (whole ? "" : "-" + of.get_name());
    std::string others = whole ? "" : ".BR " + app.get_name() + " (1)\n";
    for (const CLI::App* sub : subcommands(of)) {
        others += ".BR " + roff(page + "-" + sub->get_name()) + " (1)\n";
    }
    return ".TH " + roff(boost::to_upper_copy(page)) + " 1 \"\" \"" + app.get_name() + " " +
           roff(version) + "\" \"User Commands\"\n.SH NAME\n" + roff(page) + " \\- " +
           roff(of.get_description()) + "\n.SH DESCRIPTION\n.nf\n" +
           roff(of.help(whole ? "" : app.get_name())) + "\n.fi\n.SH SEE ALSO\n" + others;
}

} // namespace

void write_manual(const CLI::App& app, const std::string& version,
                  const std::filesystem::path& folder) {
    const std::filesystem::path man = folder / "man1";
    std::filesystem::create_directories(man);
    io::write_whole(man / (app.get_name() + ".1"), man_page(app, app, version));
    for (const CLI::App* sub : subcommands(app)) {
        io::write_whole(man / (app.get_name() + "-" + sub->get_name() + ".1"),
                        man_page(app, *sub, version));
    }
}

std::vector<std::string> completions(const CLI::App& app, const std::vector<std::string>& words) {
    const std::string now = words.empty() ? "" : words.back();
    const CLI::App* current = &app;
    const CLI::Option* before = nullptr;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        for (const CLI::App* sub : subcommands(*current)) {
            current = sub->get_name() == words[i] ? sub : current;
        }
        before = words[i].starts_with("-") ? current->get_option_no_throw(words[i]) : nullptr;
    }
    std::vector<std::string> all;
    if (before != nullptr && takes_value(*before)) {
        const std::string values = before->get_type_name();
        for (std::size_t from = 0; values.find('|') != std::string::npos && from < values.size();) {
            const std::size_t bar = std::min(values.find('|', from), values.size());
            all.push_back(values.substr(from, bar - from));
            from = bar + 1;
        }
    } else if (now.starts_with("-")) {
        for (const CLI::Option* option : current->get_options()) {
            const auto names = names_of(*option);
            all.insert(all.end(), names.begin(), names.end());
        }
    } else {
        for (const CLI::App* sub : subcommands(*current)) {
            all.push_back(sub->get_name());
        }
        if (const std::string_view folder = shipped_folder(*current); !folder.empty()) {
            all = shipped_names(folder);
        }
        if (takes_words(*current)) {
            for (const scene::Key& key : scene::keys_of_scene()) {
                all.push_back(std::string(key.name) + "=");
            }
        }
    }
    std::erase_if(all, [&](const std::string& word) {
        return !word.starts_with(now) || word == "hard-cases"; // no recipe
    });
    return all;
}

} // namespace edgeproof::cli
