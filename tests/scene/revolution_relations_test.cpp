// SPDX-License-Identifier: BSD-3-Clause
// A ring of pressure displaces the surface of a half-space by an elliptic integral (johnson1985,
// eqs. 3.96, 3.97 and section 3.8): u_z(r) = 4/(pi E*) times the integral of
// p(s) s/(r + s) K(2 sqrt(r s)/(r + s)) ds over the contact. It is delta - g(r) inside the contact,
// and delta - g(r) plus the gap, which is positive, outside. This shares nothing with Sneddon's
// relations, by which tests/oracles/axisymmetric.py computes the values.
#include "edgeproof/quadrature/tanh_sinh.hpp"
#include "tests/scene/scene_words.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <ios>

using namespace edgeproof::scenes;

namespace {

std::string decimal_of(const Real& x) { return x.str(40, std::ios_base::scientific); }

/// One contact of revolution with E* = 1 by single values.
class Revolved {
public:
    explicit Revolved(const std::string& words)
        : words_(words), scene_(made(words)),
          values_(scene_, {{Quantity::P}, {Quantity::delta}, {Quantity::a}, at_u("1e-30")}, {20}),
          a_(value({Quantity::a})) {
        for (const Exact& knot : scene_.round->profile.knots()) {
            if (const Real v = knot.to<Real>(); v > 0 && v < a_) {
                knots_.push_back(v);
            }
        }
    }
    [[nodiscard]] const Real& a() const { return a_; }
    Real value(const AskedValue& asked) {
        const BoundedValue found = values_.value(asked);
        CHECK(found.proved);
        return at_working_precision(found.value.midpoint());
    }
    Real gap(const std::string& x) const {
        AskedValue asked{Quantity::gap};
        asked.place = Place::parse(x, Place::From::origin, {}).distance(Edge::right);
        SceneValues values(scene_, {asked}, {25});
        return at_working_precision(values.value(asked).value.midpoint());
    }
    /// The integral of p(s) f(s, |s - r|) ds over the contact.
    Real integral(const Real& r, const std::function<Real(const Real&, const Real&)>& f) {
        std::vector<Real> ends{Real(0), a_};
        ends.insert(ends.end(), knots_.begin(), knots_.end());
        if (r < a_) {
            ends.push_back(r);
        }
        std::ranges::sort(ends);
        Real sum = 0;
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            const Real width = ends[i + 1] - ends[i];
            const auto integrand = [&](const Real& lo, const Real& hi) {
                const Real u = (a_ - ends[i + 1]) + width * hi;
                const Real apart = ends[i] < r ? Real(abs(Real(r - ends[i + 1])) + width * hi)
                                               : Real((ends[i] - r) + width * lo);
                // Where p may be infinite, nodes that are rounded to the place are negligible.
                const bool near = std::ranges::any_of(
                    knots_, [&](const Real& v) { return abs(Real(a_ - u - v)) < a_ * tiny; });
                return near || a_ - u < a_ * tiny ? Real(0)
                                                  : Real(value(at_u(decimal_of(u))) *
                                                         f(Real(ends[i] + width * lo), apart));
            };
            sum += width * quadrature::tanh_sinh(integrand, {.target_digits = 14}).value;
        }
        return sum;
    }

private:
    static AskedValue at_u(const std::string& u) {
        AskedValue asked{Quantity::p};
        asked.u = Exact::parse(u);
        return asked;
    }
    const Real tiny{"1e-30"};
    std::string words_;
    Scene scene_;
    SceneValues values_;
    Real a_;
    std::vector<Real> knots_;
};

/// K(k) with k'^2 = 1 - k^2, by the arithmetic-geometric mean (DLMF 19.8.5).
Real complete_integral(const Real& k_complement) {
    Real mean = 1;
    Real root = k_complement;
    for (int i = 0; i < 12 && root != 0; ++i) {
        const Real next = (mean + root) / 2;
        root = sqrt(Real(mean * root));
        mean = next;
    }
    return root == 0 ? Real(0) : Real(pi<Real>() / (2 * mean));
}

/// `height`: g(r) at each place.
void check_revolved(const std::string& words,
                    const std::vector<std::pair<std::string, std::string>>& height) {
    CAPTURE(words);
    const PrecisionScope precision(45);
    Revolved body(words);
    const Real P = body.value({Quantity::P});
    const Real delta = body.value({Quantity::delta});
    const Real whole =
        2 * pi<Real>() * body.integral(body.a(), [](const Real& s, const Real&) { return s; });
    CHECK(abs(Real(whole - P)) < P * Real("1e-12"));
    for (const auto& at : height) {
        const auto& place = at.first;
        const auto& g = at.second;
        CAPTURE(place);
        const Real r = Exact::parse(place).to<Real>();
        const Real lifted = body.integral(r, [&](const Real& s, const Real& apart) {
            return Real(4 / pi<Real>() * s / (r + s) * complete_integral(Real(apart / (r + s))));
        });
        const Real gap = r > body.a() ? body.gap(place) : Real(0);
        CHECK((r < body.a() || gap > 0));
        CHECK(abs(Real(lifted - (delta - Exact::parse(g).to<Real>() + gap))) <
              delta * Real("1e-12"));
    }
}

} // namespace

TEST_CASE("the pressure of a body of revolution returns its profile, its load and its gap") {
    check_revolved("axisymmetric flat-and-rounded t=2/5 R=3 a=1", {{"3/2", "(11/10)^2/6"}});
}
TEST_CASE("the pressures of bodies of revolution return their profiles, loads and gaps" *
          doctest::test_suite("slow")) {
    const std::string piecewise = "axisymmetric piecewise symmetric ";
    check_revolved("axisymmetric flat-and-rounded t=2/5 R=3 a=1", {{"7/10", "(3/10)^2/6"}});
    // a cone with a rounded tip, a truncated cone, an apex with a corner and a change of the rate
    check_revolved(piecewise + "knots=1/2 slopes=x;1/2 P=2",
                   {{"1/5", "1/50"}, {"4/5", "2/5-1/8"}, {"3", "3/2-1/8"}});
    check_revolved(piecewise + "knots=1/3 slopes=0;1/4 a=3/4",
                   {{"1/5", "0"}, {"1/2", "1/24"}, {"1", "1/6"}});
    check_revolved(piecewise + "knots=1/4;1/2 slopes=1/10;1/5+x/3;3/10+2*x/15 delta=1/4",
                   {{"1/8", "1/80"}, {"3/8", "1/40+1/40+(9/64-1/16)/6"}});
    check_revolved("axisymmetric power-law m=1/3 C=3/7 P=1", {{"1/5", "9/28*(1/5)^(4/3)"}});
    check_revolved("axisymmetric power-law m=4 C=3/7 a=5/4",
                   {{"1/5", "3/35*(1/5)^5"}, {"2", "3/35*32"}});
    check_revolved(piecewise + "slopes=sinh(x) a=1", {{"1/2", "cosh(1/2)-1"}});
}
