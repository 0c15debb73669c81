// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/scene_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace edgeproof::cli {
namespace {

/// Names of tolerances in addition to that of p.
constexpr std::string_view others[] = {"a", "P", "c0", "q", "surface"};

void check_tolerance(const std::string& option, const std::string& text) {
    refuse_whole_tolerance(option, text);
    try {
        (void)scene::parse_tolerance(text);
    } catch (const InputError& error) {
        throw InputError(option + " " + text + ": " + error.problem(),
                         "write it as 3%, 0.03 or 3/100");
    }
}

/// The options of report::compare_results.
std::map<std::string, std::string, std::less<>> comparison_options(const Options& o) {
    std::map<std::string, std::string, std::less<>> asked{
        {"columns", o["--columns"]}, {"scale", o["--scale"]},
        {"origin", o["--origin"]},   {"partial", o.has("--partial") ? "yes" : ""},
        {"of", o["--of"]},           {"edge_zone", o["--edge-zone"]}};
    std::map<std::string, std::string> given;
    for (const std::string_view name : others) { // the older spelling
        given.emplace(name, o["--tolerance-" + std::string(name)]);
    }
    for (const std::string& part :
         o["--tolerance"].empty() ? std::vector<std::string>{} : parts_of(o["--tolerance"])) {
        const std::size_t equals = part.find('=');
        const std::string name = equals == std::string::npos ? "p" : part.substr(0, equals);
        given[name] = equals == std::string::npos ? part : part.substr(equals + 1);
    }
    for (const auto& [name, text] : given) {
        if (!text.empty()) {
            check_tolerance(name == "p" ? "--tolerance" : "--tolerance-" + name, text);
            require(name == "p" || std::ranges::find(others, name) != std::end(others),
                    "--tolerance " + o["--tolerance"] + ": there is no " + name,
                    "write p, a, P, c0, q or surface, such as p=3%,a=1%");
            asked[name == "p" ? "tolerance" : "tolerance_" + name] = text;
        }
    }
    return asked;
}

} // namespace

int compare(Options& o) {
    const bool json = o.has("--json") || text_or_json(o["--format"]);
    io::check_output(o["--out"]);
    std::vector<std::string> words{o["scene"]};
    std::vector<std::string> files;
    for (const std::string& word : o.list("results")) {
        (scene::key_length(word) == std::string::npos ? files : words).push_back(word);
    }
    require(!o["scene"].empty() && !files.empty(),
            o["scene"].empty() ? "no scene is given" : "no result is given",
            "write edgeproof compare SCENE.toml RESULT.csv");
    const auto asked = comparison_options(o);
    scene::Scene scene = read_scene(given_scene(words, shipped_scenes));
    choose_step(scene, o["--step"]);
    std::vector<std::pair<std::string, std::string>> results;
    for (const std::string& file : files) {
        results.emplace_back(io::read_text(file, "result (a table of x and p)"), file);
    }
    std::function<void(std::size_t, std::size_t)> progress;
    const std::string name = fmt::format("{}", fmt::join(words, " "));
    const report::ComparedResults found = with_progress("files", progress, [&] {
        return report::compare_results(progress, scene, name, results, asked);
    });
    const std::string text = json ? found.json : printable_lines(found.text);
    const bool printed = o["--out"].empty() || o["--out"] == "-";
    const std::string end = json || printed ? "" : "program: " + report::program_line() + "\n";
    io::write_output(printed ? "-" : o["--out"], text + end);
    return found.passes ? 0 : 1;
}

} // namespace edgeproof::cli
