// SPDX-License-Identifier: BSD-3-Clause
// Relations of the stresses in a body: to the tractions, and to the greatest stresses.
#include "edgeproof/precision/error.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"
#include "edgeproof/scene/binary64_values.hpp"
#include "tests/scene/scene_words.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ios>
#include <optional>
#include <tuple>

using namespace edgeproof::scenes;

namespace {

Real real_of(const Ball& x) { return at_working_precision(x.midpoint()); }

/// `johnson1985`, eq. 2.23, over the pressure and the shear traction of a scene, by tanh-sinh
/// quadrature.
class TractionIntegrals {
public:
    /// The tractions have `digits` digits, and the integrals fewer: see at().
    TractionIntegrals(const Scene& s, unsigned digits)
        : values_(s, asked(s), {digits, Rounding::nearest, false}), digits_(digits),
          shear_(s.shear.has_value()) {
        const auto length = [&](Quantity quantity) {
            return real_of(values_.value({quantity}).value);
        };
        a_ = length(Quantity::a);
        b_ = length(Quantity::b);
        ends_ = {Real(-b_), Real(0), a_};
        if (s.slips() && !s.history) {
            ends_.push_back(length(Quantity::stick_a));
            ends_.push_back(Real(-length(Quantity::stick_b)));
        }
        if (s.history) {
            for (const LoadHistory::Layer& layer : s.history->layers) {
                Scene part = s;
                part = part.without_shear();
                part.load = Load::force(layer.force);
                SceneValues edges(part, {{Quantity::a}, {Quantity::b}},
                                  {digits + 12, Rounding::nearest, false});
                ends_.push_back(real_of(edges.value({Quantity::a}).value));
                ends_.push_back(Real(-real_of(edges.value({Quantity::b}).value)));
            }
        }
        for (const formula::Exact& knot : s.profile->knots()) {
            ends_.push_back(knot.to<Real>());
        }
    }

    /// sxx, szz, sxz of the tractions at a place of a body, which carries `side` times q, to
    /// `target` digits. With `apart` the integrals are divided at x, for a small depth.
    [[nodiscard]] std::array<Real, 3> at(const Real& x, const Real& z, long side, unsigned target,
                                         bool apart) {
        std::vector<Real> ends = ends_;
        if (apart) {
            ends.push_back(x);
        }
        std::erase_if(ends, [&](const Real& s) { return s < -b_ || s > a_; });
        std::sort(ends.begin(), ends.end());
        std::array<Real, 3> sum{Real(0), Real(0), Real(0)};
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            const Real length = ends[i + 1] - ends[i];
            if (length < pow(Real(10), -static_cast<int>(digits_))) {
                continue;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const auto f = [&](const Real& lo, const Real& hi) {
                    const Real s = ends[i] + length * lo;
                    const auto edge = s > 0 ? Edge::right : Edge::left;
                    const Real u = s > 0 ? Real(a_ - ends[i + 1] + length * hi)
                                         : Real(b_ + ends[i] + length * lo);
                    const Real d = x - s;
                    const Real r2 = d * d + z * z;
                    const std::array<Real, 3> of_p{z * d * d, z * z * z, z * z * d};
                    const std::array<Real, 3> of_q{d * d * d, z * z * d, z * d * d};
                    Real load = traction(Quantity::p, edge, u) * of_p[k];
                    if (shear_) {
                        load += side * traction(Quantity::q, edge, u) * of_q[k];
                    }
                    return Real(load / (r2 * r2) * length);
                };
                sum[k] += quadrature::tanh_sinh(f, {.target_digits = target}).value;
            }
        }
        for (Real& x_k : sum) {
            x_k *= -2 / edgeproof::pi<Real>();
        }
        return sum;
    }

private:
    static std::vector<AskedValue> asked(const Scene& s) {
        std::vector<AskedValue> list{{Quantity::p}, {Quantity::a}, {Quantity::b}};
        list.front().u = Exact::parse("1/9");
        if (s.shear) {
            list.push_back({Quantity::q});
        }
        if (s.slips()) {
            list.push_back({Quantity::stick_a});
        }
        return list;
    }
    [[nodiscard]] Real traction(Quantity quantity, Edge edge, const Real& u) {
        AskedValue one{quantity, 0, edge};
        const std::string place = u.str(digits_ + 12, std::ios_base::scientific);
        auto& known = known_[{quantity, edge, place}];
        if (!known) {
            one.u = Exact::parse(place);
            known = real_of(values_.value(one).value);
        }
        return *known;
    }

    SceneValues values_;
    unsigned digits_;
    bool shear_;
    Real a_;
    Real b_;
    std::vector<Real> ends_;
    /// The values at the nodes that several integrals have in common.
    std::map<std::tuple<Quantity, Edge, std::string>, std::optional<Real>> known_;
};

const std::string modulus = " E=3/2 nu=0.3 digits=50 ";
/// All profiles with closed forms and a curved one, under all kinds of shear.
const std::vector<std::string> stressed_contacts{
    "hertz R=2 P=1" + modulus,
    "wedge phi=2/5 P=1 Q=-0.4 bulk_A=0.2" + modulus,
    "tilted-wedge phi=1/3 alpha=1/10 P=1 Q=0.3 bulk_tension=0.02 bulk_A=-0.1" + modulus,
    "piecewise symmetric knots=1/4;1/2 slopes=x/5;1/20+x-1/4;2/5+2*(x-1/2) P=1 Q=0.2 "
    "path=together" +
        modulus,
    "flat-and-rounded t=0.4 R=1 P=1 Q=-0.3 friction=1/2 bulk_tension=0.02 bulk_A=0.2" + modulus,
    "tilted-flat-and-rounded alpha=1/10 t=0.4 R=2 P=1 Q=0.3 friction=1/2 bulk_tension=-0.01" +
        modulus,
    "power-law m=5/2 C=1/3 P=1 Q=-0.3 friction=1/2 bulk_tension=0.02" + modulus,
    "power-law m=5/2 C=1/3 friction=1/2 [P=3/4,Q=1/4] [P=1] [Q=-0.4] [P=0.9,Q=0.1]" + modulus,
    "tilted-flat-and-rounded alpha=1/20 t=1/4 R=1 friction=1/2 [P=1] [P=1.2,Q=0.3] [P=0.8,Q=-0.1] "
    "[Q=0.2] [P=1.4]" +
        modulus,
    "hertz R=2 P=1 friction=1/2 sliding=left bulk_tension=0.02 bulk_A=0.2" + modulus,
    "power-law m=5/2 C=1/3 P=1 friction=3 sliding=right" + modulus,
    "power-law m=1/2 C=3 a=1/2 Q=0.3 bulk_tension=2/7" + modulus,
    "power-law m=10 C=2 a=5/4 Q=0.3 bulk_tension=-2/7" + modulus,
    "power-law m=100 C=2 a=0.9 Q=0.3 bulk_tension=2/7" + modulus,
    "flat-and-rounded t=0.999999 R=40 a=1.000001 Q=0.3 bulk_tension=2/7" + modulus,
    "flat-and-rounded t=1e-6 R=2 a=3/2 Q=0.3 bulk_tension=2/7" + modulus,
    "tilted-wedge phi=pi/3 alpha=-pi/7 P=1 Q=0.3 bulk_tension=2/7" + modulus,
    "tilted-flat-and-rounded alpha=pi/16 t=1 R=2 a=0.2 Q=0.3 bulk_tension=2/7" + modulus,
    "tilted-flat-and-rounded alpha=pi/16 t=1 R=2 a=3 Q=0.3 bulk_tension=2/7" + modulus,
    "piecewise knots=0 slopes=x;sinh(x)/2 P=1 Q=0.3 friction=1/2 bulk_tension=0.02" + modulus};

/// Compares the components at two or three points of each body with integrals of the tractions.
void compare_with_tractions(const std::string& words, unsigned digits, const char* tolerance,
                            bool apart) {
    CAPTURE(words);
    const PrecisionScope precision(digits + 16);
    Scene s = made(words);
    TractionIntegrals integrals(s, digits + 6);
    s.ask.quantities = {QuantityGroup::stress};
    for (const auto& [x, z, body] : {std::tuple{"0.35", "0.4", Body::A},
                                     {"-1.3", "1.7", Body::A},
                                     {"0.15", "1/20", Body::A},
                                     {"0.9", "0.6", Body::B},
                                     {"-0.2", "3", Body::B}}) {
        s.ask.in_bodies.push_back({Exact::parse(x), Exact::parse(z), body});
    }
    const SceneResult result = run_scene(s);
    for (const RowsAt& at : result.at_places(QuantityRow::Place::body)) {
        const BodyPoint& point = s.ask.in_bodies[at.point()];
        const long side = point.body == Body::A ? 1 : -1;
        std::array<Real, 3> expected = integrals.at(
            point.x.number()->to<Real>(), point.z.number()->to<Real>(), side, digits, apart);
        if (s.shear) {
            expected[0] += s.shear->bulk_A.to<Real>();
            expected[0] += side < 0 ? s.shear->bulk_tension.to<Real>() : Real(0);
        }
        const std::array components{Quantity::sxx, Quantity::szz, Quantity::sxz};
        for (std::size_t k = 0; k < 3; ++k) {
            CAPTURE(k);
            CHECK(at.at(components.at(k)).proved);
            CHECK(abs(Real(real_of(at.at(components.at(k)).value) - expected.at(k))) <
                  Real(tolerance));
        }
    }
}

} // namespace

TEST_CASE("stresses agree with integrals of the tractions") {
    for (const std::string& words : stressed_contacts) {
        if (words.find("sinh") == std::string::npos) {
            compare_with_tractions(words, 12, "1e-11", true);
        }
    }
}
TEST_CASE("stresses agree with integrals of the tractions to 40 digits" *
          doctest::test_suite("slow")) {
    for (const std::string& words : stressed_contacts) {
        const bool curved = words.find("sinh") != std::string::npos;
        compare_with_tractions(words, curved ? 12 : 43, curved ? "1e-11" : "1e-40", curved);
    }
}

TEST_CASE("sxx is nowhere greater on the surface than at the trailing edge") {
    for (const std::string words :
         {"tilted-flat-and-rounded alpha=0.1 t=0.4 R=2 a=1 E=3/2 Q=-0.1 friction=0.6 "
          "bulk_tension=0.03 bulk_A=0.2 digits=14",
          "tilted-wedge phi=0.2 alpha=0.05 a=1 E=3/2 Q=0.02 friction=0.3 digits=14",
          "power-law C=1 m=5/2 a=1 Q=0.1 friction=0.5 bulk_A=-0.1 digits=14"}) {
        CAPTURE(words);
        for (const Body body : {Body::A, Body::B}) {
            Scene s = made(words);
            const GreatestValue found = greatest_value(s, Quantity::sxx, body);
            s.ask.quantities = {QuantityGroup::stress};
            for (int i = -40; i <= 40; ++i) {
                s.ask.in_bodies.push_back(
                    {Exact::parse(std::to_string(2 * i + 1) + "/32"), Exact::of(0), body});
            }
            const SceneResult result = run_scene(s);
            for (const RowsAt& at : result.at_places(QuantityRow::Place::body)) {
                CHECK(certainly_less(at.at(Quantity::sxx).value, found.value.value));
            }
        }
    }
}

namespace {

/// Checks that tau_max or the stress of von Mises is at most the greatest one at the points of a
/// grid over the contact, and at points close to the edges of the zones, where it has cusps.
void check_that_none_is_greater(const Scene& s, std::size_t map, const Ball& greatest,
                                const std::vector<double>& edges) {
    std::vector<double> x;
    std::vector<double> z;
    for (int i = 0; i < 121 * 41; ++i) {
        x.push_back(-1.2 + 0.02 * (i % 121));
        z.push_back(0.02 * (i / 121));
    }
    for (const double edge : edges) {
        for (int k = 4; k <= 36; k += 4) {
            for (const double side : {-1.0, 1.0}) {
                for (const double across : {-1.0, 0.0, 1.0}) {
                    for (const double deep : {0.0, 1.0}) {
                        x.push_back(side * edge + std::ldexp(across, -k));
                        z.push_back(std::ldexp(deep, -k));
                    }
                }
            }
        }
    }
    std::vector<std::vector<double>> maps(6, std::vector<double>(x.size()));
    compute_binary64(s, Body::A, x, z, {maps[0], maps[1], maps[2], maps[3], maps[4], maps[5]});
    for (std::size_t i = 0; i < x.size(); ++i) {
        CHECK(Real(maps[map][i] - maps[5][i]) <= greatest.upper());
    }
}

void check_greatest_of(const std::string& words) {
    CAPTURE(words);
    const Scene s = made(words + " nu=0.3 digits=14");
    std::vector<double> edges{number_of(s, {Quantity::a})};
    if (s.history) {
        for (const LoadHistory::Layer& layer : s.history->layers) {
            Scene part = s.without_shear();
            part.load = Load::force(layer.force);
            edges.push_back(number_of(part, {Quantity::a}));
        }
    } else if (s.slips()) {
        edges.push_back(number_of(s, {Quantity::stick_a}));
    }
    for (const auto& [quantity, map] :
         {std::pair{Quantity::tau_max, std::size_t{3}}, {Quantity::mises, std::size_t{4}}}) {
        check_that_none_is_greater(s, map, greatest_value(s, quantity, Body::A).value.value, edges);
    }
}

} // namespace

TEST_CASE("no stress of a map is greater than the greatest stress of a cylinder") {
    check_greatest_of("hertz R=1 a=1 E=2");
    check_greatest_of("hertz R=1 a=1 E=2 Q=0.3 path=together bulk_A=0.2");
    check_greatest_of("hertz R=1 a=1 E=2 Q=-0.1 friction=0.6");
}
TEST_CASE("no stress of a map is greater than the greatest stress, also after a load history" *
          doctest::test_suite("slow")) {
    const std::string pad = "flat-and-rounded t=0.4 R=1 E=2 ";
    const std::string tilted = "tilted-flat-and-rounded alpha=0.1 t=0.4 R=2 a=1 E=3/2 ";
    for (const std::string& words :
         {pad + "friction=1/2 [P=1/2] [Q=1/5] [Q=-1/10]",
          pad + "friction=1/2 [P=1/2] [P=3/4,Q=1/10] [Q=-1/20]",
          pad + "friction=1/2 [P=1/2] [P=3/4,Q=1/10] [P=1/2,Q=-1/20]", pad + "a=1",
          pad + "a=1 Q=0.1 path=together bulk_A=1/9", pad + "a=1 Q=0.1 friction=0.6 bulk_A=-0.1",
          std::string("power-law m=1/2 C=1 a=1 E=2 Q=0.1 path=together"), tilted,
          tilted + "Q=-0.1 friction=0.6 bulk_tension=0.03 bulk_A=0.2"}) {
        check_greatest_of(words);
    }
}
