// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

using namespace edgeproof::test;

namespace {

const std::string profile = "[profile]\nkind = \"power-law\"\nm = \"1\"\nC = \"1\"\n";
const std::string load = "[load]\na = \"1\"\ncontact_modulus = \"1\"\n";
const std::string shear = "[shear]\nQ = \"0.3\"\n";

/// Returns the rows without notes.
std::vector<std::string> rows(const std::string& csv) {
    std::vector<std::string> list;
    for (const std::string& line : lines(csv)) {
        if (line.rfind('#', 0) != 0) {
            list.push_back(line);
        }
    }
    return list;
}

} // namespace

TEST_CASE("every format holds the same digits") {
    const Folder folder;
    folder.write("s.toml", profile + load + "[ask]\nterms = 1\nu = [\"0.2\", \"1e-30\"]\n");
    const auto csv = rows(run(folder, "pressure s.toml").out);
    const auto json = nlohmann::json::parse(run(folder, "pressure s.toml --format json").out);
    REQUIRE(json["rows"].size() == 2);
    CHECK(json["a"]["route"] == "given");
    for (std::size_t i = 0; i < 2; ++i) {
        const auto& row = json["rows"][i];
        std::string joined;
        for (const char* key : {"edge", "u", "x", "p", "p_bound", "route", "local_1", "rel_1"}) {
            joined += (joined.empty() ? "" : ",") + row[key].get<std::string>();
        }
        CHECK(joined == csv[i + 1]);
    }
    const Outcome md = run(folder, "pressure s.toml --format md");
    const auto shown = lines(md.out);
    std::size_t width = 0;
    std::size_t tabular = 0;
    for (const std::string& line : shown) {
        if (line.rfind('|', 0) == 0) {
            width = width == 0 ? line.size() : width;
            CHECK(line.size() == width); // aligned
            ++tabular;
        }
    }
    CHECK(tabular == 4);
    CHECK(md.out.find(json["rows"][1]["p"].get<std::string>()) != std::string::npos);
    const Outcome tex = run(folder, "pressure s.toml --format tex --digits 5");
    for (const char* part : {"\\begin{tabular}", "\\toprule", "\\midrule", "\\bottomrule",
                             "p\\_bound", "\\times 10^{-16}$", "\\end{tabular}"}) {
        CAPTURE(part);
        CHECK(tex.out.find(part) != std::string::npos);
    }
}

TEST_CASE("--verbose shows what was computed on stderr, and changes nothing else") {
    const Folder folder;
    folder.write("s.toml", profile + load + "[ask]\nu = [\"0.1\", \"0.2\"]\n");
    const Outcome quiet = run(folder, "pressure s.toml");
    const Outcome verbose = run(folder, "pressure s.toml --verbose");
    CHECK(verbose.out == quiet.out);
    CHECK(quiet.err.empty());
    for (const char* line : {"\np: 2 values, 2 proved, at most ", ", closed-form\n"}) {
        CHECK(("\n" + verbose.err).find(line) != std::string::npos);
    }
}

TEST_CASE("without places the rows are the values of the whole contact") {
    // Hertz: a^2 = 4 P R/(pi E*) and p_max = 2 P/(pi a)
    const Folder folder;
    const char* const scene =
        " kind=hertz R=1 P=pi/4 contact_modulus=1 --digits 3 --no-notes --format json";
    for (const char* const command : {"pressure", "compute", "compute pressure"}) {
        std::string all;
        const auto json = nlohmann::json::parse(run(folder, command + std::string(scene)).out);
        for (const auto& row : json["rows"]) {
            all += row["quantity"].get<std::string>() + " " + row["value"].get<std::string>() + ";";
        }
        CHECK(all == "a 1.00;b 1.00;P 0.785;M 0;p_max 0.500;");
    }
}

TEST_CASE("a pressure by a second route is marked as an estimate in every format") {
    const Folder folder;
    folder.write("s.toml", profile + load +
                               "[ask]\nu = \"0.1\"\nterms = [1]\nedges = [\"right\"]\n"
                               "digits = 6\nroute = \"singular-integral\"\n");
    for (const char* format : {"csv", "json", "md", "tex"}) {
        CAPTURE(format);
        const Outcome o = run(folder, std::string("pressure s.toml --format ") + format);
        CHECK(o.code == 0);
        CHECK(o.out.find("singular-integral (estimate)") != std::string::npos);
    }
    const Outcome verbose = run(folder, "pressure s.toml --verbose");
    CHECK(verbose.err.find("p: 1 value, 0 proved") != std::string::npos);
}

TEST_CASE("every command that examples/README.md names runs") {
    const std::string text = file_text(source_dir() / "examples" / "README.md");
    const Folder folder;
    std::filesystem::create_directory_symlink(source_dir() / "examples",
                                              folder.path() / "examples");
    std::size_t commands = 0;
    const std::string start = "`edgeproof ";
    for (std::size_t at = text.find(start); at != std::string::npos;
         at = text.find(start, at + 1)) {
        const std::size_t from = at + start.size();
        const std::string command = text.substr(from, text.find('`', from) - from);
        if (command.find("examples/") == std::string::npos) {
            continue;
        }
        CAPTURE(command);
        const Outcome o = run(folder, command);
        CHECK(o.code == 0);
        CHECK(o.err.empty());
        ++commands;
    }
    CHECK(commands == 18);
}

// csv.DictReader and numpy.genfromtxt(names=True) take the first line for the header.
TEST_CASE("CSV: the header is the first line, facts and notes are behind the rows") {
    const Folder folder;
    folder.write("s.toml", "title = \"T\"\n" + profile + load + shear +
                               "[ask]\nu = \"0.2\"\nterms = 1\ntolerance = \"1%\"\n");
    for (const char* command : {"pressure", "expand", "extent"}) {
        CAPTURE(command);
        const std::string csv = run(folder, std::string(command) + " s.toml --digits 8").out;
        const auto all = lines(csv);
        const auto data = rows(csv);
        REQUIRE(all.size() > data.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            CHECK((all[i].rfind("# ", 0) == 0) == (i >= data.size()));
        }
        CHECK(all[0].rfind("edge,", 0) == 0);
        CHECK(all[data.size()] == "# T");
        CHECK(has(csv, "\n# program: edgeproof "));
        CHECK(has(csv, "\n# a: 1.0000000 +- 0 (given)\n"));
        const std::string bare =
            run(folder, std::string(command) + " s.toml --digits 8 --no-notes").out;
        CHECK(lines(bare) == data);
    }
    const auto json =
        nlohmann::json::parse(run(folder, "pressure s.toml --format json --no-notes").out);
    CHECK(json.size() == 1);
    CHECK(json["rows"].size() == 1);
    CHECK_FALSE(has(run(folder, "pressure s.toml --format md --no-notes").out, "program"));
    CHECK_FALSE(has(run(folder, "pressure s.toml --format tex --no-notes").out, "program"));
}

TEST_CASE("a scene as words, in both spellings: its file is printed, and gives the same") {
    const std::string all[] = {
        "pressure --hertz --R 100 --P 120 --E1 115e3 --nu1 0.32 --E2 115e3 --nu2 0.32 --u 1e-3,a/2 "
        "--terms 1,2 --digits 20",
        "pressure kind=cylinder-on-flat R=1 a=1 contact_modulus=1 x=0",
        "slip kind=hertz R=100 P=120 E=115e3 nu=0.32 friction=0.5 q_ratio=0.6 --digits 8",
        "pressure kind=piecewise symmetric=true knots=1/2 slopes=0,x-1/2 a=1 contact_modulus=1 "
        "u=0.1 --digits 10",
        "pressure --sphere --R1 2 --R2 3 --P 1 --contact-modulus 1 --u 0.1",
        "pressure --wedge --phi 0.1 --a 1 --contact-modulus 1 --u 0.1",
        "pressure --cone --phi 0.1 --delta 1/100 --contact-modulus 1 --u 0.01",
        "pressure --power-law --m 3/2 --C 1 --width 2 --contact-modulus 1 --u 0.1 --edge both",
        "extent --flat-and-rounded --flat-width 1 --R 1 --a 1 --contact-modulus 1 --tolerance 1% "
        "--terms 1 --digits 10",
        "expand --tilted-wedge --phi 0.1 --alpha=-0.02 --P 1 --contact-modulus 1 --digits 10",
        "slip --hertz --R1 1 --R2=-2 --P 1 --contact-modulus 1 --Q 0.1 --friction 0.6 --digits 8",
        "pressure --tilted-flat-and-rounded --t 1 --R 10 --P 1 --M=-0.5 --contact-modulus 1 --u "
        "0.1 --quantity pressure,contact --digits 10",
    };
    for (const std::string& arguments : all) {
        CAPTURE(arguments);
        const Folder folder;
        const Outcome o = run(folder, arguments + " --show-scene");
        CAPTURE(o.err);
        REQUIRE(o.code == 0);
        const Outcome quiet = run(folder, arguments);
        CHECK(quiet.err.empty());
        CHECK(quiet.out == o.out);
        folder.write("printed.toml", o.err);
        const Outcome again =
            run(folder, arguments.substr(0, arguments.find(' ')) + " printed.toml");
        CAPTURE(again.err);
        CHECK(again.code == 0);
        CHECK(again.err.empty());
        CHECK(rows(again.out) == rows(o.out));
        CHECK(rows(o.out).size() > 1);
    }
}
