// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::test;

namespace {

const std::string drawn_hertz =
    "title = \"A pad\"\n[units]\nlength = \"mm\"\npressure = \"MPa\"\n[profile]\nkind = \"hertz\"\n"
    "R = 1\n[load]\na = 1\ncontact_modulus = 1\n";

} // namespace

// The error of sqrt(2 u) for sqrt(u (2 - u)) is 1 % at u = 2 - 2/1.0201 = 0.0394079.
TEST_CASE("plot: every kind of file") {
    const Folder folder;
    folder.write("s.toml", drawn_hertz + "[ask]\nterms = [1, 2]\ntolerance = \"1%\"\n");
    const std::pair<const char*, const char*> files[] = {
        {"p.svg", "<svg"}, {"p.png", "PNG"}, {"p.pdf", "%PDF"}, {"p.html", "<!DOCTYPE html>"}};
    for (const auto& [name, begin] : files) {
        const char* const file = name; // clang's lambda in CAPTURE takes no structured binding
        CAPTURE(file);
        const Outcome o = run(folder, "plot s.toml --out " + std::string(file));
        CAPTURE(o.err);
        CHECK(o.code == 0);
        CHECK(o.out.empty());
        const std::string bytes = file_text(folder.path() / file);
        CHECK(has(bytes.substr(0, 400), begin));
    }
    for (const char* file : {"p.svg", "p.html"}) {
        const std::string bytes = file_text(folder.path() / file);
        CHECK(has(bytes, "[mm]"));
        CHECK(has(bytes, "[MPa]"));
        CHECK(has(bytes, "A pad"));
        CHECK(has(bytes, "1 term"));
        CHECK(has(bytes, "u = 0.0394"));
    }
    CHECK(run(folder, "extent s.toml --digits 8 --figure e.svg").code == 0);
    CHECK(has(file_text(folder.path() / "e.svg"), "leaves it at"));
}

TEST_CASE("plot: shear, corners, both edges") {
    const Folder folder;
    folder.write("q.toml", drawn_hertz + "[shear]\nQ = \"0.1\"\nfriction = \"0.6\"\n");
    folder.write("w.toml", "[profile]\nkind = \"tilted-wedge\"\nphi = \"0.1\"\nalpha = \"0.02\"\n"
                           "[load]\nP = 1\ncontact_modulus = 1\n");
    CHECK(run(folder, "plot q.toml --terms 1 --out q.svg").code == 0);
    CHECK(has(file_text(folder.path() / "q.svg"), "q, exact"));
    CHECK(run(folder, "plot w.toml --edge both --terms 1,2 --tolerance 5% --out w.svg").code == 0);
    CHECK(has(file_text(folder.path() / "w.svg"), "left edge"));
}

TEST_CASE("plot: a stress along a line") {
    const Folder folder;
    folder.write("s.toml", drawn_hertz + "[shear]\nQ = \"0.1\"\n");
    // Under full stick sxx is infinite at the edges x = -1 and x = 1.
    for (const char* line :
         {"--from 0,0 --to 0,2", "--from -2,0 --to 2,0", "--from -1,0 --to 1,1"}) {
        CAPTURE(line);
        const Outcome o =
            run(folder, "plot s.toml --field sxx --body B --out l.svg " + std::string(line));
        CAPTURE(o.err);
        CHECK(o.code == 0);
        const std::string svg = file_text(folder.path() / "l.svg");
        CHECK(has(svg, "sxx in body B"));
        CHECK(has(svg, "[MPa]"));
    }
}

TEST_CASE("plot: an error in one line for scenes that it does not draw") {
    const Folder folder;
    folder.write("s.toml", drawn_hertz);
    for (const char* arguments :
         {"plot s.toml", "plot s.toml --out p.gif", "plot s.toml --out p",
          "extent s.toml --tolerance 1% --figure p.txt", "plot s.toml --tolerance 0",
          "plot nowhere.toml --out p.svg", "plot s.toml --field sxx --from 0,1",
          "plot s.toml --from 0,1 --to 0,2", "plot s.toml --field sxx --from 0,1 --to 0,1",
          "plot s.toml --field sxx --from 0,-1 --to 0,1",
          "plot s.toml --field mises --from 0,1 --to 0,2",
          "plot s.toml --field p --from 0,1 --to 0,2"}) {
        CAPTURE(arguments);
        const Outcome o = run(folder, arguments);
        CHECK(o.code == 2);
        CHECK(o.out.empty());
        CHECK(lines(o.err).size() == 1);
        CHECK(folder.files() == 1);
    }
}
