// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>

using namespace edgeproof::test;

namespace {

const std::string titanium = "--E1 115e3 --nu1 0.32 --E2 115e3 --nu2 0.32";

/// Returns the table without the facts, one of which is the name of the scene.
std::string table_of(const std::string& csv) {
    std::string table;
    for (const std::string& line : lines(csv)) {
        table += line.rfind('#', 0) == 0 ? "" : line + "\n";
    }
    return table;
}

} // namespace

TEST_CASE("a scene by its quantities: the equivalent scene file is printed, and gives the same") {
    const std::string all[] = {
        "pressure --hertz --R 100 --P 120 " + titanium + " --u 1e-3,a/2 --terms 1,2 --digits 20",
        "pressure --cylinder-on-flat --R 1 --a 1 --contact-modulus 1 --x 0",
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
        CHECK(table_of(again.out) == table_of(o.out));
        CHECK(lines(table_of(o.out)).size() > 1);
    }
}

TEST_CASE("--edge, --terms and --quantity are the same in every command; [ask] edges is honoured") {
    const Folder folder;
    folder.write("s.toml",
                 "[profile]\nkind = \"hertz\"\nR = 1\n[load]\na = 1\ncontact_modulus = 1\n"
                 "[shear]\nQ = \"0.1\"\nfriction = \"0.6\"\n[ask]\nedges = [\"left\"]\n"
                 "u = \"1/10\"\nterms = 1\ntolerance = \"1%\"\n");
    for (const char* command : {"pressure", "expand", "extent", "slip"}) {
        CAPTURE(command);
        const auto edges = [&](const std::string& options) {
            const Outcome o = run(folder, std::string(command) + " s.toml --digits 6 " + options);
            CHECK(o.code == 0);
            const std::string table = table_of(o.out);
            return std::pair(has(table, "\nright,"), has(table, "\nleft,"));
        };
        CHECK(edges("") == std::pair(false, true));
        CHECK(edges("--edge right") == std::pair(true, false));
        CHECK(edges("--edge both --terms 1,2") == std::pair(true, true));
        CHECK(has(run(folder, std::string(command) + " s.toml --quantity contact --digits 6 " +
                                  "--format json")
                      .out,
                  "\"P\""));
    }
    CHECK(run(folder, "explain s.toml --edge right --terms 2 --quantity extent").code == 0);
}

TEST_CASE("a scene, a recipe and a ledger from standard input") {
    const Folder folder;
    folder.write("s.toml",
                 "[profile]\nkind = \"hertz\"\nR = 1\n[load]\na = 1\ncontact_modulus = 1\n"
                 "[ask]\nu = [\"1/10\", \"1/2\"]\n");
    folder.write("bad.toml", "[profile]\nkind = \"hertz\"\nR = 1\n[load]\ncontact_modulus = 1\n");
    const auto piped = [&](const std::string& file, const std::string& arguments) {
        const std::string out = (folder.path() / "out").string();
        const std::string err = (folder.path() / "err").string();
        const int status =
            std::system(("cat '" + (folder.path() / file).string() + "' | '" + program().string() +
                         "' " + arguments + " >'" + out + "' 2>'" + err + "'")
                            .c_str());
        return Outcome{WEXITSTATUS(status), file_text(out), file_text(err)};
    };
    const Outcome o = piped("s.toml", "pressure -");
    CHECK(o.code == 0);
    CHECK(table_of(o.out) == table_of(run(folder, "pressure s.toml").out));
    CHECK(piped("bad.toml", "pressure -").err ==
          "stdin:4: neither a nor P is given; give one of a = \"...\" and P = \"...\"\n");
    CHECK(piped("bad.toml", "verify -").code == 2);
    CHECK(piped("bad.toml", "points -").err.rfind("stdin:", 0) == 0);
    CHECK(piped("s.toml", "check - --recipe -").code == 2);
    CHECK(run(folder, "pressure -").err.rfind("stdin", 0) == 0); // there is no input
}
