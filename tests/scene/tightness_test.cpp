// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scene/scene_text.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

namespace {

struct Sampled {
    const char* name;
    const char* profile;
    const char* load;
    const char* u; ///< in addition to points near the edge
};

/// Every profile of the paper, and a user's own, in the regimes where digits are lost.
const Sampled sampled[] = {
    {"wedge", "kind = \"power-law\"\nm = \"0\"\nC = \"0.3\"", "a = \"0.7\"",
     "\"0.7 - 1e-30\", \"0.7 + 1e-300\""},
    {"nearly a wedge", "kind = \"power-law\"\nm = \"1e-10\"\nC = \"1\"", "a = \"0.7\"",
     "\"0.7\", \"0.7 - 1e-30\""},
    {"m = 5/8 + 1e-20", "kind = \"power-law\"\nm = \"0.62500000000000000001\"\nC = \"1\"",
     "a = \"0.7\"", "\"0.7\", \"0.3\""},
    {"m = 1e4", "kind = \"power-law\"\nm = \"10000\"\nC = \"1\"", "a = \"0.7\"",
     "\"0.7\", \"0.69\", \"1e-4\""},
    {"a power law under P", "kind = \"power-law\"\nm = \"7/3\"\nC = \"2\"", "P = \"1e-9\"",
     "\"1e-5\""},
    {"nearly no flat", "kind = \"flat-and-rounded\"\nt = \"1e-15\"\nR = \"1\"", "a = \"1\"",
     "\"1\", \"1 - 1e-15\", \"1 - 2e-15\""},
    {"nearly all flat", "kind = \"flat-and-rounded\"\nt = \"1 - 1e-15\"\nR = \"1\"", "a = \"1\"",
     "\"1\", \"1e-15\", \"1.1e-15\""},
    {"near a knot", "kind = \"flat-and-rounded\"\nt = \"pi/8\"\nR = \"1\"", "a = \"1\"",
     "\"1 - pi/8\", \"1 - pi/8 + 1e-30\", \"1 - pi/8 - 1e-30\""},
    {"just past the flat", "kind = \"flat-and-rounded\"\nt = \"1\"\nR = \"1\"", "P = \"1e-40\"",
     "\"0.5\""},
    {"gamma = 1 - 1e-30",
     "kind = \"tilted-wedge\"\nphi = \"pi/16\"\nalpha = \"asin(1e-30/(2 - 1e-30))/8\"", "a = \"1\"",
     "\"1 - 1e-20\""},
    {"gamma = 1e-30",
     "kind = \"tilted-wedge\"\nphi = \"pi/16\"\nalpha = \"asin((1 - 1e-30)/(1 + 1e-30))/8\"",
     "a = \"1\"", "\"1e-31\""},
    {"alpha = 1e-25", "kind = \"tilted-flat-and-rounded\"\nalpha = \"1e-25\"\nt = \"1\"\nR = \"2\"",
     "a = \"0.5\"", "\"0.5\", \"0.7\""},
    {"scales apart", "kind = \"flat-and-rounded\"\nt = \"4e-10\"\nR = \"1e-9\"", "a = \"1e-9\"",
     "\"6e-10\", \"1e-9\""},
    {"tilt from P and M", "kind = \"tilted-flat-and-rounded\"\nt = \"1\"\nR = \"2\"",
     "P = \"0.3\"\nM = \"-0.2\"", "\"0.5\""},
    {"one's own",
     "kind = \"piecewise\"\nknots = [\"-1/3\", \"0\", \"1/2\"]\nslopes = [\"3*x\", "
     "\"2*x - 1/3\", \"x\", \"1/4 + x/2\"]",
     "a = \"3/4\"", "\"1/4\", \"3/4 - 1e-40\""},
};

std::string text_of(const Sampled& s) {
    const bool tiny = std::string(s.name) == "scales apart";
    return std::string("[profile]\n") + s.profile + "\n[load]\n" + s.load +
           "\ncontact_modulus = \"" + (tiny ? "1e12" : "1") +
           "\"\n[shear]\nQ = \"pi*(1 + 1e-40)\"\nbulk_tension = \"-4\"\n[ask]\n"
           "edges = [\"right\", \"left\"]\nterms = [1, 3]\ndigits = 40\nu = [\"1e-320\", "
           "\"1e-60\", " +
           s.u + "]\nquantities = [\"pressure\", \"shear\", \"coefficients\", \"contact\"]\n";
}

/// Returns the fault of a value that is not proved, or not printed within 10 units of the last
/// digit; empty if there is none.
std::string fault(const BoundedValue& v, const Digits& digits) {
    const PrintedValue p = printed(v, digits);
    if (!v.proved) {
        return "estimated by " + v.route;
    }
    if (!v.value.is_finite()) {
        return "not finite";
    }
    if (contains_zero(v.value)) {
        return parse_decimal(p.bound) < parse_decimal("1e-300") ? ""
                                                                : "not distinguished from zero";
    }
    const Ball unit = abs(v.value) * Ball(parse_decimal("1e-39"), 200);
    return certainly_less(Ball(v.value.radius(), 200), unit) && p.complete ? ""
                                                                           : "wide: " + p.bound;
}

} // namespace

TEST_CASE("every value has a proved bound, and none is wider than 10 units of the last digit") {
    for (const Sampled& s : sampled) {
        CAPTURE(std::string(s.name));
        const Scene scene = parsed(text_of(s));
        const SceneResult result = run_scene(scene);
        const Digits& digits = scene.ask.digits;
        for (const Row& row : result.rows) {
            const QuantityRow& def = row_of(row.asked.quantity);
            CAPTURE(std::string(def.name));
            REQUIRE(row.value);
            if (def.short_error || row.asked.quantity == Quantity::x ||
                row.asked.quantity == Quantity::q_local) {
                CHECK(row.value->proved);
            } else {
                CHECK(fault(*row.value, digits) == "");
            }
        }
        for (const Quantity q : {Quantity::a, Quantity::b, Quantity::P, Quantity::M}) {
            CHECK(result.find(q) != nullptr);
        }
        CHECK(result.points().size() == result.plan.points * result.plan.edges.size());
        for (const RowsAt& point : result.points()) {
            CHECK(point.find(Quantity::p) != nullptr);
            CHECK(point.find(Quantity::q) != nullptr);
        }
    }
}
