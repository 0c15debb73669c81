// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/hertz_ledger.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <regex>

using namespace edgeproof::test;

namespace {

const std::string flat = "[profile]\nkind = \"flat-and-rounded\"\nt = \"0.4\"\nR = \"1\"\n";
const std::string pressed = "[load]\na = \"1\"\ncontact_modulus = \"1\"\n";
const std::string asked = "[ask]\nu = [\"0.1\"]\nterms = 2\ntolerance = \"1%\"\n";
const std::string recipe = "[scenes.one]\nquantities = [\"p\"]\nu = [\"0.1\"]\n"
                           "load = { a = \"1\", contact_modulus = \"1\" }\n";

std::string pieces(const std::string& slope) {
    return "[profile]\nkind = \"piecewise\"\nknots = [\"0\"]\nslopes = [\"x\", \"" + slope +
           "\"]\n" + pressed + asked;
}
std::string with_a(const std::string& a) {
    return flat + "[load]\na = \"" + a + "\"\ncontact_modulus = \"1\"\n" + asked;
}
std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) {
        all += text;
    }
    return all;
}

/// Checks for "FILE:LINE: what is wrong; what to write instead" in one short line, exit status 2,
/// and no output.
void check_refusal(const Outcome& o, const std::string& place, const std::string& what) {
    CAPTURE(o.err);
    CHECK(o.code == 2);
    CHECK(o.out.empty());
    REQUIRE(lines(o.err).size() == 1);
    CHECK(o.err.size() < 1500);
    CHECK(o.err.rfind(place + ": ", 0) == 0);
    CHECK(has(o.err, what));
    CHECK(std::regex_search(o.err, std::regex("[^;]+; .*[a-z]")));
    for (const char c : o.err.substr(0, o.err.size() - 1)) {
        CHECK((static_cast<unsigned char>(c) >= 0x20U && c != '\x7f'));
    }
}

} // namespace

TEST_CASE("bad scenes: every command that reads one reports file, line, error and correction") {
    struct Bad {
        std::string scene;
        int line;
        std::string what;
    };
    const Bad all[] = {
        // numbers beyond the range, or without a value
        {with_a("2^(2^(2^64))"), 6, "beyond the range"},
        {with_a(repeated("sqrt(2)+", 300) + "1-300*sqrt(2)-1"), 6, "[...]"},
        {with_a("log(-1)"), 6, "log of a number that is not positive"},
        {with_a("1/(1-1)"), 6, "division by zero"},
        {with_a("integral(s,s,0,1)"), 6, "'integral' has no meaning here"},
        {with_a(repeated("1+", 8000) + "y"), 6, "[...]"},
        {flat + "[load]\na = \"1\"\nE1 = \"2^(2^(2^64))\"\nnu1 = \"0\"\nE2 = \"1\"\nnu2 = \"0\"\n",
         7, "beyond the range"},
        {"[profile]\nkind = \"flat-and-rounded\"\nt = \"2^(2^(2^64))\"\nR = \"1\"\n" + pressed, 3,
         "beyond the range"},
        // slopes
        {pieces("integral(s*x,s,0,1)"), 1, "'integral' has no meaning here"},
        {pieces("x/(1-1)"), 1, "division by zero"},
        {pieces("x*y"), 4, "unknown name 'y'"},
        {pieces("sqqrt(x)"), 4, "did you mean sqrt?"},
        // misspelt names
        {flat + pressed + "[ask]\nquantities = [\"presure\"]\n", 9, "did you mean pressure?"},
        {flat + "[load]\na = \"1\"\nconact_modulus = \"1\"\n", 7, "did you mean contact_modulus?"},
        {flat + pressed + "[ak]\n", 8, "did you mean ask?"},
        {"[profile]\nkind = \"flat-and-round\"\n" + pressed, 2, "did you mean flat-and-rounded?"},
        {flat + pressed + "[ask]\nroute = \"closed_form\"\n", 9, "did you mean closed-form?"},
        // units
        {with_a("70 GPa"), 6, "numbers have no units here"},
        {with_a("1mm"), 6, "numbers have no units here"},
        {with_a("2e3 N"), 6, "numbers have no units here"},
        {with_a("70*GPa"), 6, "numbers have no units here"},
        // knots in their original spelling
        {"[profile]\nkind = \"piecewise\"\nsymmetric = true\nknots = [\"2\", \"1\"]\n"
         "slopes = [\"0\", \"x\", \"x\"]\n" +
             pressed,
         1, ": 2 is followed by 1;"},
        {"[profile]\nkind = \"piecewise\"\nsymmetric = true\nknots = [\"1\", \"2\"]\n"
         "slopes = [\"0\", \"x - 1\", \"1/2\"]\n" +
             pressed,
         1, "across the knot x = 2;"},
        // files of another kind
        {recipe, 1, "this is a recipe, not a scene"},
        {hertz_head, 1, "this is a ledger, not a scene"},
        // deep or large input, and control characters
        {"x" + repeated(".x", 50'000) + " = 1\n", 1, "32 levels deep"},
        {flat + "x = " + repeated("[", 50'000) + "\n", 5, "32 levels deep"},
        {flat + pressed + "title = \"\\u001b[31m\"\n", 8, "control character"},
        {flat + pressed + "\"\x1b[31m\" = 1\n", 8, "not TOML"},
    };
    const Folder folder;
    for (const Bad& bad : all) {
        folder.write("s.toml", bad.scene);
        for (const char* command : {"pressure", "expand", "extent", "explain"}) {
            CAPTURE(command);
            CAPTURE(bad.scene.substr(0, 300));
            check_refusal(run(folder, std::string(command) + " s.toml"),
                          "s.toml:" + std::to_string(bad.line), bad.what);
        }
    }
}

TEST_CASE("bad recipes and ledgers: the same for every command that reads one") {
    struct Bad {
        std::vector<std::string> commands;
        std::string text;
        int line;
        std::string what;
    };
    const std::vector<std::string> recipes{"table f.toml", "points f.toml",
                                           "check f.toml --exec cat"};
    const std::vector<std::string> ledgers{"verify f.toml", "check --ledger f.toml"};
    const auto with = [](const std::string& line, const std::string& instead) {
        std::string text = hertz_head + hertz_claim("one", "Es*C/2*sqrt(a^2-x^2)");
        return text.replace(text.find(line), line.size(), instead);
    };
    const std::string power = "profile = { kind = \"power-law\", m = \"1\", C = \"1\" }\n";
    const Bad all[] = {
        {recipes, flat + pressed, 1, "this is a scene, not a recipe"},
        {recipes, hertz_head, 1, "this is a ledger, not a recipe"},
        {recipes, recipe + "profile = { kind = \"power-law\", m = \"1\", C = \"2^(2^(2^64))\" }\n",
         5, "beyond the range"},
        {recipes, recipe + power + "quantites = 1\n", 6, "did you mean quantities?"},
        {recipes, "rounding = \"nearset\"\n" + recipe + power, 1, "did you mean nearest?"},
        {recipes, recipe + "profile = { kind = \"power-law\", m = \"1\", C = \"1 GPa\" }\n", 5,
         "numbers have no units here"},
        {recipes, recipe + power + repeated("x.", 50'000) + "x = 1\n", 6, "32 levels deep"},
        {ledgers, flat + pressed, 1, "this is a scene, not a ledger"},
        {ledgers, recipe + power, 1, "this is a recipe, not a ledger"},
        {ledgers, with("m = [\"1\"]", "m = [\"2^(2^(2^64))\"]"), 4, "from zero"},
        {ledgers, with("m = [\"1\"]", "m = [\"1/(1-1)\"]"), 4, "division by zero"},
        {ledgers, with("Es = [\"7/3\"]", "Es = [\"70 GPa\"]"), 14, "numbers have no units here"},
        {ledgers, with("Es = [\"7/3\"]", "Es = [\"7/3\"]\n" + repeated("y.", 50'000) + "y = 1"), 15,
         "32 levels deep"},
        {ledgers, with("[ledger]", "[leger]"), 1, "did you mean ledger?"},
    };
    const Folder folder;
    for (const Bad& bad : all) {
        folder.write("f.toml", bad.text);
        for (const std::string& command : bad.commands) {
            CAPTURE(command);
            CAPTURE(bad.text.substr(0, 300));
            check_refusal(run(folder, command), "f.toml:" + std::to_string(bad.line), bad.what);
        }
    }
}

TEST_CASE(
    "files that cannot be read: a folder is not a missing file, and endless files are refused") {
    const Folder folder;
    std::filesystem::create_directory(folder.path() / "dir");
    for (const std::string command : {"pressure", "expand", "extent", "explain", "table", "points",
                                      "check", "verify", "check --ledger"}) {
        CAPTURE(command);
        check_refusal(run(folder, command + " dir"), "dir", "this is a folder, not a file");
        check_refusal(run(folder, command + " none"), "none", "there is no such file");
        if (command != "check") {
            check_refusal(run(folder, command + " /dev/zero"), "/dev/zero", "more than 10000000");
        }
    }
    folder.write("s.toml", flat + pressed);
    check_refusal(run(folder, "check s.toml"), "s.toml", "this is a TOML file");
}

TEST_CASE("the command line: an unknown word is named, with the near name") {
    const Folder folder;
    folder.write("s.toml", flat + pressed + asked);
    struct Bad {
        const char* arguments;
        const char* what;
    };
    for (const Bad& bad : {
             Bad{"presure s.toml", "unknown subcommand 'presure'; did you mean pressure?"},
             Bad{"bounds cuont", "unknown subcommand 'cuont'; did you mean count?"},
             Bad{"pressure s.toml --digit 5", "unknown option '--digit'; did you mean --digits?"},
             Bad{"pressure --fromat=md s.toml",
                 "unknown option '--fromat'; did you mean --format?"},
             Bad{"verify s.toml --recrod", "unknown option '--recrod'; did you mean --record?"},
             Bad{"bounds count --value 3", "unknown option '--value'; did you mean --values?"},
             Bad{"pressure", "no scene is given; name its file, - for standard input"},
             Bad{"pressure s.toml other", "other"},
             Bad{"pressure s.toml --format m", "--format m is no format; "},
             Bad{"pressure s.toml --digits 1e9", "--digits 1e9 is out of range; "},
             Bad{"pressure s.toml --digits \"$(printf '\\033[31m')\"", "\\x1b[31m"},
         }) {
        CAPTURE(bad.arguments);
        check_refusal(run(folder, bad.arguments), "edgeproof", bad.what);
    }
    check_refusal(run(folder, "pressure \"$(printf 'a\\033[31m\\nb')\""), "a\\x1b[31m b",
                  "there is no such file");
}
