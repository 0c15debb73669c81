// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/slip/ball_slip.hpp"

#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/contact/slip/slip_reach.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "tests/contact/scenes.hpp"

#include <doctest/doctest.h>

#include <map>
#include <memory>

using namespace edgeproof::scenes;

namespace {

constexpr long slip_bits = 400;

/// A contact with its zones and its slip; f = 3/5.
struct Slipping {
    std::unique_ptr<ProvedContact> of;
    std::unique_ptr<ZoneSolver> zones;
    std::unique_ptr<BallSlip> slip;
};

struct SlipCase {
    Contact contact;
    const char* r; ///< sigma_0/Q
};

/// The contacts whose zones are rows of tests/scene/values.txt.
std::vector<SlipCase> slip_cases() {
    std::vector<SlipCase> cases;
    for (const char* r : {"0", "1/4"}) {
        for (const Contact& c : contacts({"power-law m=1 C=1 a=1 E=1", "power-law m=0 C=0.3 a=3/2",
                                          "flat-and-rounded t=0.4 R=3 a=1.5 E=2",
                                          "tilted-wedge phi=pi/16 alpha=pi/20 a=1.5",
                                          "tilted-flat-and-rounded alpha=pi/16 t=1 R=2 a=3",
                                          "power-law m=3 C=1/5 a=1.25"})) {
            cases.push_back({c, r});
        }
    }
    return cases;
}

Ball number(const std::string& text, long bits = slip_bits) {
    return enclosed_constant(exact(text), bits);
}

Slipping slipping(const SlipCase& c, const std::string& tau, long bits = slip_bits) {
    Slipping s;
    const auto& [name, profile, modulus, load] = c.contact;
    if (exact(c.r).sign() != 0 && !profile.piecewise_linear()) {
        auto curved = std::make_unique<IntegratedContact>(profile, modulus, load, bits);
        s.zones = integrated_zones(*curved);
        s.of = std::move(curved);
    } else {
        s.of = proved_contact(profile, modulus, load, bits);
        s.zones = closed_form_zones(*s.of->closed_form());
    }
    const Ball f(Rational(3, 5), bits);
    const Ball Q = number(tau, bits) * f * s.of->force();
    s.slip = std::make_unique<BallSlip>(*s.of, *s.zones, s.of->force(),
                                        ShearLoad<Ball>{Q, number(c.r, bits) * Q}, f);
    return s;
}

EnclosedReach reach_of(const SlipCase& c, Edge edge, std::size_t n, const char* tolerance,
                       long bits) {
    std::map<long, Slipping> levels;
    SlipReachSearch search(
        [&](long level) -> const BallSlip& {
            auto& s = levels[level];
            if (!s.slip) {
                s = slipping(c, "1/10", level);
            }
            return *s.slip;
        },
        edge, n, exact(tolerance));
    return search.at(bits);
}

} // namespace

// The remainder of n terms is of the order tau^(n + 1), in both directions: it is given by the next
// coefficient.
TEST_CASE("the series of the slip zones approaches their sizes at its order") {
    for (const SlipCase& c : slip_cases()) {
        CAPTURE(c.contact.name);
        const Slipping s = slipping(c, "1e-8");
        const Ball tau = number("1e-8");
        const auto series = s.slip->series(5);
        for (const Edge edge : {Edge::right, Edge::left}) {
            const auto& kappa = edge == Edge::right ? series.right : series.left;
            const Ball rest = (s.slip->size(edge) - slip_sum(kappa, 4, tau)) / pow_int(tau, 5);
            const Ball unit = number("1e-6") * (s.slip->whole().length() + abs(kappa[4]));
            CHECK(certainly_less(abs(Ball(rest - kappa[4])), unit));
        }
    }
}

// At the end of the reach the error is the tolerance, and it is smaller before; computed from the
// sizes alone.
TEST_CASE("how far the terms stay within a tolerance, tilted and under tension") {
    for (const SlipCase& c : slip_cases()) {
        if (c.contact.name.starts_with("power-law m=3")) {
            continue; // integrals take longer
        }
        CAPTURE(c.contact.name);
        for (const Edge edge : {Edge::right, Edge::left}) {
            for (const std::size_t n : {1UL, 3UL}) {
                CAPTURE(n);
                const auto reach = reach_of(c, edge, n, "1/100", 256);
                const auto error = [&](const Rational& tau) {
                    const Slipping s = slipping(c, tau.str());
                    const auto series = s.slip->series(n);
                    const auto& kappa = edge == Edge::right ? series.right : series.left;
                    return Ball(slip_sum(kappa, n, s.slip->load_ratio()) / s.slip->size(edge) - 1);
                };
                const Ball bound(Rational(1, 100), slip_bits);
                if (!reach.leaves) {
                    CHECK(certainly_less(abs(error(Rational(99, 100))), bound));
                    continue;
                }
                const Rational end = exact(reach.ratio.midpoint().str(30)).rational();
                const Ball at_end = abs(error(end));
                const Ball unit(Rational(1, Integer(Integer(1) << 80U)), slip_bits);
                CHECK(certainly_less(abs(Ball(at_end - bound)), unit));
                CHECK(certainly_less(abs(error(end / 2)), bound));
                CHECK(certainly_less(abs(error(end * Rational(19, 20))), bound));
            }
        }
    }
}
