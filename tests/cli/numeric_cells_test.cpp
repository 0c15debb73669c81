// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/cli/run_program.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace edgeproof;
using namespace edgeproof::test;

namespace {

bool is_numeric(const std::string& column) {
    static const std::set<std::string> texts{"edge",     "asked",     "state",       "body",
                                             "quantity", "crossings", "coefficient", "power"};
    return !texts.contains(column) && !column.ends_with("route");
}

bool is_one_number(const std::string& cell) {
    try {
        (void)parse_decimal(cell);
        return cell.find('/') == std::string::npos;
    } catch (const InputError&) {
        return false;
    }
}

/// Checks all numeric cells; returns how many are not empty.
int check_cells(const std::string& csv) {
    int numbers = 0;
    const io::Csv table = io::parse_csv(csv, "table");
    const std::vector<std::string>& columns = table.header.cells;
    for (const io::Csv::Row& row : table.rows) {
        REQUIRE(row.cells.size() == columns.size());
        for (std::size_t j = 0; j < columns.size(); ++j) {
            const std::string& cell = row.cells[j];
            CAPTURE(columns[j]);
            CAPTURE(cell);
            if (is_numeric(columns[j]) && !cell.empty()) {
                CHECK(is_one_number(cell));
                ++numbers;
            }
        }
    }
    return numbers;
}

} // namespace

TEST_CASE("a cell of a numeric column is one number: drawn scenes of all kinds, all commands") {
    constexpr unsigned seed = 52;
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    const auto one_of = [&](const std::vector<std::string>& list) {
        return list[random() % list.size()];
    };
    const std::vector<std::string> profiles{
        "kind = 'hertz'\nR = '10'\n",
        "kind = 'power-law'\nm = '3'\nC = '1/7'\n",
        "kind = 'wedge'\nphi = '1/10'\n",
        "kind = 'tilted-wedge'\nphi = '1/10'\nalpha = '1/50'\n",
        "kind = 'flat-and-rounded'\nt = '0.4'\nR = '1'\n",
        "kind = 'tilted-flat-and-rounded'\nalpha = '1/100'\nt = '0.4'\nR = '1'\n",
        "kind = 'piecewise'\nsymmetric = true\nknots = ['1/2']\nslopes = ['0', 'x - 1/2']\n",
        "kind = 'sphere'\nR = '10'\n",
        "kind = 'cone'\nphi = '1/10'\n",
    };
    const Folder folder;
    int answered = 0;
    int numbers = 0;
    for (const std::string& profile : profiles) {
        const std::string load = one_of({"P = '280/9'", "P = '1/3'", "P = '1'"});
        const std::string shear =
            one_of({"", "[shear]\nQ = '1/20'\nfriction = '0.5'\n", "[shear]\nQ = '1/20'\n"});
        const std::string points = one_of({"['0', '1/3'], ['5', '0']", "['1/7', '0.48*a']"});
        const std::string x = one_of({"'0', '1/30', 'a/3'", "'a', '100', '0'", "'-1/7', '1/7'"});
        folder.write("s.toml", "[profile]\n" + profile + "[load]\n" + load +
                                   "\ncontact_modulus = '1000'\nnu = '0.3'\n" + shear +
                                   "[ask]\nterms = [1, 2]\ndigits = 8\ntolerance = '1%'\n" +
                                   "points = [" + points + "]\nx = [" + x + "]\n");
        for (const char* const command :
             {"pressure", "pressure --binary64 --round down", "pressure --quantity peak", "expand",
              "extent", "slip", "stress", "stress --greatest tau_max", "displacement",
              "displacement --reference 0"}) {
            CAPTURE(profile + load + shear + x);
            CAPTURE(command);
            const Outcome result = run(folder, std::string(command) + " s.toml --no-notes");
            CHECK((result.code == 0 || result.code == 2));
            if (result.code == 0) {
                ++answered;
                numbers += check_cells(result.out);
            }
        }
    }
    CHECK(answered > 30);
    CHECK(numbers > 500);
}
