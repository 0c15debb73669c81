// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "tests/scene/scene_text.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

namespace {

std::string scene_text(const std::string& profile, const std::string& load) {
    return "[profile]\n" + profile + "\n[load]\n" + load +
           "\ncontact_modulus = \"1\"\n[ask]\nedges = [\"right\", \"left\"]\nterms = [1, 2]\n"
           "tolerance = \"1%\"\ndigits = 20\nu = [\"1e-3\", \"0.1\"]\nquantities = "
           "[\"pressure\", \"coefficients\", \"extent\", \"contact\"]\n";
}

const char* const rounded_punch =
    "kind = \"tilted-flat-and-rounded\"\nalpha = \"0.1\"\nt = \"0.5\"\n"
    "R = \"2\"";
const char* const corner = "kind = \"piecewise\"\nknots = [\"-1\", \"1\"]\n"
                           "slopes = [\"2*x\", \"x\", \"2*x\"]";
const char* const bend = "kind = \"piecewise\"\nknots = [\"-1\"]\n"
                         "slopes = [\"x/5 + (x + 1)\", \"x/5\"]";
const char* const curved = "kind = \"piecewise\"\nknots = [\"-1\"]\n"
                           "slopes = [\"x/5 + x^3 + (x + 1)^3\", \"x/5 + x^3\"]";
const char* const leaning = "kind = \"piecewise\"\nknots = [\"-1\", \"0\"]\n"
                            "slopes = [\"-2/15 + (x + 1)/7\", \"-2/15\", \"1/15\"]";
const char* const flat = "kind = \"piecewise\"\nknots = [\"-1/2\", \"1\"]\n"
                         "slopes = [\"x + 1/2\", \"0\", \"x - 1\"]";
const char* const one_sided = "kind = \"piecewise\"\nknots = [\"0\", \"1\"]\n"
                              "slopes = [\"x\", \"0\", \"2*(x - 1)\"]";

/// Checks that x is a - u at the right edge and u - b at the left one.
void check_places(const SceneResult& result) {
    for (const RowsAt& row : result.points()) {
        const Ball u(row.row(Quantity::x).asked.u->rational(), 300);
        const Ball x = row.edge() == Edge::right ? result.at(Quantity::a).value - u
                                                 : u - result.at(Quantity::b).value;
        CHECK(overlaps(row.at(Quantity::x).value, x));
        CHECK_FALSE(contains_zero(row.at(Quantity::x).value));
    }
}

void check_all_proved(const SceneResult& result) {
    const auto proved = [](const BoundedValue& v) {
        CAPTURE(v.how());
        CHECK(v.proved);
    };
    for (const Row& row : result.rows) {
        REQUIRE(row.value);
        proved(*row.value);
    }
    for (const Quantity q : {Quantity::a, Quantity::b, Quantity::P, Quantity::M}) {
        CHECK(result.find(q) != nullptr);
    }
}

} // namespace

TEST_CASE("edges on a knot or a corner, flats with the minimum inside: all is proved") {
    const struct {
        const char* profile;
        const char* load;
    } scenes[] = {
        {rounded_punch, "P = \"pi*0.005\""},
        {corner, "a = \"1\""},
        {corner, "P = \"pi/4\""},
        {bend, "a = \"1\""},
        {bend, "P = \"pi/20\""},
        {leaning, "a = \"3\""},
        {leaning, "P = \"sqrt(3)/10\""},
        {flat, "P = \"0.1\""},
        {flat, "P = \"1e-6\""},
        {flat, "a = \"5/4\""},
        {one_sided, "P = \"0.1\""},
        {one_sided, "a = \"3/2\""},
    };
    for (const auto& s : scenes) {
        CAPTURE(s.profile);
        CAPTURE(s.load);
        const SceneResult result = run_scene(parsed(scene_text(s.profile, s.load)));
        check_all_proved(result);
        check_places(result);
    }
}

TEST_CASE("a curved g' that is odd in the contact: a knot on the left edge is found exactly") {
    const SceneResult result =
        run_scene(parsed("[profile]\n" + std::string(curved) +
                         "\n[load]\na = \"1\"\ncontact_modulus = \"1\"\n[ask]\nedges = [\"left\"]\n"
                         "terms = 2\ndigits = 10\nu = \"0.1\"\n"));
    CHECK(result.at(Quantity::b).exactly == Rational(1));
    CHECK(result.points()[0].at(Quantity::p).proved);
    CHECK(result.points()[0].at(Quantity::local, 2).proved);
    // In |x| < 1, by hand: x/5 gives sqrt(1 - x^2)/10, x^3 gives (x^2 + 1/2) sqrt(1 - x^2)/2. At x
    // = -9/10 the sum is sqrt(19)/10 (1/10 + 131/200) = 151 sqrt(19)/2000.
    const Ball p = sqrt(Ball(19, 200)) * 151 / 2000;
    CHECK(overlaps(result.points()[0].at(Quantity::p).value, p));
}

TEST_CASE("values on a knot and near a flat, by hand") {
    const auto text = [](const BoundedValue& v) {
        return printed(v, {20, Rounding::nearest, false}).text;
    };
    // Hertz within the arc: R = 2, a = b = 1/5, p = sqrt(u (2/5 - u))/4, c_0 = sqrt(2/5)/4.
    const SceneResult hertz = run_scene(parsed(scene_text(rounded_punch, "P = \"pi*0.005\"")));
    CHECK(hertz.at(Quantity::a).exactly == Rational(1, 5));
    CHECK(hertz.at(Quantity::b).exactly == Rational(1, 5));
    CHECK(overlaps(hertz.points()[1].at(Quantity::p).value, sqrt(Ball(3, 200)) / 40));
    for (const RowsAt& edge : hertz.at_edges(QuantityGroup::coefficients)) {
        const Ball c0 = sqrt(Ball(Rational(2, 5), 200)) / 4;
        CHECK(overlaps(edge.at(Quantity::c, 0).value, c0));
        CHECK(overlaps(edge.at(Quantity::c, 1).value, -c0 * 5 / 4));
    }
    // A wedge tilted by a third of its angle: b/a = (1 - sin pi/6)/(1 + sin pi/6) = 1/3
    // (moore-hills.tex, line 301); at x = 2 G = ln((3 + 1)/(3 - 1)), p = ln 2/(10 pi).
    const SceneResult wedge = run_scene(parsed("[profile]\n" + std::string(leaning) +
                                               "\n[load]\na = \"3\"\ncontact_modulus = \"1\"\n"
                                               "[ask]\nu = \"1\"\ndigits = 20\n"));
    CHECK(wedge.at(Quantity::b).exactly == Rational(1));
    CHECK(overlaps(wedge.points()[0].at(Quantity::p).value,
                   log(Ball(2, 200)) / (Ball::pi(200) * 10)));
    // A flat from -1/2 to 1 is symmetric about 1/4: P = (s^2 acos(t/s) - t sqrt(s^2 - t^2))/2 with
    // t = 3/4, a = 1/4 + s, solved with mpmath at 40 digits. The pressure at s - 1/10 is from
    // mpmath's quad of G over both arcs.
    const SceneResult pad = run_scene(parsed(scene_text(flat, "P = \"0.1\"")));
    CHECK(text(pad.at(Quantity::a)) == "1.2310977185734183323");
    CHECK(text(pad.at(Quantity::b)) == "0.73109771857341833226");
    CHECK(text(pad.points()[1].at(Quantity::p)) == "0.083404414351848885849");
    CHECK(text(pad.points()[3].at(Quantity::p)) == "0.083404414351848885849");
}

// P of flat-and-rounded at a = 1, t = 1/3 is (acos(1/3) - sqrt(8)/9)/2. The algebra does not know
// that acos(1/3) = atan(sqrt(8)), and no number of bits distinguishes a from 1.
TEST_CASE("an edge on a knot that cannot be proved: p is proved, and its series is refused") {
    const char* const profile = "kind = \"piecewise\"\nsymmetric = true\nknots = [\"1/3\", \"1\"]\n"
                                "slopes = [\"0\", \"x - 1/3\", \"3*x - 7/3\"]";
    const SceneResult known =
        run_scene(parsed(scene_text(profile, "P = \"(acos(1/3) - sqrt(8)/9)/2\"")));
    CHECK(known.at(Quantity::a).exactly == Rational(1));
    check_all_proved(known);
    Scene scene = parsed(scene_text(profile, "P = \"(atan(sqrt(8)) - sqrt(8)/9)/2\""));
    CHECK_THROWS_WITH_AS((void)run_scene(scene),
                         doctest::Contains("an edge may lie on a knot of g'"), BudgetError);
    scene.ask.terms.clear();
    scene.ask.quantities = {QuantityGroup::pressure, QuantityGroup::contact};
    const SceneResult result = run_scene(scene);
    check_all_proved(result);
    CHECK_FALSE(result.at(Quantity::a).exactly.has_value());
    CHECK(overlaps(result.points()[0].at(Quantity::p).value,
                   known.points()[0].at(Quantity::p).value));
}

TEST_CASE("no first exit in the part: the result states it") {
    const Scene scene = parsed(hertz(
        "1",
        "terms = 1\ntolerance = \"1%\"\npart = [\"0\", \"1/100\"]\nquantities = [\"extent\"]\n"));
    // 1 - u/4 ... differs by 1 % at u = 402/10201 (2 (1 - 1.01^-2)), which is beyond 2/100.
    const SceneResult result = run_scene(scene);
    const RowsAt extent = result.at_edges(QuantityGroup::extent).at(0);
    CHECK_FALSE(extent.row(Quantity::extent, 1).reached);
    CHECK(extent.find(Quantity::crossing, 1) == nullptr);
}
