// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/audit/contact_formula.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/paths.hpp"

#include <doctest/doctest.h>

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace {

using Given = std::vector<std::pair<const char*, const char*>>;

struct SampledProfile {
    const char* profile;
    Given parameters;
};

/// Every kind of the paper's profiles; for the tilted punch, with the left edge in each of its
/// pieces.
const std::vector<SampledProfile>& sampled_profiles() {
    static const std::vector<SampledProfile> all{
        {"power-law", {{"m", "0"}, {"C", "3/7"}, {"a", "3/2"}}},
        {"power-law", {{"m", "1"}, {"C", "3/7"}, {"a", "3/2"}}},
        {"power-law", {{"m", "2"}, {"C", "3/7"}, {"a", "3/2"}}},
        {"power-law", {{"m", "5/8"}, {"C", "3/7"}, {"a", "3/2"}}},
        {"flat-and-rounded", {{"t", "1/2"}, {"R", "3"}, {"a", "3/2"}}},
        {"flat-and-rounded", {{"t", "5/2"}, {"R", "3"}, {"a", "3"}}},
        {"tilted-wedge", {{"phi", "1/3"}, {"alpha", "1/7"}, {"a", "3/2"}}},
        {"tilted-flat-and-rounded", {{"alpha", "1/10"}, {"t", "1"}, {"R", "2"}, {"a", "1/7"}}},
        {"tilted-flat-and-rounded", {{"alpha", "1/10"}, {"t", "1"}, {"R", "2"}, {"a", "3/10"}}},
        {"tilted-flat-and-rounded", {{"alpha", "1/10"}, {"t", "1"}, {"R", "2"}, {"a", "1"}}},
        {"tilted-flat-and-rounded", {{"alpha", "1/10"}, {"t", "1"}, {"R", "2"}, {"a", "4"}}}};
    return all;
}

Sample sample_of(const SampledProfile& profile, const char* fraction) {
    Sample sample;
    sample.scene.family = profile.profile;
    sample.scene.profile = profile.profile;
    for (const auto& [name, text] : profile.parameters) {
        sample.scene.parameters.emplace(name, Exact::parse(text));
    }
    for (const auto& [name, text] : Given{{"Es", "7/3"}, {"Q", "3/10"}, {"sig0", "-2/7"}}) {
        sample.scene.parameters.emplace(name, Exact::parse(text));
    }
    sample.fraction = Exact::parse(fraction);
    return sample;
}

constexpr unsigned aimed_digits = 30;

/// The balls of both formulas must overlap, and be narrow: 24 digits of the scale.
std::string fault_between(const EnclosedSample& sample, const Expr& integral, const Expr& known,
                          const Expr& scale) {
    try {
        const Ball x = sample.evaluate(integral);
        const Ball y = sample.evaluate(known);
        const Ball size = abs(sample.evaluate(scale));
        if (!x.is_finite() || !y.is_finite()) {
            return "not finite";
        }
        if (disjoint(x, y)) {
            return ball_text(x, 30) + " is not " + ball_text(y, 30);
        }
        const Ball widest(pow(Real(10), -24), x.bits());
        const Ball radius(x.radius(), x.bits());
        return certainly_less(radius, widest * size) ? "" : "wide: " + ball_text(x, 30);
    } catch (const Error& error) {
        return error.what();
    }
}

/// Checks all profiles at one place.
std::string faults_of(const std::string& integral, const std::string& known,
                      const std::string& scale, const char* fraction = "2/7") {
    std::string faults;
    for (const SampledProfile& profile : sampled_profiles()) {
        const Sample sample = sample_of(profile, fraction);
        const std::string fault = fault_between(
            EnclosedSample(sample, 2 * bits_for(40), aimed_digits), contact_formula(integral),
            contact_formula(known), contact_formula(scale));
        faults += fault.empty() ? "" : sample.scene.text() + ": " + fault + "\n";
    }
    return faults;
}

} // namespace

TEST_CASE("functions of the contact inside integrals have their known values") {
    // The growth of the force is compared with closed forms of the force.
    CHECK(faults_of("integral(P1of(s), s, a/9, a)", "P - Pof(a/9)", "P") == "");
    CHECK(faults_of("integral(P1of(2*a - 2*s/3), s, 3*a/4, a)", "3/2*(Pof(3*a/2) - Pof(4*a/3))",
                    "P + Pof(3*a/2)") == "");
    CHECK(faults_of("integral(g1(s)/sqrt((a-s)*(s+b)), s, -b, a)", "0", "P/(Es*L)") == "");
    CHECK(faults_of("integral(g1(s), s, -b, a) + integral(abs(g1(s)), s, -b, a)",
                    "2*integral(g1(s), s, 0, a)", "P/Es") == "");
    CHECK(faults_of("Es/2*integral(s*g1(s)/sqrt((a-s)*(s+b)), s, -b, a)", "P", "P") == "");
    CHECK(faults_of("integral(q(s), s, -b, a)", "Q", "Q + L") == "");
}

TEST_CASE("the left edge inside integrals: the growth of the moment") {
    // dM = dP (a - b)/2 is the moment of the pressure increment, which is that of a flat punch.
    const Expr integral = contact_formula("integral(P1of(s)*(s-bof(s))/2, s, a/9, a) + u");
    for (const SampledProfile& profile : sampled_profiles()) {
        const Sample sample = sample_of(profile, "2/7");
        CAPTURE(sample.scene.text());
        Sample smaller = sample;
        Exact& a = smaller.scene.parameters.at("a");
        a = Exact(a.expr() / Expr::number(Rational(9)));
        EnclosedSample whole(sample, 300, aimed_digits);
        whole.set("u", EnclosedSample(smaller, 300).evaluate(Expr::symbol("M")));
        CHECK(fault_between(whole, integral, Expr::symbol("M"), contact_formula("P*L")) == "");
    }
}

TEST_CASE("the pressure inside integrals: force, moment, and the slope of the profile") {
    CHECK(faults_of("integral(p(s), s, -b, a)", "P", "P") == "");
    CHECK(faults_of("integral(s*p(s), s, -b, a)", "M", "P*L") == "");
    CHECK(faults_of("integral((2 - s)*p(s)/7, s, -b, a)", "(2*P - M)/7", "P + P*L") == "");
    // Each half has P/2 only for a symmetric profile.
    const Sample half = sample_of(sampled_profiles()[3], "1/2");
    CHECK(fault_between(EnclosedSample(half, 300, aimed_digits),
                        contact_formula("integral(p(s), s, 0, a)"), contact_formula("P/2"),
                        contact_formula("P")) == "");
    for (const std::size_t i : {0U, 4U, 6U, 8U, 10U}) {
        const Sample sample = sample_of(sampled_profiles()[i], "2/7");
        CAPTURE(sample.scene.text());
        CHECK(fault_between(EnclosedSample(sample, 300, aimed_digits),
                            contact_formula("pv(p(s)/(s-x), s, -b, a, x)"),
                            contact_formula("-Pi*Es/2*g1(x)"), contact_formula("P/L")) == "");
    }
}

TEST_CASE("a power, sine or exponential of the place times the pressure") {
    // The flat punch of half width s has the second moment s^2/2 times its force.
    for (const std::size_t i : {0U, 1U, 2U, 3U, 4U, 5U}) {
        const Sample sample = sample_of(sampled_profiles()[i], "2/7");
        CAPTURE(sample.scene.text());
        CHECK(fault_between(EnclosedSample(sample, 300, aimed_digits),
                            contact_formula("integral(s^2*p(s), s, -a, a)"),
                            contact_formula("integral(s^2/2*P1of(s), s, 0, a)"),
                            contact_formula("P*a^2")) == "");
        CHECK(fault_between(EnclosedSample(sample, 300, aimed_digits),
                            contact_formula("integral(cos(s)^2*p(s), s, -a, a)"),
                            contact_formula("P - integral(sin(s)^2*p(s), s, -a, a)"),
                            contact_formula("P")) == "");
    }
    const Sample hertz = sample_of(sampled_profiles()[1], "2/7");
    const EnclosedSample in_balls(hertz, 300, aimed_digits);
    CHECK(fault_between(in_balls, contact_formula("integral(p(s)^2, s, -a, a)"),
                        contact_formula("16*P^2/(3*Pi^2*a)"), contact_formula("P^2/a")) == "");
    CHECK(fault_between(in_balls, contact_formula("integral(p(s)/(1+s^2), s, -a, a)"),
                        contact_formula("2*P/a^2*(sqrt(1+a^2)-1)"), contact_formula("P")) == "");
}

TEST_CASE("the pressure at a point as an integral over the growth of the contact") {
    const char* whole = "1/Pi*integral(P1of(s)/sqrt((s-x)*(x+bof(s))), s, x, a)";
    CHECK(faults_of(whole, "p(x)", "p(x)", "1/5") == "");
    CHECK(faults_of(whole, "p(x)", "p(x)", "1e-12") == "");
    CHECK(faults_of("pv(q(s)/(s-x), s, -b, a, x)", "Pi*sig0/4", "Q/L + sig0") == "");
    for (const SampledProfile& profile : sampled_profiles()) {
        Sample left = sample_of(profile, "1/1000");
        left.edge = Edge::left;
        CAPTURE(left.scene.text());
        const EnclosedSample sample(left, 300, aimed_digits);
        const Expr p = contact_formula("p(x)");
        CHECK(fault_between(sample,
                            contact_formula("1/Pi*integral(P1of(s)/sqrt((s-x)*(x+bof(s))), s, "
                                            "binv(-x), a)"),
                            p, p) == "");
        // The same integral in a variable that runs in the opposite direction.
        CHECK(fault_between(sample,
                            contact_formula("(a-binv(-x))/Pi*integral(P1of(a+(binv(-x)-a)*s)/"
                                            "sqrt((a-x+(binv(-x)-a)*s)*(x+bof(a+(binv(-x)-a)*s))), "
                                            "s, 0, 1)"),
                            p, p) == "");
    }
}

TEST_CASE("an unknown name inside an integral is refused and stated") {
    const Sample sample = sample_of(sampled_profiles()[6], "2/7");
    const EnclosedSample enclosed_sample(sample, 300);
    for (const char* text : {"integral(p(s), s, 0, a)", "integral(p(s)^2, s, -b, a)",
                             "integral(Pof(s), s, a/2, a)", "integral(abs(s), s, -b, a)",
                             "integral(P1of(s), s, -a/2, a)", "integral(bof(a - 3*s), s, 0, a)"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(static_cast<void>(enclosed_sample.evaluate(contact_formula(text))), Error);
    }
    Sample renamed = sample;
    renamed.variables.emplace("b", Exact::parse("1/3"));
    CHECK_THROWS_AS(
        static_cast<void>(
            EnclosedSample(renamed, 300).evaluate(contact_formula("integral(q(s), s, 0, a/2)"))),
        Error);
}

TEST_CASE("the integrals of the paper's ledger have balls that overlap, printed and exact") {
    const Ledger ledger = read_ledger(test::source_dir() / "verify" / "moore-hills.toml");
    const AuditContext context(ledger, aimed_digits);
    std::size_t found = 0;
    for (const char* id :
         {"EQ01",         "EQ02.p",    "EQ02.g",     "EQ03",        "EQ06.first", "EQ11",
          "EQ12",         "EQ17.flat", "EQ17.P",     "EQ20",        "EQ21.R",     "EQ21.L",
          "EQ22.P",       "EQ22.M",    "EQ34.force", "EQ34.strain", "EQ41",       "EQ46",
          "S53.equation", "S54.right", "S54.left",   "S54.stick",   "S18.none",   "S38.origin"}) {
        for (const Claim& claim : ledger.claims) {
            if (claim.id != id) {
                continue;
            }
            ++found;
            CAPTURE(claim.id);
            const ClaimSamples samples(claim, context, 3);
            CHECK(samples.all().size() >= 1);
            const Expr exact = claim.formula("of");
            for (const Sample& sample : samples.all()) {
                CAPTURE(full_text(sample));
                CHECK(fault_between(EnclosedSample(sample, 2 * bits_for(50), 42),
                                    claim.formula("says"), exact,
                                    claim.has("scale") ? claim.formula("scale") : exact) == "");
            }
        }
    }
    CHECK(found == 24);
}
