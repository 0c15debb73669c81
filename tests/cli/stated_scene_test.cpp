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

// a^3 = 3 P R/(4 E*) for a sphere (`johnson1985`, equation (4.22)), a^2 = 2 P/(pi E* phi) for a
// cone
// (`sneddon1965`); P = E* phi a is the integral of a wedge's pressure, (E* phi/pi) arcosh(a/|x|).
TEST_CASE("the size of a sphere, a cone and a wedge by hand") {
    const double pi = std::acos(-1.0);
    const std::pair<const char*, double> all[] = {
        {"--sphere --R 10", std::cbrt(3.0 * 7 * 10 / (4 * 3))},
        {"--sphere --R1 20 --R2 20", std::cbrt(3.0 * 7 * 10 / (4 * 3))},
        {"--cone --phi 0.1", std::sqrt(2 * 7 / (pi * 3 * 0.1))},
        {"--wedge --phi 0.1", 7 / (3 * 0.1)},
    };
    for (const auto& each : all) {
        const auto& profile = each.first;
        const auto& a = each.second;
        CAPTURE(profile);
        const Folder folder;
        const Outcome o = run(folder, std::string("pressure ") + profile +
                                          " --P 7 --contact-modulus 3 --u 0.1 --format json");
        REQUIRE(o.code == 0);
        const auto json = nlohmann::json::parse(o.out);
        CHECK(std::abs(std::stod(json["a"]["value"].get<std::string>()) / a - 1) < 1e-14);
    }
}

// a^2 = 8 P R (1 - nu^2)/(pi E).
TEST_CASE("the half-width of a pad by hand") {
    const Folder folder;
    const Outcome o =
        run(folder, "pressure --hertz --R 100 --P 120 " + titanium + " --u 1e-3 --format json");
    REQUIRE(o.code == 0);
    const auto json = nlohmann::json::parse(o.out); // standard output has no other text
    const double a = std::sqrt(8 * 120 * 100 * (1 - 0.32 * 0.32) / (std::acos(-1.0) * 115e3));
    CHECK(std::abs(std::stod(json["a"]["value"].get<std::string>()) / a - 1) < 1e-14);
    CHECK(json["scene"] == "command line");
}

// p = E* sqrt(a^2 - x^2)/(2 R): 0.15 at x = 0.4, a = 1/2, R = E* = 1.
TEST_CASE("points on the command line replace those of the scene's file") {
    const Folder folder;
    const std::string contact =
        "[profile]\nkind = \"hertz\"\nR = 1\n[load]\na = \"1/2\"\ncontact_modulus = 1\n";
    folder.write("none.toml", contact);
    folder.write("other.toml", contact + "[ask]\nx = [0, \"a/4\"]\nprocess_zone = \"1e-2\"\n"
                                         "edges = [\"left\"]\ndigits = 12\n");
    const auto last = [](const std::string& csv) { return lines(table_of(csv)).back(); };
    for (const char* const scene : {"none.toml", "other.toml"}) {
        CAPTURE(scene);
        const std::string pressure = "pressure " + std::string(scene) + " --digits 12";
        const Outcome by_x = run(folder, pressure + " --x=-0.4 --edge left");
        CHECK(by_x.code == 0);
        CHECK(last(by_x.out).find(",0.150000000000,") != std::string::npos);
        const Outcome by_u = run(folder, pressure + " --u a/4,1/10 --edge right");
        CHECK(by_u.code == 0);
        CHECK(lines(table_of(by_u.out)).size() == 3);
        CHECK(last(by_u.out).find("right,0.1,") == 0);
        CHECK(last(by_u.out).find(",0.150000000000,") != std::string::npos);
        const Outcome zone = run(folder, "extent " + std::string(scene) +
                                             " --tolerance 1% --terms 1 --process-zone 0.9");
        CHECK(zone.code == 0);
        CHECK(zone.out.find("# process_zone: 0.9") != std::string::npos);
        const Outcome outside = run(folder, pressure + " --u 2 --edge right");
        CHECK(outside.code == 2);
        CHECK(outside.err.find(std::string(scene) + ": u = 2 from the right edge") == 0);
        CHECK(run(folder, pressure + " --u nowhere").err.find("edgeproof: u = \"nowhere\"") == 0);
    }
}

TEST_CASE("quantities that do not define a scene: one line") {
    const std::pair<const char*, const char*> all[] = {
        {"pressure", "edgeproof: no scene is given; name its file, - for standard input, or"},
        {"pressure --R 1", "edgeproof: no profile is given; add one of --power-law, --hertz"},
        {"pressure --hertz --power-law --R 1", "edgeproof: both --hertz and --power-law are given"},
        {"pressure s.toml --R 1", "edgeproof: a scene is given by its file and by quantities"},
        {"pressure --hertz --a 1 --contact-modulus 1 --u 0.1", "edgeproof: there is no radius"},
        {"pressure --hertz --R 1 --m 2 --a 1 --contact-modulus 1 --u 0.1", "edgeproof: "},
        {"pressure --hertz --R 1 --a 1 --P 1 --contact-modulus 1 --u 0.1",
         "edgeproof: both a and P are given"},
        {"pressure --hertz --R 1 --a 1 --u 0.1", "edgeproof: there is no contact_modulus"},
        {"pressure --hertz --R 1e --a 1 --contact-modulus 1 --u 0.1", "edgeproof: R = \"1e\""},
        {"pressure --hertz --R 1 --a 1 --contact-modulus 1 --u 0.1,,2", "edgeproof: u = \"\""},
        {"pressure --hertz --R 1 --a 1 --contact-modulus 1 --u 3",
         "command line: u = 3 from the right edge: the point lies outside the contact"},
        {"pressure --hertz --R 1 --a 1 --contact-modulus 1", "command line: the scene asks for no"},
        {"pressure --hertz --R '1\"\n[load]' --a 1 --contact-modulus 1 --u 1",
         "edgeproof: R holds"},
        {"pressure --hertz --R 1 --a 1 --contact-modulus 1 --u 1 --edge top", "edgeproof: "},
        {"extent s.toml --quantity slip", "edgeproof: --quantity slip: this command does not give "
                                          "the slip; write extent or contact"},
        {"pressure s.toml --quantity pessure",
         "edgeproof: --quantity pessure: unknown quantity 'pessure'; did you mean pressure?"},
    };
    for (const auto& [command, line] : all) {
        const std::string arguments = command; // CAPTURE takes no structured binding in clang
        CAPTURE(arguments);
        const Folder folder;
        folder.write("s.toml", "[profile]\nkind = \"hertz\"\nR = 1\n[load]\na = 1\n"
                               "contact_modulus = 1\n[ask]\nu = 1\ntolerance = \"1%\"\n");
        const Outcome o = run(folder, arguments);
        CHECK(o.code == 2);
        CHECK(o.out.empty());
        const auto said = lines(o.err);
        CAPTURE(o.err);
        REQUIRE(said.size() == 1);
        CHECK(said[0].rfind(line, 0) == 0);
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

// a^2 = 4 P R/(pi E*), 1/E* = 2 (1 - nu^2)/E for two equal bodies; Q = 0.6 f P (Johnson, Contact
// Mechanics, 4.2 and 7.2): the stick zone of a cylinder is sqrt(1 - 0.6) a.
TEST_CASE("--E and --nu are those of two equal bodies, --q-ratio is Q/(f P)") {
    const Folder folder;
    const std::string equal = "--hertz --R 100 --P 120 --E 115e3 --nu 0.32 ";
    const std::string two = "--hertz --R 100 --P 120 " + titanium + " ";
    CHECK(run(folder, "pressure " + equal + "--u 1e-3").out ==
          run(folder, "pressure " + two + "--u 1e-3").out);
    const auto slip = nlohmann::json::parse(
        run(folder, "slip " + equal + "--friction 0.5 --q-ratio 0.6 --digits 12 --format json")
            .out);
    CHECK(slip["Q/(f P)"]["value"] == "0.600000000000");
    const double a = std::stod(slip["a"]["value"].get<std::string>());
    const double stick = std::stod(slip["stick_a"]["value"].get<std::string>());
    CHECK(std::abs(stick / a - std::sqrt(0.4)) < 1e-10);
    const std::pair<const char*, const char*> wrong[] = {
        {"pressure --hertz --R 1 --a 1 --E 1 --u 0.1", "edgeproof: --E is given without --nu; "},
        {"pressure --hertz --R 1 --a 1 --E 1 --nu 0.3 --E1 1 --u 0.1",
         "edgeproof: --E and --E1 are both given; "},
        {"slip --hertz --R 1 --a 1 --contact-modulus 1 --q-ratio 0.6 --friction 1",
         "edgeproof: --q-ratio is given without --P; "},
        {"slip --hertz --R 1 --P 1 --contact-modulus 1 --q-ratio 0.6",
         "edgeproof: --q-ratio is given without --friction; "},
        {"slip --hertz --R 1 --P 1 --contact-modulus 1 --q-ratio 0.6 --Q 1 --friction 1",
         "edgeproof: --q-ratio and --Q are both given; "},
    };
    for (const auto& each : wrong) {
        const auto& command = each.first;
        const auto& begin = each.second;
        CAPTURE(command);
        const Outcome o = run(folder, command);
        CHECK(o.code == 2);
        CHECK(o.err.rfind(begin, 0) == 0);
        CHECK(lines(o.err).size() == 1);
    }
}

TEST_CASE("lists are separate words or joined by commas, and the scene may follow them") {
    const Folder folder;
    folder.write("s.toml", "[profile]\nkind = \"hertz\"\nR = 1\n[load]\na = 1\n"
                           "contact_modulus = 1\n");
    const std::string joined = run(folder, "pressure s.toml --u 0.1,0.2 --terms 1,2").out;
    CHECK(lines(table_of(joined)).size() == 3);
    for (const char* command :
         {"pressure s.toml --u 0.1 0.2 --terms 1 2", "pressure --terms 1 2 --u 0.1 0.2 s.toml",
          "pressure --u 0.1 0.2 --terms 1 2 s.toml",
          "pressure --u 0.1 --u 0.2 s.toml --terms 1 2"}) {
        CAPTURE(command);
        CHECK(run(folder, command).out == joined);
    }
    const std::string stated = " --hertz --R 1 --a 1 --contact-modulus 1 --digits 8";
    CHECK(run(folder, "pressure --x -0.5 0.5" + stated).out ==
          run(folder, "pressure --x=-0.5,0.5" + stated).out);
}

TEST_CASE("advice for a scene by its quantities names options, not keys of a file") {
    const Folder folder;
    const std::string contact = " --hertz --R 1 --a 1 --contact-modulus 1";
    const std::pair<std::string, const char*> all[] = {
        {"pressure" + contact, "; add --u 1e-3 0.1 (distances from the edge)\n"},
        {"extent" + contact, "; add --tolerance 1%\n"},
        {"slip" + contact, "; add --friction 0.6, in addition to --Q\n"},
        {"displacement" + contact, "; give --x 0 2\n"},
        {"stress" + contact, "; give --point 0,1/2 (x, z)\n"},
        {"pressure --hertz --R 1 --contact-modulus 1 --u 0.1",
         "; give one of --a ... and --P ...\n"},
        {"pressure --hertz --R 1 --a 1 --u 0.1",
         "; add --contact-modulus ... (E*), or --E and --nu of two equal bodies, or --E1, --nu1, "
         "--E2 and --nu2\n"},
        {"pressure --quantity shear --u 0.1" + contact, "; add --Q or --bulk-tension\n"},
    };
    for (const auto& each : all) {
        const auto& command = each.first;
        const auto& end = each.second;
        CAPTURE(command);
        const Outcome o = run(folder, command);
        CHECK(o.code == 2);
        CAPTURE(o.err);
        CHECK(o.err.ends_with(end));
        CHECK(o.err.find('[') == std::string::npos);
        CHECK(lines(o.err).size() == 1);
    }
}

TEST_CASE("a whole number is refused as a tolerance: it is a slip for a percentage") {
    const Folder folder;
    folder.write("m.csv", "x,p\n-0.5,0.4\n0,0.5\n0.5,0.4\n");
    folder.write("s.toml", "[profile]\nkind = \"hertz\"\nR = 1\n[load]\na = 1\n"
                           "contact_modulus = 1\n");
    for (const char* command : {"extent s.toml", "plot s.toml --out p.svg", "compare s.toml m.csv",
                                "extent --hertz --R 1 --a 1 --contact-modulus 1"}) {
        CAPTURE(command);
        const Outcome one = run(folder, std::string(command) + " --tolerance 1");
        CHECK(one.code == 2);
        CHECK(one.err == "edgeproof: --tolerance 1 is 100 %; write 1% or 0.01\n");
        CHECK(run(folder, std::string(command) + " --tolerance 2.5").err ==
              "edgeproof: --tolerance 2.5 is 250 %; write 2.5% or 0.025\n");
    }
    CHECK(run(folder, "extent s.toml --tolerance 100% --digits 4 --terms 1").code == 0);
    CHECK(run(folder, "extent s.toml --tolerance 0.99 --digits 4 --terms 1").code == 0);
}
