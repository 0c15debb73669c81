// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/inputs.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

using namespace edgeproof::test;

namespace {

/// Returns a text with commands for a shell, HTML and Coq. If one is executed, the file
/// `marker` is made.
std::string hostile(const std::string& marker) {
    return "a `touch " + marker + "` $(touch " + marker + ") ' . system('touch " + marker +
           "') . ' *) \\\" (* <script>touch</script> \\\\";
}

/// Returns all files below the folder, except those in `inside`.
std::set<std::string> outside(const std::filesystem::path& folder, const std::string& inside) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string name = std::filesystem::relative(entry.path(), folder).string();
        if (!name.starts_with(inside)) {
            names.insert(name);
        }
    }
    return names;
}

const std::string plain_scene = R"([profile]
kind = "power-law"
m = "1"
C = "1"
[load]
a = "1"
contact_modulus = "1"
[ask]
edges = ["right"]
terms = 1
u = ["0.1"]
tolerance = "1%"
)";

} // namespace

TEST_CASE("a scene's title and names of files with commands: none is run, all figures are made") {
    const Folder folder;
    const std::string title = "title = \"" + hostile("marker") + "\"\n";
    folder.write("scene.toml", title + plain_scene);
    const std::string data = "a `touch marker` 'b.csv";
    std::string rows = "x,p\n";
    for (int i = -19; i <= 19; ++i) {
        const double x = i / 20.0;
        rows += std::to_string(x) + "," + std::to_string(std::sqrt(1 - x * x) / 2) + "\n";
    }
    folder.write(data, rows);
    folder.write("design.toml", title + R"([profile]
kind = "power-law"
m = { from = "0.5", to = "0.7" }
C = "1"
[load]
a = "1"
contact_modulus = "1"
[design]
maximise = "first_exit"
terms = 1
tolerance = "5%"
)");
    std::filesystem::create_directory(folder.path() / "`touch marker`");
    const std::string quoted = "\"a \\`touch marker\\` 'b.csv\"";
    for (const std::string arguments :
         {"plot scene.toml --out plot.svg", "plot scene.toml --out plot.png"}) {
        CAPTURE(arguments);
        const Outcome o = run(folder, arguments);
        CHECK(o.code == 0);
        CHECK(o.err.empty());
    }
    const Outcome compared = run(folder, "compare scene.toml " + quoted);
    CHECK(compared.code <= 1);
    CHECK(compared.err.empty());
    for (const std::string arguments :
         {"extent scene.toml --figure extent.svg", "design design.toml --out design.csv"}) {
        CAPTURE(arguments);
        const Outcome o = run(folder, arguments);
        CHECK_MESSAGE(o.code == 0, o.err);
    }
    for (const char* file : {"plot.svg", "plot.png", "extent.svg", "design.csv"}) {
        CAPTURE(file);
        CHECK(std::filesystem::exists(folder.path() / file));
    }
    CHECK_FALSE(std::filesystem::exists(folder.path() / "marker"));
}

TEST_CASE("a claim's id with a way out, quotes and commands: all files stay in --out") {
    const Folder folder;
    std::string claims;
    for (const std::string id :
         {"../../out", "a/b", "..", "a,b", "a\\\"b", "`touch marker`", "#1", " x", "it's *) x"}) {
        std::string claim = "[[claim]]\nid = \"" + id +
                            "\"\nkind = \"compare\"\nlines = [1, 2]\nprinted = '''c_0'''\nover = "
                            "\"hertz\"\nof = \"right.c0\"\nsays = \"2*right.c0\"\n";
        claims += claim;
    }
    folder.write("own.toml", hertz_head + claims);
    REQUIRE(run(folder, "verify own.toml --record").code == 0);
    std::filesystem::create_directory(folder.path() / "`touch marker`");
    const std::set<std::string> before = outside(folder.path(), "deep");
    const Outcome o = run(folder, "verify own.toml --out deep/er/out");
    CAPTURE(o.out);
    CAPTURE(o.err);
    CHECK(o.code == 0); // as recorded
    CHECK(outside(folder.path(), "deep/er/out") == [&] {
        std::set<std::string> all = before;
        all.insert({"deep", "deep/er"});
        return all;
    }());
    std::size_t pictures = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(folder.path() / "deep/er/out/figures")) {
        pictures += entry.path().extension() == ".svg" ? 1 : 0;
    }
    CHECK(pictures == 9);
}
