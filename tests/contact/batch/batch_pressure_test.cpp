// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/batch/batch_sums.hpp"
#include "edgeproof/quadrature/holomorphic_reach.hpp"
#include "tests/contact/batch/batch_pressure_points.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <thread>

using namespace edgeproof::scenes;
using Rule = BatchPressure::Rule;

namespace {

std::vector<Contact> all_contacts() {
    std::vector<Contact> all = symmetric();
    for (Contact& c : tilted()) {
        all.push_back(std::move(c));
    }
    all.push_back(own_symmetric());
    all.push_back(own_asymmetric());
    return all;
}

Contact flat() {
    return {"flat-and-rounded", Profile::flat_and_rounded(exact("0.4"), exact("3")), exact("7/3"),
            Load::right_edge(exact("1"))};
}

BatchDigits worst_of(const std::vector<Contact>& contacts, Rule rule, unsigned digits, int count) {
    BatchDigits all;
    for (const Contact& c : contacts) {
        const BatchDigits one = batch_digits(c, rule, digits, count);
        all.points += one.points;
        all.estimates_hold = all.estimates_hold && one.estimates_hold;
        all.most_nodes = std::max(all.most_nodes, one.most_nodes);
        if (one.worst < all.worst) {
            all.worst = one.worst;
            all.where = one.where;
        }
    }
    return all;
}

std::size_t nodes_at(Rule rule, unsigned digits, const char* u) {
    const Contact c = flat();
    const BatchPressure p(NormalContact(c.profile, c.modulus, c.load, digits + 10), digits, rule);
    const PrecisionScope scope(digits + 30);
    return p(Edge::right, exact(u).to<Real>()).evaluations;
}

/// Returns the number of nodes of a Gauss rule over an interval of half-length `half`, in which the
/// integrand is even (half of the nodes are summed) and the nearest poles are at `to_pole` from the
/// middle.
double halved_nodes(unsigned digits, double half, double to_pole) {
    const double t = to_pole / half;
    return (digits + 3) * std::numbers::ln10 / (4 * std::log(t + std::sqrt(t * t - 1)));
}

} // namespace

TEST_CASE("powers by roots and by logarithms are MPFR's") {
    for (const unsigned digits : {30U, 75U, 300U}) {
        const PrecisionScope scope(digits);
        const Real tolerance = pow(Real(10), 2 - static_cast<int>(digits));
        for (const char* e :
             {"-1/4", "1/3", "-63/200", "5", "0", "-7", "17/16", "-5/8192", "12345/7", "pi/4"}) {
            CAPTURE(e);
            RealPower power(exact(e));
            const Real exponent = exact(e).to<Real>();
            for (const char* text : {"1", "0.3", "1e-7", "1e-400", "123.456"}) {
                CAPTURE(text);
                const Real x(text);
                Real found;
                power(found, x);
                const Real expected = pow(x, exponent);
                CHECK(abs(found - expected) <=
                      tolerance * expected * (1 + abs(exponent)) * (1 + abs(log(x))));
            }
        }
    }
}

TEST_CASE("how far a function is holomorphic: never beyond a pole, and far where there is none") {
    const auto reach = [](const ComplexFunction& f, double most) {
        return holomorphic_reach(f, 0.5, 0.5, most, -120);
    };
    const auto entire = reach([](acb_t out, const acb_t z) { acb_exp(out, z, 64); }, 1e9);
    REQUIRE(entire);
    CHECK(entire->ellipse.rho >= 6);
    // The bound is at most exp at the rightmost point, and at least exp at the leftmost.
    const double rightmost = 1 + entire->ellipse.excess();
    CHECK(entire->ln_bound >= rightmost - 1e-6);
    CHECK(entire->ln_bound <= rightmost + 0.5);
    const auto pole = reach(
        [](acb_t out, const acb_t z) {
            acb_sub_ui(out, z, 2, 64);
            acb_inv(out, out, 64);
        },
        1e9);
    REQUIRE(pole);
    CHECK(pole->ellipse.excess() < 1);
    CHECK(pole->ellipse.excess() > 0.3);
    CHECK(pole->ln_bound >= -std::log(1 - pole->ellipse.excess()) - 1e-6);
    // The square near the pole may be nearer to it than the ellipse, by its own side.
    CHECK(pole->ln_bound <= -std::log(1 - pole->ellipse.excess()) + std::log(3.0));
    const auto limited = reach([](acb_t out, const acb_t z) { acb_exp(out, z, 64); }, 0.1);
    REQUIRE(limited);
    CHECK(limited->ellipse.excess() <= 0.1);
    CHECK_FALSE(reach(
        [](acb_t out, const acb_t z) {
            if (arb_contains_zero(acb_imagref(z)) != 0 &&
                arb_contains_nonpositive(acb_realref(z)) != 0) {
                acb_indeterminate(out);
            } else {
                acb_sqrt(out, z, 64);
            }
        },
        1e9));
}

TEST_CASE("Gauss-Legendre agrees with the enclosures to its digits, at every hard point") {
    const BatchDigits found = worst_of(all_contacts(), Rule::gauss_legendre, 50, 4);
    CAPTURE(found.where);
    CHECK(found.points >= 200);
    CHECK(found.worst >= 50);
    CHECK(found.estimates_hold);
    // At most the nodes for the slowest remaining pole: a piece takes at most 53 ln 10/1.1 of them,
    // and curved contacts have four pieces.
    CHECK(found.most_nodes <= 200);
}

TEST_CASE("tanh-sinh on the same integrand has them too") {
    const BatchDigits found =
        worst_of({flat(), symmetric()[3], symmetric()[8], tilted()[4], own_symmetric()},
                 Rule::tanh_sinh, 50, 4);
    CAPTURE(found.where);
    CHECK(found.points >= 50);
    CHECK(found.worst >= 50);
    CHECK(found.estimates_hold);
}

TEST_CASE("symmetric slopes, odd as formulas or not") {
    const Symbols x{"x"};
    std::vector<Contact> contacts;
    // Odd by form; odd by algebra or a table of logarithms; odd except for a corner; not odd.
    for (const char* slope : {"sinh(x)", "x/(sqrt(2 + x)*sqrt(2 - x))", "log((2 + x)/(2 - x))",
                              "1/20 + x + x^3", "x + x^2", "exp(x) - 1", "1/20 + x + x^2"}) {
        contacts.push_back({slope, Profile::piecewise_symmetric({}, {parse(slope, x)}),
                            exact("7/3"), Load::right_edge(exact("4/5"))});
    }
    const BatchDigits found = worst_of(contacts, Rule::gauss_legendre, 50, 4);
    CAPTURE(found.where);
    CHECK(found.points >= 40);
    CHECK(found.worst >= 50);
    CHECK(found.estimates_hold);
    // If g' is odd through the apex, the integrand continues analytically beyond it, and half of
    // one rule suffices.
    const auto nodes = [&](std::size_t k) {
        return worst_of({contacts[k]}, Rule::gauss_legendre, 50, 1).most_nodes;
    };
    CHECK(nodes(0) < nodes(4));
    CHECK(nodes(1) < nodes(2)); // x/(...) is proved to be odd, ln(...) is not
}

TEST_CASE("200 digits") {
    const BatchDigits found =
        worst_of({flat(), symmetric()[2], tilted()[5]}, Rule::gauss_legendre, 200, 3);
    CAPTURE(found.where);
    CHECK(found.worst >= 200);
    CHECK(found.estimates_hold);
}

TEST_CASE("power laws of every kind of exponent") {
    std::vector<Contact> laws;
    // Near an even exponent the parts of the rule near the apex cancel; for 1000 the nodes take
    // powers; pi/4 is irrational.
    for (const char* m : {"1e-3", "1/3", "0.999", "2", "2.000001", "3", "7/2", "pi/4", "1000"}) {
        laws.push_back({std::string("m = ") + m, Profile::power_law(exact("3"), exact(m)),
                        exact("7/3"), Load::right_edge(exact("5/4"))});
    }
    for (const Rule rule : {Rule::gauss_legendre, Rule::tanh_sinh}) {
        const BatchDigits found = worst_of(laws, rule, 50, 4);
        CAPTURE(found.where);
        CHECK(found.points >= 100);
        CHECK(found.worst >= 50);
        CHECK(found.estimates_hold);
    }
}

TEST_CASE("the number of nodes of a pressure follows the distances of the poles") {
    // At an edge of the flat punch (phi_t = 2 acos(t/a) = 2.319): the flat lies between phi_t and 2
    // pi - phi_t, with poles at 0 and 2 pi; the arcs lie between -phi_t and phi_t, with poles of
    // 1/(s + x) at -+2 pi. The number of nodes grows in steps of at most a tenth, or two.
    const double phi = 2 * std::acos(0.4);
    for (const unsigned digits : {50U, 100U, 200U, 500U}) {
        CAPTURE(digits);
        const double pi = std::numbers::pi;
        const double asked = halved_nodes(digits, pi - phi, pi) + halved_nodes(digits, phi, 2 * pi);
        const auto nodes = static_cast<double>(nodes_at(Rule::gauss_legendre, digits, "1e-8"));
        CHECK(nodes >= asked);
        CHECK(nodes <= 1.12 * asked + 8);
    }
    // Tanh-sinh has two pieces, each with the nodes of all levels to h = 1/32 (50 digits), 1/64,
    // 1/128: from asinh(ln(10) (w + 2)/pi) to its negative, where w is the number of digits of the
    // full words.
    const auto levels = [](double words, double steps) {
        return 2 * std::asinh(std::numbers::ln10 * (words + 2) / std::numbers::pi) * steps;
    };
    CHECK(std::abs(static_cast<double>(nodes_at(Rule::tanh_sinh, 50, "1e-8")) -
                   2 * levels(76, 32)) < 8);
    CHECK(std::abs(static_cast<double>(nodes_at(Rule::tanh_sinh, 100, "1e-8")) -
                   2 * levels(115, 64)) < 8);
}

TEST_CASE("near a knot the cost is bounded: the pole is subtracted") {
    const std::size_t far = nodes_at(Rule::gauss_legendre, 50, "0.3");
    for (const char* u : {"0.59", "0.599999", "0.6", "0.600001", "0.61"}) {
        CAPTURE(u);
        CHECK(nodes_at(Rule::gauss_legendre, 50, u) <= far);
    }
}

TEST_CASE("a piece that is singular at its end is left to tanh-sinh, with all digits") {
    // The same g' as a power law, whose enclosure is a series, and as a user's formula.
    const Symbols x{"x"};
    const Contact own{"x^(3/2)", Profile::piecewise_symmetric({}, {parse("x^(3/2)", x)}),
                      exact("7/3"), Load::right_edge(exact("5/4"))};
    const Contact law{"m = 3/2", Profile::power_law(exact("1"), exact("3/2")), exact("7/3"),
                      Load::right_edge(exact("5/4"))};
    const NormalContact contact(own.profile, own.modulus, own.load, 60);
    const BatchPressure fast(contact, 50);
    for (const char* u : {"1e-20", "1e-3", "0.7", "1.2"}) {
        CAPTURE(u);
        const PrecisionScope scope(80);
        const RoutedPressure<Real> p = fast(Edge::right, exact(u).to<Real>());
        const Ball truth = Enclosures(law)({Edge::right, exact(u)}, 60);
        CHECK(p.converged);
        CHECK(abs(p.value - truth.midpoint()) < abs(p.value) * pow(Real(10), -50));
    }
}

TEST_CASE("a corner, a place outside, and both sides of a symmetric contact") {
    const Contact c = own_symmetric();
    const BatchPressure fast(NormalContact(c.profile, c.modulus, c.load, 60), 50);
    const PrecisionScope scope(80);
    const Real a = Real(4) / 5;
    CHECK_THROWS_AS((void)fast(Point<Real>{a, a, Real(0)}), DomainError);
    // At 1e-60 from it the value is large, but finite.
    CHECK(fast(Point<Real>{a, a, pow(Real(10), -60)}).value > 2);
    CHECK_THROWS_AS((void)fast(Edge::right, Real(0)), DomainError);
    CHECK_THROWS_AS((void)fast(Edge::right, Real(2)), DomainError);
    const Real u = Real(1) / 7;
    CHECK(fast(Edge::left, u).value == fast(Edge::right, u).value);
    // The same place by u from the left edge and from the right edge.
    const Real here = fast(Edge::left, u).value;
    CHECK(abs(here - fast(Edge::right, Real(Real(8) / 5 - u)).value) < here * pow(Real(10), -60));
}

TEST_CASE("two precisions side by side in two threads") {
    const Contact c = tilted()[5];
    const auto run = [&](unsigned digits) {
        std::string values;
        for (int round = 0; round < 2; ++round) {
            const NormalContact contact(c.profile, c.modulus, c.load, digits + 10);
            const BatchPressure fast(contact, digits);
            const PrecisionScope scope(digits + 20);
            for (const char* u : {"1e-12", "0.01", "1/3", "2"}) {
                values += fast(Edge::right, exact(u).to<Real>()).value.str(digits) + "\n";
            }
        }
        return values;
    };
    std::string few;
    std::string many;
    std::thread first([&] { few = run(40); });
    std::thread second([&] { many = run(170); });
    first.join();
    second.join();
    CHECK(few == run(40));
    CHECK(many == run(170));
}

TEST_SUITE_BEGIN("slow");
TEST_CASE("100, 200 and 500 digits, every profile, both rules") {
    for (const unsigned digits : {100U, 200U, 500U}) {
        for (const Rule rule : {Rule::gauss_legendre, Rule::tanh_sinh}) {
            // Enclosures of curved profiles to 500 digits take minutes each.
            std::vector<Contact> contacts = all_contacts();
            if (digits == 500) {
                contacts.erase(contacts.end() - 2, contacts.end());
            }
            const BatchDigits found = worst_of(contacts, rule, digits, digits == 500 ? 2 : 8);
            CAPTURE(digits);
            CAPTURE(found.where);
            CHECK(found.points >= 150);
            CHECK(found.worst >= static_cast<int>(digits));
            CHECK(found.estimates_hold);
        }
    }
}
TEST_SUITE_END();
