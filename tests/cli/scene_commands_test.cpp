// SPDX-License-Identifier: GPL-3.0-or-later
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

struct Bad {
    const char* command;
    std::string scene;
    const char* line;
};

} // namespace

TEST_CASE("bad input: one line that names file, line and remedy; exit 2; no file") {
    const Bad all[] = {
        {"pressure s.toml", profile + "[load]\na = \"1\"\nP = \"1\"\ncontact_modulus = \"1\"\n",
         "s.toml:7: both a and P are given; give one of a = \"...\" and P = \"...\""},
        {"pressure s.toml", profile + "[load]\ncontact_modulus = \"1\"\n",
         "s.toml:5: neither a nor P is given; give one of a = \"...\" and P = \"...\""},
        {"pressure s.toml", profile + load + "[shear]\n[ask]\nu = \"0.1\"\n",
         "s.toml:8: the shear section has no load; add Q = \"...\" or bulk_tension = \"...\", or "
         "leave [shear] out"},
        {"pressure s.toml", profile + load + "[ask]\nedges = [\"top\"]\nu = \"0.1\"\n",
         "s.toml:9: there is no edge 'top'; write \"right\" or \"left\""},
        {"pressure s.toml", profile + load + "[ask]\nu = [\"0.1\",\n  \"2.5\"]\n",
         "s.toml:10: u = 2.5 from the right edge: the point lies outside the contact; give "
         "distances from the edge, 0 < u < a + b, off every corner"},
        {"pressure s.toml", profile + load + "[ask]\nu = \"0.1\"\nterms = -1\n",
         "s.toml:10: terms = -1 is out of range; write a whole number from 1 to 400"},
        {"extent s.toml", profile + load + "[ask]\ntolerance = \"1%\"\nprocess_zone = \"-0.1\"\n",
         "s.toml:10: process_zone = -0.1 is not positive; give the length of the process zone, or "
         "leave it out"},
        {"extent s.toml", profile + load + "[ask]\ntolerance = 0\n",
         "s.toml:9: a tolerance of 0 is not positive; give a tolerance > 0, such as 1%"},
        {"extent s.toml --tolerance 1e-61", profile + load,
         "edgeproof: --tolerance 1e-61: a tolerance of 1e-61 is out of range; give one from 1e-60 "
         "to 1e6, such as 1%"},
        {"extent s.toml --tolerance 1e9%", profile + load,
         "edgeproof: --tolerance 1e9%: a tolerance of 1e9% is out of range; give one from 1e-60 to "
         "1e6, such as 1%"},
        {"slip --power-law --m 1e-40 --C 1 --a 1 --contact-modulus 1 --Q 1 --friction 1", profile,
         "edgeproof: the power-law exponent m = 1e-40 is out of range; give 0 (a wedge), or a "
         "number from 1e-10 to 1000000"},
        {"slip --power-law --m 1001 --C 1 --a 1 --contact-modulus 1 --Q 1 --bulk-tension 1 "
         "--friction 1",
         profile,
         "edgeproof: slip under a bulk tension is not found for an exponent m > 1000; leave "
         "--friction or the bulk tension out, or give a lower m"},
        {"pressure --tilted-wedge --phi 10^10^10 --alpha 0.1 --P 1 --contact-modulus 1 --u 0.1",
         profile,
         "edgeproof: phi = \"10^10^10\": '10^10^10' is beyond the range of numbers; write a number "
         "between 1e-100000 and 1e100000"},
        {"extent s.toml --tolerance 0", profile + load,
         "edgeproof: --tolerance 0: a tolerance of 0 is not positive; give a tolerance > 0, such "
         "as 1%"},
        {"extent s.toml", profile + load,
         "s.toml: no tolerance is given; add --tolerance 1%, or tolerance = \"1%\" to [ask]"},
        {"expand s.toml --terms -1", profile + load,
         "edgeproof: --terms -1 is out of range; give a whole number from 1 to 400"},
        {"expand s.toml --edge top", profile + load,
         "edgeproof: --edge top: there is no such edge; write right, left or both"},
        {"pressure s.toml --digits 0", profile + load + "[ask]\nu = \"0.1\"\n",
         "edgeproof: --digits 0 is out of range; give a whole number from 2 to 100000"},
        {"pressure s.toml --format xls", profile + load + "[ask]\nu = \"0.1\"\n",
         "edgeproof: --format xls is no format; write csv, json, md or tex"},
        {"pressure s.toml --round off", profile + load + "[ask]\nu = \"0.1\"\n",
         "edgeproof: --round off is no way to round; write nearest, down or up"},
        {"explain s.toml", profile + load + "[ask]\nu = \"x\"\n", "s.toml:9: "},
        {"pressure nowhere.toml", profile,
         "nowhere.toml: there is no such file; give the path of a scene (TOML)"},
    };
    for (const Bad& bad : all) {
        CAPTURE(bad.command);
        CAPTURE(bad.line);
        const Folder folder;
        folder.write("s.toml", bad.scene);
        const Outcome o = run(folder, std::string(bad.command) + " --out result.csv");
        CHECK(o.code == 2);
        CHECK(o.out.empty());
        const auto said = lines(o.err);
        REQUIRE(said.size() == 1);
        CHECK(said[0].rfind(bad.line, 0) == 0);
        CHECK(folder.files() == 1); // only the scene
    }
}

TEST_CASE("pressure: the columns, the order, and Hertz to the last digit") {
    const Folder folder;
    folder.write("s.toml", profile + load +
                               "[ask]\nedges = [\"left\", \"right\"]\n"
                               "terms = [1, 2]\nu = [\"2/5\", \"0.2\"]\n");
    const Outcome o = run(folder, "pressure s.toml --digits 20");
    CHECK(o.code == 0);
    CHECK(o.err.empty());
    const auto table = rows(o.out);
    REQUIRE(table.size() == 5);
    CHECK(table[0] == "edge,u,x,p,p_bound,route,local_1,rel_1,local_2,rel_2");
    // p = sqrt(u (2 - u))/2 (3-4-5 triangle); local_1 = sqrt(2u)/2.
    const char* const begins[] = {
        "left,0.4,-0.60000000000000000000,0.40000000000000000000,",
        "left,0.2,-0.80000000000000000000,0.30000000000000000000,",
        "right,0.4,0.60000000000000000000,0.40000000000000000000,",
        "right,0.2,0.80000000000000000000,0.30000000000000000000,",
    };
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(table[i + 1].rfind(begins[i], 0) == 0);
    }
    CHECK(table[1].find(",closed-form,0.44721359549995793928,") != std::string::npos);
}

TEST_CASE("with shear the columns of q follow") {
    const Folder folder;
    folder.write("s.toml", profile + load + shear + "[ask]\nterms = 3\nu = \"0.1\"\n");
    const Outcome o = run(folder, "pressure s.toml --digits 10 --binary64");
    CHECK(o.code == 0);
    CHECK(rows(o.out).at(0) ==
          "edge,u,x,p,p_bound,route,p_binary64,local_3,rel_3,q,q_bound,q_route,q_binary64,"
          "q_local_3,q_rel_3");
}

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

TEST_CASE("--out writes the same bytes, whole") {
    const Folder folder;
    folder.write("s.toml", profile + load + "[ask]\nu = \"0.1\"\n");
    const Outcome o = run(folder, "pressure s.toml --out new/p.csv");
    CHECK(o.code == 0);
    CHECK(o.out.empty());
    CHECK(file_text(folder.path() / "new" / "p.csv") == run(folder, "pressure s.toml").out);
}

TEST_CASE("expand: both edges, Hertz by hand") {
    const Folder folder;
    // a = 2: p = sqrt(u) sqrt(1 - u/4)
    folder.write("s.toml", profile + "[load]\na = \"2\"\ncontact_modulus = \"1\"\n");
    const auto table = rows(run(folder, "expand s.toml --terms 3 --digits 10").out);
    REQUIRE(table.size() == 7);
    CHECK(table[0] == "edge,coefficient,k,power,value,bound,route");
    CHECK(table[1].rfind("right,c_0,0,1/2,1.000000000,", 0) == 0);
    CHECK(table[2].rfind("right,c_1,1,3/2,-0.1250000000,", 0) == 0);
    CHECK(table[3].rfind("right,c_2,2,5/2,-0.007812500000,", 0) == 0);
    CHECK(table[4].rfind("left,c_0,0,1/2,1.000000000,", 0) == 0);
    CHECK(rows(run(folder, "expand s.toml --edge left").out).size() == 4);
}

TEST_CASE("extent: Hertz by hand, and the process zone answered") {
    const Folder folder;
    folder.write("s.toml", profile + load + "[ask]\nterms = 1\nprocess_zone = \"0.04\"\n");
    const Outcome o = run(folder, "extent s.toml --tolerance 1% --digits 12 --format json");
    CHECK(o.code == 0);
    const auto json = nlohmann::json::parse(o.out);
    REQUIRE(json["rows"].size() == 2);
    // 2 (1 - 1.01^-2) = 402/10201 = 0.03940790118615822..., half of it 0.01970395059307911...
    CHECK(json["rows"][0]["first_exit"] == "0.0394079011862");
    CHECK(json["rows"][0]["first_exit_fraction"] == "0.0197039505931");
    CHECK(json["rows"][0]["covers_zone"] == "no");
    CHECK(json["rows"][1]["edge"] == "left");
}

TEST_CASE(
    "explain: each effect that is off has a reason; after a run the effects used are listed, too") {
    const Folder folder;
    folder.write("s.toml", profile + load + "[ask]\nu = \"0.1\"\n");
    const Outcome plan = run(folder, "explain s.toml");
    CHECK(plan.code == 0);
    CHECK(plan.out.find("b = a: symmetric") != std::string::npos);
    CHECK(plan.out.find("there is no [shear]") != std::string::npos);
    CHECK(plan.out.find("quadratures: 0") != std::string::npos);
    const Outcome done = run(folder, "explain s.toml --run");
    CHECK(done.code == 0);
    CHECK(done.out.find("done as planned: yes") != std::string::npos);
}

// An edge on a knot, which cannot be proved (scene/on_knot_test.cpp): p is proved, its series is
// not.
TEST_CASE("a value that is not proved is marked in every format, and explain --run counts it") {
    const Folder folder;
    folder.write("s.toml",
                 "[profile]\nkind = \"piecewise\"\nsymmetric = true\nknots = [\"1/3\", \"1\"]\n"
                 "slopes = [\"0\", \"x - 1/3\", \"3*x - 7/3\"]\n[load]\n"
                 "P = \"(atan(sqrt(8)) - sqrt(8)/9)/2\"\ncontact_modulus = \"1\"\n[ask]\n"
                 "u = \"0.1\"\nterms = [1]\nedges = [\"right\"]\ndigits = 6\n");
    for (const char* format : {"csv", "json", "md", "tex"}) {
        CAPTURE(format);
        const Outcome o = run(folder, std::string("pressure s.toml --format ") + format);
        CHECK(o.code == 0);
        std::string text = o.out;
        text.erase(std::remove(text.begin(), text.end(), '\\'), text.end()); // TeX's local\_1
        CHECK(text.find("closed-form (estimate: local_1, rel_1)") != std::string::npos);
    }
    const Outcome done = run(folder, "explain s.toml --run");
    CHECK(done.code == 1);
    CHECK(done.out.find("done as planned: no") != std::string::npos);
    CHECK(done.out.find("estimated: 2 values") != std::string::npos);
    folder.write("s.toml", profile + load + "[ask]\nu = \"0.1\"\nterms = [1]\n");
    const Outcome proved = run(folder, "explain s.toml --run");
    CHECK(proved.code == 0);
    CHECK(proved.out.find("- bounds: proved: ") != std::string::npos);
    CHECK(proved.out.find("estimated") == std::string::npos);
}

TEST_CASE("extent: without a first exit in the part there is no number") {
    const Folder folder;
    folder.write("s.toml", profile + load + "[ask]\nterms = 1\npart = [\"0\", \"1/100\"]\n");
    const std::string command = "extent s.toml --tolerance 1% --digits 8 --edge right";
    const Outcome csv = run(folder, command);
    CHECK(csv.out.find("# no first_exit: ") != std::string::npos);
    CHECK(rows(csv.out).at(1).rfind("right,1,,,,0.020000000,", 0) == 0);
    const auto json = nlohmann::json::parse(run(folder, command + " --format json").out);
    CHECK(json["rows"][0]["first_exit"].is_null());
    CHECK(json["rows"][0]["first_exit_fraction"].is_null());
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
    CHECK(commands == 17);
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

// (1e-6 + 5/3)/2 = 0.833333833..., (3e-6 + 5/3)/4 = 0.41666741666...
TEST_CASE("points between the ends of a range are decimals, the exact fractions with --exact") {
    const Folder folder;
    folder.write("s.toml",
                 profile + load + "[ask]\nu = { from = \"1e-6\", to = \"5/3\", points = 5 }\n");
    const auto places = [&](const std::string& options) {
        std::vector<std::string> list;
        for (const std::string& row :
             rows(run(folder, "pressure s.toml --digits 10" + options).out)) {
            const std::size_t from = row.find(',') + 1;
            list.push_back(row.substr(from, row.find(',', from) - from));
        }
        return list;
    };
    CHECK(places("") == std::vector<std::string>{"u", "1e-6", "0.4166674167", "0.8333338333",
                                                 "1.25000025", "1.666666667"});
    CHECK(places(" --exact") == std::vector<std::string>{"u", "1e-6", "5000009/12000000",
                                                         "5000003/6000000", "1.25000025", "5/3"});
    CHECK(places(" --round down").at(3) == "0.8333338333");
    CHECK(places(" --round up").at(3) == "0.8333338334");
    const auto json =
        nlohmann::json::parse(run(folder, "pressure s.toml --digits 10 --format json").out);
    CHECK(json["rows"][1]["u"] == "0.4166674167");
    CHECK(has(run(folder, "pressure s.toml --digits 10 --format tex").out, "$0.4166674167$"));
    // The places by x: a - x = 1 - 1/3, and the middle of 1/3 and 1/2 is 5/12.
    folder.write("x.toml",
                 profile + load + "[ask]\nx = { from = \"1/3\", to = \"1/2\", points = 3 }\n");
    const auto by_x = rows(run(folder, "pressure x.toml --digits 5").out);
    REQUIRE(by_x.size() == 4);
    CHECK(by_x[1].rfind("right,x = 1/3,0.66667,0.33333,", 0) == 0);
    CHECK(by_x[2].rfind("right,x = 0.41667,0.58333,0.41667,", 0) == 0);
    CHECK(by_x[3].rfind("right,x = 1/2,0.5,0.50000,", 0) == 0);
    const auto gaps = rows(run(folder, "displacement x.toml --digits 5").out);
    REQUIRE(gaps.size() == 4);
    CHECK(gaps[1].rfind("0.33333,", 0) == 0);
    CHECK(gaps[2].rfind("0.41667,", 0) == 0);
}
