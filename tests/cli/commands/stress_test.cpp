// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/run_program.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace edgeproof::test;

namespace {

const std::string pressed_cylinder = "[profile]\nkind = \"hertz\"\nR = \"1\"\n[load]\na = \"1\"\n"
                                     "contact_modulus = \"2\"\n";

/// Returns the lines that hold data, and the names of the columns.
std::string data_lines(const std::string& csv) {
    std::string data;
    for (const std::string& line : lines(csv)) {
        data += line.rfind('#', 0) == 0 ? "" : line + "\n";
    }
    return data;
}

} // namespace

// z = a sqrt((sqrt(5) - 1)/2), tau_max = p_0 sqrt((5 sqrt(5) - 11)/2) (johnson1985, sec. 4.2(a)).
TEST_CASE("stress: the greatest value is one row with its place") {
    const Folder folder;
    folder.write("s.toml", pressed_cylinder);
    const Outcome o = run(folder, "stress s.toml --greatest tau_max --digits 12 --body B");
    CHECK(o.code == 0);
    CHECK(o.err.empty());
    const std::string data = data_lines(o.out);
    CHECK(has(data, "body,x,x_bound,z,z_bound,tau_max,tau_max_bound,route\nB,0,0,0.786151377757,"));
    CHECK(has(data, ",0.300283106001,"));
    CHECK(has(data, ",branch and bound\n"));
    CHECK(lines(data).size() == 2);
    CHECK(has(o.out, "# the greatest tau_max in body B\n"));
    CHECK(has(o.out, "# at all other places the value is less\n"));
}

TEST_CASE("stress: requests for a greatest value that make no sense") {
    const Folder folder;
    folder.write("s.toml", pressed_cylinder);
    const auto refused = [&](const std::string& options, const std::string& message) {
        CAPTURE(options);
        const Outcome o = run(folder, "stress s.toml " + options);
        CHECK(o.code == 2);
        CHECK(o.out.empty());
        CHECK(lines(o.err).size() == 1);
        CHECK(has(o.err, message));
    };
    refused("--greatest szz", "--greatest szz is not searched for; write mises, tau_max");
    refused("--greatest mises", "s.toml:5: mises needs Poisson's ratio; add nu");
    refused("--greatest mises", "s.toml:5: mises needs Poisson's ratio; add nu");
    refused("--greatest tau_max --point 0,1", "--greatest and --point exclude each other");
    refused("--greatest sxx", "without shear traction sxx on the surface is nowhere above");
    folder.write("s.toml", pressed_cylinder + "[shear]\nQ = \"pi/4\"\npath = \"together\"\n");
    refused("--greatest tau_max", "boxes do not decide at which one place the stress is greatest");
}

// On the surface of a cylinder p = sqrt(2 u) - ...: szz = -p, and sxx is the same (johnson1985, eq.
// 4.45).
TEST_CASE("expand along a ray: rows, and requests that make no sense") {
    const Folder folder;
    folder.write("s.toml", pressed_cylinder);
    const Outcome o = run(folder, "expand s.toml --angle 0 --terms 2 --edge left --digits 12");
    CHECK(o.code == 0);
    const std::string data = data_lines(o.out);
    CHECK(has(data, "edge,power,sxx,sxx_bound,szz,szz_bound,sxz,sxz_bound,route\n"
                    "left,0/2,0,0,0,0,0,0,series\nleft,1/2,-1.41421356237,"));
    const auto refused = [&](const std::string& command, const std::string& message) {
        CAPTURE(command);
        const Outcome bad = run(folder, command);
        CHECK(bad.code == 2);
        CHECK(bad.out.empty());
        CHECK(lines(bad.err).size() == 1);
        CHECK(has(bad.err, message));
    };
    refused("expand s.toml --angle 181", "--angle 181 does not lie in the body; write degrees");
    refused("expand s.toml --angle x", "--angle x: unknown name 'x'");
    refused("expand s.toml --body B", "--body B has no effect: without --angle no stress");
    refused("expand s.toml --angle 1 --quantity shear", "--quantity shear has no effect");
}

TEST_CASE("options without effect are refused by stress, displacement and slip after steps") {
    const Folder folder;
    folder.write("s.toml", pressed_cylinder);
    folder.write("steps.toml", "[profile]\nkind = \"hertz\"\nR = \"1\"\n[load]\ncontact_modulus = "
                               "\"1\"\n[shear]\nfriction = \"1/2\"\n[[step]]\nP = \"1\"\n"
                               "[[step]]\nP = \"2\"\nQ = \"0.3\"\n");
    for (const auto& each : {std::pair{"stress s.toml --point 0,1", "--terms 3"},
                             std::pair{"stress s.toml --point 0,1", "--edge left"},
                             std::pair{"stress s.toml --point 0,1", "--x 0"},
                             std::pair{"stress s.toml --point 0,1", "--u 1/3"},
                             std::pair{"stress s.toml --greatest tau_max", "--process-zone 1/3"},
                             std::pair{"displacement s.toml --x 3", "--terms 3"},
                             std::pair{"displacement s.toml --x 3", "--edge left"},
                             std::pair{"slip steps.toml", "--terms 3"},
                             std::pair{"slip steps.toml", "--tolerance 1%"}}) {
        const auto& command = each.first;
        const auto& option = each.second;
        CAPTURE(command);
        CAPTURE(option);
        const Outcome o = run(folder, std::string(command) + " " + option);
        CHECK(o.code == 2);
        CHECK(o.out.empty());
        CHECK(has(o.err, std::string(option) + " has no effect: "));
        CHECK(run(folder, command).code == 0);
    }
    // Nothing slipped in the last step.
    const Outcome o = run(folder, "slip steps.toml --digits 12 --no-notes");
    CHECK(o.out == "edge,d,d_bound,route\nright,0,0,stick zone\nleft,0,0,stick zone\n");
    CHECK_FALSE(has(run(folder, "pressure steps.toml --x 0").out, "the contact slips outside"));
}
