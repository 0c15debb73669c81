// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/hertz_ledger.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

using namespace edgeproof::test;

TEST_CASE("an empty input does not pass: every command that compares") {
    const Folder folder;
    folder.write("head.toml", hertz_head);
    folder.write("wrong.toml", hertz_head + hertz_wrong);
    folder.write("scene.toml",
                 "[profile]\nkind = \"hertz\"\nR = \"2\"\n[load]\na = \"1.5\"\ncontact_modulus = "
                 "\"3\"\n");
    folder.write("recipe.toml", "[scenes]\n");
    folder.write("recipe.csv", "id,value\n");
    folder.write("rows.csv", "x,p\n");
    folder.write("empty.csv", "");
    std::filesystem::create_directory(folder.path() / "pack");
    for (const char* const command :
         {"verify head.toml", "check --ledger head.toml", "verify wrong.toml --only NONE",
          "compare scene.toml", "compare scene.toml rows.csv", "compare scene.toml empty.csv",
          "check empty.csv", "check", "table recipe.toml --check", "points recipe.toml",
          "pack pack --check"}) {
        CAPTURE(std::string(command));
        const Outcome outcome = run(folder, command);
        CHECK(outcome.code == 2);
        CHECK(outcome.out.empty());
        CHECK(lines(outcome.err).size() == 1);
    }
    // Answers without a row are read, but do not pass.
    folder.write("head.csv", "id,kind,m,C,a,contact_modulus,quantity,edge,u,value\n");
    CHECK(run(folder, "check head.csv").code == 1);
    folder.write("asked.csv", "# questions: 99999999999999999999999\n"
                              "id,kind,m,C,a,contact_modulus,quantity,edge,u,value\n"
                              "one,power-law,1,1,1,1,p,right,0.2,0.3\n");
    const Outcome asked = run(folder, "check asked.csv");
    CHECK(asked.code == 2);
    CHECK(has(asked.err, "asked.csv:1: '# questions: 99999999999999999999999' gives no number"));
}
