// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::test;

TEST_CASE("bounds speed: scenes are timed, the slowest is written, and one is repeated") {
    const Folder folder;
    const Outcome o = run(folder, "bounds speed --scenes 2 --seed 5 --digits 12,20 --write slow");
    CAPTURE(o.err);
    CHECK(o.code == 0);
    CHECK(has(o.out, "Processor time of scenes drawn from seed 5\n"));
    CHECK(has(o.out, "piecewise (curved)"));
    const auto written = folder.path() / "slow" / "scene-0.toml";
    REQUIRE(std::filesystem::exists(written));
    CHECK(has(file_text(written), "# bounds speed --seed 5 --only 0\n[profile]"));
    CHECK(run(folder, "pressure slow/scene-0.toml --digits 12").code == 0);

    const Outcome again = run(folder, "bounds speed --only 0 --seed 5 --digits 12 --csv");
    CHECK(again.code == 0);
    CHECK(has(again.out, file_text(written).substr(file_text(written).find("[profile]"))));
    CHECK(has(again.out, "piecewise (curved),pressure,12,1,"));

    const Outcome bad = run(folder, "bounds speed --digits 1001");
    CHECK(bad.code == 2);
    CHECK(lines(bad.err).size() == 1);
}
