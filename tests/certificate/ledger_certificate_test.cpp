// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certificate/only_certificate.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace edgeproof::test;

namespace {

const std::string wedges =
    "profile = \"tilted-wedge\"\ncount = 2\n[family.parameters]\ngam = [\"1/3\", \"1/2\"]\n"
    "phi = [\"1/50\"]\nalpha = [\"2*phi/pi*asin((1-gam)/(1+gam))\"]\na = [\"3/2\"]\nEs = "
    "[\"7/3\"]\n";

std::string value(const std::string& says, const std::string& of) {
    return "kind = \"value\"\nsays = \"" + says + "\"\nof = \"" + of + "\"\n";
}

} // namespace

TEST_CASE("a formula that is equal to the quantity by its form has no theorem") {
    const auto same = only_certificate(wedges, value("b", "b"));
    CHECK(same.theorems.empty());
    CHECK_FALSE(same.whole_verdict);
    CHECK(contains(same.leaves_out, "no mechanics"));
    CHECK(only_certificate(wedges, value("2*right.c0 - right.c0", "right.c0")).theorems.empty());
}

// b = gam a follows from consistency, which the theorem must therefore contain.
TEST_CASE("a formula for the left edge is compared with the mechanics") {
    const std::string edge = "is_the_left_edge (slope phi (tilt phi gam)) a (gam * a) /\\\n";
    const auto right = only_certificate(wedges, value("gam*a", "b"));
    CHECK(right.verdict == "confirmed");
    CHECK(contains(right.text, edge));
    CHECK(contains(right.text, "0 < phi /\\ 0 < gam /\\ 0 < a"));
    CHECK(right.whole_verdict);
    const auto wrong = only_certificate(wedges, value("2*gam*a", "b"));
    CHECK(wrong.verdict == "refuted");
    CHECK(contains(wrong.text, edge));
    CHECK(wrong.whole_verdict);
}

TEST_CASE("refutations are about the only coefficient, and corrections are relative") {
    const auto c = only_certificate(wedges, value("2*Es*phi/(Pi*sqrt(1+gam)*sqrt(a))", "right.c0"));
    CHECK(contains(c.text, "is_the_right_series Es "));
    CHECK(contains(c.text, "(Es phi gam a : R)"));
    CHECK(c.theorems.at(1).states == "for all contacts of this form, corrected = exact");
    CHECK(c.whole_verdict);
}

// right.c0 in it may have any value.
TEST_CASE("a correction that is equal to the quantity by its form has no theorem") {
    const auto c = only_certificate("u = [\"1/5\"]\n" + wedges,
                                    value("right.c0*sqrt(a+x)", "right.c0*sqrt(a-x)"));
    INFO(c.leaves_out);
    CHECK(c.verdict == "refuted");
    REQUIRE(c.theorems.size() == 1);
    CHECK(c.theorems[0].name.ends_with("_refuted"));
}

// The theories of all contacts of a form assume a > t, and that gam is b/a.
TEST_CASE("a theorem for all contacts is stated only if those of the family are of the form") {
    const auto load = value("0", "Es/2*integral(s*g1(s)/sqrt(a^2-s^2), s, -a, a)");
    const std::string scaled = load + "scale = \"Es*a\"\n";
    const auto within = only_certificate(flat("[\"3\"]", "[\"2\"]"), scaled);
    CHECK(contains(within.text, "0 < a <= t ->\n  is_load Es"));
    CHECK_FALSE(contains(within.text, "0 < t < a"));
    const std::string printed = "Es*a^2/R*(Pi/4 - 1/2*asin(t/a) - t/(2*a^2)*sqrt(a^2-t^2))";
    CHECK(only_certificate(flat("[\"1\"]", "[\"2\"]"),
                           value(printed, "Es/2*integral(s*g1(s)/sqrt(a^2-s^2), s, -a, a)"))
              .whole_verdict);
    const std::string other =
        "profile = \"tilted-wedge\"\ncount = 1\n[family.parameters]\ngam = [\"1/3\"]\nphi = "
        "[\"1/50\"]\nalpha = [\"phi/3\"]\na = [\"3/2\"]\nEs = [\"7/3\"]\n";
    CHECK_FALSE(only_certificate(other, value("b + 0*gam", "b")).whole_verdict);
}

// The part of a coefficient by the force, and that by the tension, where another one vanishes.
TEST_CASE("the signs of the parts of the shear traction are stated for all contacts") {
    const std::string sheared =
        "profile = \"tilted-wedge\"\ncount = 1\n[family.parameters]\nphi = [\"1/50\"]\nalpha = "
        "[\"phi/3\"]\na = [\"3/2\"]\nEs = [\"7/3\"]\nQ = [\"1/3\"]\n";
    const std::string claim = "kind = \"superposition\"\nsays = \"add\"\nof = \"right.s0\"\n"
                              "when_zero = \"right.s1\"\nloads = [\"Q\", \"sig0\"]\n";
    const auto c = only_certificate(sheared + "sig0 = [\"1/7\"]\n", claim);
    CHECK(contains(c.text, "s0 = t0 + v0 /\\\n  s1 = t1 + v1 /\\\n  (s1 = 0 -> 0 < t0 * v0)."));
    CHECK(c.whole_verdict);
    const std::string two_edges =
        "kind = \"superposition\"\nsays = \"subtract\"\nof = \"left.s0\"\n"
        "when_zero = \"right.s1\"\nloads = [\"Q\", \"sig0\"]\n";
    CHECK(contains(only_certificate(sheared + "sig0 = [\"1/7\"]\n", two_edges).text,
                   "is_the_left_shear_series (full_stick Q sig0 a b) b w0 w1 w2 /\\\n"
                   "  w0 = t0 + v0 /\\\n  s1 = t1 - v1 /\\\n  (s1 = 0 -> t0 * v0 < 0)."));
    const std::string smaller =
        "kind = \"relation\"\nsays = \"abs(right.s0)/sqrt(u) < abs(q(x))\"\n"
        "holds = \"everywhere\"\n";
    CHECK(contains(only_certificate(sheared + "sig0 = [\"0\"]\n", smaller).text,
                   "Rabs s0 / sqrt u < Rabs (full_stick Q 0 a b (a - u))"));
    CHECK(only_certificate(sheared + "sig0 = [\"1/7\"]\n", smaller).theorems.empty());
}

// The load of a power law, by the gamma function.
TEST_CASE("formulas with the gamma function are stated for all power laws") {
    const auto power_laws = [](const std::string& m) {
        return "profile = \"power-law\"\ncount = 2\n[family.parameters]\nm = " + m +
               "\nC = [\"3/7\"]\na = [\"3/2\"]\nEs = [\"7/3\"]\n";
    };
    const std::string printed = value("Es*C*sqrt(Pi)/(2+m)*gamma(2+m/2)/gamma((3+m)/2)*a^(m+1)",
                                      "Es/2*integral(s*g1(s)/sqrt(a^2-s^2), s, -a, a)");
    const auto c = only_certificate(power_laws("[\"0\", \"5/2\"]"), printed);
    CHECK(contains(c.text, "forall Gam, is_gamma Gam ->\n  0 < C /\\ 0 <= m /\\ 0 < a ->"));
    CHECK(contains(c.text, "Gam ((3 + m) / 2) * Rpower a (m + 1) = P0."));
    CHECK(c.whole_verdict);
}

// The theorem of a limit is about the end at which the values of the claim end.
TEST_CASE("a limit is stated only if the values of the claim end there") {
    const auto wedge = [](const std::string& alpha) {
        return "profile = \"tilted-wedge\"\ncount = 1\n[family.parameters]\nphi = [\"1/50\"]\na = "
               "[\"3/2\"]\nEs = [\"7/3\"]\nalpha = " +
               alpha + "\n";
    };
    const std::string limit = "kind = \"limit\"\nof = \"b/a\"\nalong = \"alpha\"\nlimit = \"1\"\n";
    const auto c = only_certificate(
        wedge("[\"phi/3\", \"phi/100\", \"phi*1e-4\", \"phi*1e-8\", \"phi*1e-16\"]"), limit);
    CHECK(c.verdict == "confirmed");
    CHECK(contains(c.text, "(at_right 0) (locally 1)"));
    CHECK(c.whole_verdict);
    const auto coarse =
        only_certificate(wedge("[\"phi/3\", \"phi/4\", \"phi/5\", \"phi/6\"]"), limit);
    CHECK(coarse.theorems.empty());
}

// The theorems are found by what a claim means. Each of these ledgers has the words of a claim with
// a theorem, and gives a name another meaning, or is about other contacts.
TEST_CASE("a claim with the same words and another meaning has no theorem") {
    const std::string tilts =
        "profile = \"tilted-wedge\"\ncount = 2\n[family.parameters]\nphi = "
        "[\"1/50\"]\na = [\"3/2\"]\nEs = [\"7/3\"]\nalpha = [\"phi/3\", \"phi/2\"]\n";
    const std::string range = "kind = \"relation\"\nsays = \"0 < b/a and b/a < 1\"\n";
    CHECK(only_certificate(tilts, range).whole_verdict);
    const std::string punch = "profile = \"tilted-flat-and-rounded\"\ncount = 2\nu = [\"1/5\"]\n"
                              "[family.parameters]\nalpha = [\"1/10\"]\nt = [\"1\"]\nR = [\"2\"]\n"
                              "a = [\"1/4\"]\nEs = [\"7/3\"]\nQ = [\"1/3\", \"2/7\"]\n";
    const std::string force = punch + "sig0 = [\"0\"]\n";
    const std::string below = "kind = \"relation\"\nsays = \"abs(right.s0)/sqrt(u) < abs(q(x))\"\n";
    CHECK(only_certificate(force, below).whole_verdict);
    const std::string hertzian = value("x/R", "g1(x)") + "where = \"x > 0\"\n";
    CHECK(only_certificate(force, hertzian).whole_verdict);
    const std::string similar =
        "profile = \"power-law\"\ncount = 2\nu = [\"1/3\"]\n"
        "[family.parameters]\nm = [\"1\"]\nC = [\"1/7\"]\na = [\"1\", \"3\"]\n"
        "Es = [\"1\"]\nsig0 = [\"0\"]\nQ = [\"a^2/100\"]\n";
    const std::string share = "kind = \"independence\"\nof = \"q(x)*L/Q\"\nat = [\"1/5\"]\n";
    CHECK(only_certificate(similar, share).theorems.size() == 1);
    struct Other {
        const char* what;
        std::string family;
        std::string claim;
        std::string define;
    };
    const Other others[] = {
        {"another left edge", tilts, range, "b = \"a/2\"\n"},
        {"another right edge", tilts, range, "a = \"7*b\"\n"},
        {"another distance", force, below, "u = \"1e9\"\n"},
        {"a distance of its own", force, below + "vary = { u = [\"1e9\"] }\n", ""},
        {"another traction", force, below, "\"q(s)\" = \"1e9\"\n"},
        {"another slope", force, hertzian, "\"g1(s)\" = \"s/R\"\n"},
        {"another radius", force, hertzian, "R = \"x/g1(x)\"\n"},
        {"places nearer than half of the contact", punch + "sig0 = [\"0\"]\n",
         "kind = \"relation\"\nsays = \"abs(right.s0)/sqrt(u) < abs(q(x))\"\nwhere = \"u < L/2\"\n",
         ""},
        {"partial slip", similar + "friction = [\"1\"]\n", share, ""},
        {"another unit", similar, share, "L = \"Q/q(x)\"\n"}};
    for (const Other& other : others) {
        CAPTURE(other.what);
        const auto c = only_certificate(other.family, other.claim, other.define);
        INFO(c.leaves_out);
        CHECK(c.verdict == "confirmed");
        CHECK(c.theorems.empty());
        CHECK_FALSE(c.whole_verdict);
    }
}

TEST_CASE("a reading about other contacts is not covered by the theorem of the claim") {
    const std::string wedge =
        "profile = \"power-law\"\ncount = 1\nu = [\"1/5\"]\n[family.parameters]\n"
        "C = [\"3/7\"]\na = [\"3/2\"]\nEs = [\"7/3\"]\nm = ";
    const std::string below =
        "kind = \"relation\"\nsays = \"right_local(1, x) < p(x) and right_local(2, x) < p(x) and "
        "right_local(3, x) < p(x)\"\nwhere = \"x > 0\"\n";
    CHECK(only_certificate(wedge + "[\"0\"]\n", below).whole_verdict);
    const std::string other = "[[family]]\nname = \"other\"\n" + wedge + "[\"1/10\"]\n";
    const auto c =
        only_certificate(wedge + "[\"0\"]\n" + other,
                         below + "[[claim.reading]]\ntext = \"wedges\"\n"
                                 "[[claim.reading]]\ntext = \"others\"\nover = \"other\"\n");
    CHECK(c.verdict == "confirmed");
    CHECK(c.theorems.empty());
}

// The theorem is about 0 < x < a.
TEST_CASE("a pressure without a condition on its places is stated in part") {
    const std::string power =
        "profile = \"power-law\"\ncount = 2\nu = [\"1/5\"]\n[family.parameters]\nm "
        "= [\"0\", \"1/2\"]\nC = [\"3/7\"]\na = [\"3/2\"]\nEs = [\"7/3\"]\n";
    const std::string printed = value("Es*C/sqrt(Pi)*(1+m)/(2+m)*gamma(2+m/2)/gamma((3+m)/"
                                      "2)*integral(s^m/sqrt(s^2-x^2), s, x, a)",
                                      "p(x)");
    CHECK(only_certificate(power, printed + "where = \"x > 0 and x < a\"\n").whole_verdict);
    const auto c = only_certificate(power, printed);
    CHECK(c.verdict == "confirmed");
    CHECK(c.theorems.size() == 1);
    CHECK_FALSE(c.whole_verdict);
}

// The integral equation of full stick may have other solutions, as far as Coq knows.
TEST_CASE("the formula of full stick is stated in part") {
    const auto c = only_certificate(
        "profile = \"tilted-wedge\"\ncount = 2\nu = [\"1/5\"]\n[family.parameters]\nphi = "
        "[\"1/50\"]\n"
        "alpha = [\"phi/3\"]\na = [\"3/2\"]\nEs = [\"7/3\"]\nQ = [\"1/3\", \"2/7\"]\nsig0 = "
        "[\"1/5\"]\n",
        value("Q/(Pi*sqrt((a-x)*(x+b))) + sig0*(2*x+b-a)/(8*sqrt((a-x)*(x+b)))", "q(x)"));
    CHECK(c.verdict == "confirmed");
    CHECK(contains(c.text, "is_traction"));
    CHECK_FALSE(c.whole_verdict);
}

// The theorem of this expansion is about symmetric contacts.
TEST_CASE("an expansion of symmetric contacts is not stated about tilted ones") {
    const std::string expansion =
        "kind = \"expansion\"\nsays = \"P1\"\nof = \"P1of(a-eps*S)/sqrt(1-eps*(X+S)/(2*a))\"\n"
        "variable = \"eps\"\nthrough = \"2\"\nvary = { eps = [\"a*1e-14\"], X = [\"9/10\"], S = "
        "[\"1/3\"] }\n";
    const std::string power =
        "profile = \"power-law\"\ncount = 2\nu = [\"1/5\"]\n[family.parameters]\nm "
        "= [\"1/2\", \"1\"]\nC = [\"3/7\"]\na = [\"3/2\"]\nEs = [\"7/3\"]\n";
    CHECK(only_certificate(power, expansion).whole_verdict);
    const auto c = only_certificate(wedges, expansion);
    CHECK(c.verdict == "refuted");
    CHECK(c.theorems.empty());
}

// Another condition leaves the contact of the theorem out.
TEST_CASE("a formula is refuted at a place that the claim is about") {
    const std::string printed = value("2*p(x)*(1+x/a)", "p(x)*(1+x/a)^2");
    const std::string places = "u = [\"1/5\", \"4/5\"]\n" + wedges;
    const auto right = only_certificate(places, printed + "where = \"x > 0 and x < a\"\n");
    CHECK(right.verdict == "refuted");
    CHECK(right.whole_verdict);
    const auto left = only_certificate(places, printed + "where = \"x < 0\"\n");
    CHECK(left.verdict == "refuted");
    CHECK(left.theorems.empty());
}

// The theorem about wedges is about the right edge.
TEST_CASE("a relation at the left edge of a power law has no theorem") {
    const std::string wedge =
        "profile = \"power-law\"\ncount = 1\nu = [\"1/5\"]\n[family.parameters]\n"
        "C = [\"3/7\"]\na = [\"3/2\"]\nEs = [\"7/3\"]\nm = [\"0\"]\n";
    const std::string near =
        "kind = \"relation\"\nholds = \"near-edge\"\nsays = \"left_local(1, x) < p(x) and "
        "left_local(2, x) < p(x) and left_local(3, x) < p(x)\"\nedge = \"left\"\n";
    const auto c = only_certificate(wedge, near);
    CHECK(c.verdict == "confirmed");
    CHECK(c.theorems.empty());
}

TEST_CASE("one term below the pressure is stated for exponents below 5/8") {
    const auto power = [](const std::string& exponents) {
        return "profile = \"power-law\"\ncount = 2\nu = [\"1/1000\", "
               "\"1/5\"]\n[family.parameters]\n"
               "C = [\"3/7\"]\na = [\"3/2\"]\nEs = [\"7/3\"]\nm = " +
               exponents + "\n";
    };
    const std::string below = "kind = \"relation\"\nsays = \"right_local(1, x) < p(x)\"\n";
    const std::string readings = below +
                                 "[[claim.reading]]\ntext = \"near\"\nholds = \"near-edge\"\n"
                                 "[[claim.reading]]\ntext = \"all\"\nwhere = \"x > 0\"\n";
    const auto c = only_certificate(power("[\"1/3\", \"5/8-1e-20\"]"), readings);
    CHECK(c.verdict == "confirmed");
    REQUIRE(c.theorems.size() == 2);
    CHECK(c.whole_verdict);
    CHECK(contains(c.text, "exists d, 0 < d /\\ forall u, 0 < u < d -> exists p0"));
    CHECK(contains(c.text, "forall u, 0 < u < a -> exists p0"));
    // At all places of the half, but of one exponent that the theorem does not have.
    const auto other = only_certificate(power("[\"1/3\", \"5/8\"]"), below + "where = \"x > 0\"\n");
    CHECK(other.verdict == "confirmed");
    CHECK(other.theorems.empty());
}

TEST_CASE("one term above the pressure near the edge is stated for exponents above 5/8") {
    const auto power = [](const std::string& exponents) {
        return "profile = \"power-law\"\ncount = 2\nu = [\"1/1000\", "
               "\"1/5\"]\n[family.parameters]\n"
               "C = [\"3/7\"]\na = [\"3/2\"]\nEs = [\"7/3\"]\nm = " +
               exponents + "\n";
    };
    const std::string near = "[[claim.reading]]\ntext = \"near\"\nholds = \"near-edge\"\n";
    const std::string all = "[[claim.reading]]\ntext = \"all\"\nwhere = \"x > 0\"\n";
    const std::string above = "kind = \"relation\"\nsays = \"right_local(1, x) > p(x)\"\n";
    const auto c = only_certificate(power("[\"13/20\", \"2\"]"), above + near + all);
    CHECK(c.verdict == "imprecise");
    REQUIRE(c.theorems.size() == 2);
    CHECK(c.whole_verdict);
    CHECK(contains(c.text, "5 / 8 < m /\\ 0 < a ->"));
    CHECK(contains(c.text, "r0 * sqrt (9 / 10) < p0."));
    // The exponent of the second theorem is missing.
    const auto other = only_certificate(power("[\"7/10\", \"2\"]"), above + near + all);
    CHECK(other.verdict == "imprecise");
    CHECK(other.theorems.empty());
    // There is no theorem about a relation that holds in the whole half.
    const auto holds = only_certificate(power("[\"3/2\", \"2\"]"), above + near + all);
    CHECK(holds.verdict == "confirmed");
    CHECK(holds.theorems.empty());
}

TEST_CASE("the sum of increments of shear is stated for wedges and power laws under one force") {
    const std::string parameters =
        "count = 2\nu = [\"1/5\"]\n[family.parameters]\na = [\"3/2\"]\nEs = "
        "[\"7/3\"]\nQ = [\"1/10\", \"-1/20\"]\n";
    const std::string wedge =
        "profile = \"tilted-wedge\"\n" + parameters + "phi = [\"1/50\"]\nalpha = [\"phi/3\"]\n";
    const std::string increments = "Q/P*P1of(s)/(Pi*sqrt((s-x)*(x+bof(s))))";
    const std::string right =
        value("Q/P*p(x)", "integral(" + increments + ", s, x, a)") + "where = \"x > 0\"\n";
    const std::string left = value("Q/P*p(x)", "integral(" + increments + ", s, binv(-x), a)") +
                             "edge = \"left\"\nwhere = \"x < 0\"\n";
    const auto c = only_certificate(wedge + "sig0 = [\"0\"]\n", right);
    CHECK(contains(c.text, "is_similar_on_the_right Es (TiltedWedge.slope phi (tilt phi gam)) a"));
    CHECK(c.whole_verdict);
    CHECK(only_certificate(wedge + "sig0 = [\"0\"]\n", left).whole_verdict);
    const std::string punch = "profile = \"flat-and-rounded\"\n" + parameters +
                              "t = [\"1/10\"]\nR = [\"3\"]\nsig0 = [\"0\"]\n";
    const auto other = only_certificate(punch, right);
    CHECK(other.verdict == "confirmed");
    CHECK(other.theorems.empty());
}

TEST_CASE("the integral of the pressure is stated for contacts that reach beyond the flat") {
    const std::string integral = value("integral(p(x), x, -a, a)", "P");
    const auto c = only_certificate(flat("[\"1\"]", "[\"2\"]"), integral);
    CHECK(c.verdict == "confirmed");
    CHECK(c.whole_verdict);
    CHECK(contains(c.text, "is_integral_about_0 p a a P0"));
    CHECK(only_certificate(wedges, integral).theorems.empty());
    const auto tilted =
        only_certificate(wedges, value("Es/2*integral(s*g1(s)/sqrt((a-s)*(s+b)), s, -b, a)",
                                       "integral(p(s), s, -b, a)"));
    CHECK(tilted.verdict == "confirmed");
    CHECK(tilted.theorems.size() == 1);
    CHECK_FALSE(tilted.whole_verdict);
}

// The theorem is about places between x = 0 and the transition x = t.
TEST_CASE("a pressure that grows is stated only for places of the theorem") {
    const std::string grows =
        "kind = \"monotone\"\nof = \"p(s)\"\nalong = \"s\"\nsense = \"increasing\"\n";
    const auto c = only_certificate(flat("[\"1\"]", "[\"2\"]"),
                                    grows + "vary = { s = [\"0\", \"t/2\", \"t\"] }\n");
    CHECK(c.verdict == "confirmed");
    CHECK(c.whole_verdict);
    CHECK(contains(c.text, "forall x z, 0 <= x < z -> z <= t -> p x < p z"));
    const auto beyond = only_certificate(flat("[\"1\"]", "[\"2\"]"),
                                         grows + "vary = { s = [\"0\", \"t/2\", \"t*1.001\"] }\n");
    CHECK(beyond.verdict == "confirmed");
    CHECK(beyond.theorems.empty());
}

TEST_CASE("a difference at the transition is stated only if its places approach the transition") {
    const std::string limit = "kind = \"limit\"\nof = \"(p(t+s)-p(t-s))/p(t)\"\nalong = "
                              "\"s\"\nlimit = \"0\"\nvary = { s = [";
    const auto c = only_certificate(flat("[\"1\"]", "[\"2\"]"),
                                    limit + "\"(a-t)*1e-1\", \"(a-t)*1e-4\", \"(a-t)*1e-16\"] }\n");
    CHECK(c.verdict == "confirmed");
    CHECK(c.whole_verdict);
    CHECK(contains(c.text, "(forall x, - a < x < a -> continuous p x)"));
    const auto far = only_certificate(
        flat("[\"1\"]", "[\"2\"]"), limit + "\"(a-t)*1e-1\", \"(a-t)*1e-2\", \"(a-t)*1e-3\"] }\n");
    CHECK(far.theorems.empty());
}

// The theorem says at which edge the coefficient vanishes; the readings are those of the theorem.
TEST_CASE("a claim with several readings is stated with all of them") {
    const std::string sheared =
        "profile = \"tilted-wedge\"\ncount = 2\nu = [\"1/5\"]\n[family.parameters]\nphi = "
        "[\"1/50\"]\nalpha = [\"phi/3\"]\na = [\"3/2\"]\nEs = [\"7/3\"]\nQ = [\"1/3\", \"-2/7\"]\n"
        "sig0 = [\"1/5\"]\n";
    const std::string vanishing = "kind = \"vanishing\"\nsays = \"4/(3*Pi)\"\nratio = "
                                  "\"sig0*d/Q\"\nloads = [\"Q\", \"sig0\"]\n";
    const auto reading = [](const std::string& of, const std::string& elsewhere) {
        return "[[claim.reading]]\ntext = \"" + of + "\"\nof = \"" + of + "\"\nelsewhere = [\"" +
               elsewhere + "\"]\n";
    };
    const std::string left = reading("left.s1", "right.s1");
    const std::string right = reading("right.s1", "left.s1");
    const std::string define = "d = \"(a+b)/2\"\n";
    const auto c = only_certificate(sheared, vanishing + left + right, define);
    CHECK(c.verdict == "imprecise");
    CHECK(c.whole_verdict);
    CHECK(contains(c.text, "s1 = 0 /\\ v1 <> 0"));
    CHECK(only_certificate(sheared, vanishing + right + left, define).theorems.empty());
}

TEST_CASE("the printed consistency is stated for tilted wedges and tilted punches") {
    const std::string integral = "integral(g1(s)/sqrt((a-s)*(s+b)), s, -b, a)";
    const std::string scale = "scale = \"integral(abs(g1(s))/sqrt((a-s)*(s+b)), s, -b, a)\"\n";
    const auto c = only_certificate(wedges, value(integral, "0") + scale);
    CHECK(c.verdict == "confirmed");
    CHECK(c.whole_verdict);
    CHECK(contains(c.text, "is_the_left_edge (tilted_rounded_slope alpha t R0) a b"));
}

TEST_CASE("terms above the pressure of rounded edges are stated near the right edge only") {
    const std::string above =
        "kind = \"relation\"\nsays = \"right_local(1, x) > p(x) and right_local(2, x) > p(x) and "
        "right_local(3, x) > p(x)\"\n";
    const std::string places = "u = [\"1/1000\"]\n";
    const auto c =
        only_certificate(places + flat("[\"1\"]", "[\"2\"]"), above + "holds = \"near-edge\"\n");
    CHECK(c.verdict == "confirmed");
    CHECK(c.whole_verdict);
    CHECK(contains(c.text, "exists d, 0 < d /\\ forall u, 0 < u < d -> exists p0"));
    const auto everywhere = only_certificate(places + flat("[\"1\"]", "[\"2\"]"), above);
    CHECK(everywhere.theorems.empty());
    const auto one = only_certificate(
        places + flat("[\"1\"]", "[\"2\"]"),
        "kind = \"relation\"\nsays = \"right_local(1, x) > p(x)\"\nholds = \"near-edge\"\n");
    CHECK(one.verdict == "confirmed");
    CHECK(one.theorems.empty());
}
