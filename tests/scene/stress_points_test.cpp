// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/split_mix.hpp"
#include "tests/scene/traction_integrals.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

using scene::Body;

namespace {

/// Draws contacts of all profiles with closed forms, under all kinds of shear, up to six steps.
class DrawnContacts {
public:
    explicit DrawnContacts(std::uint64_t seed) : random_(seed) {}

    std::string scene() {
        const std::size_t kind = drawn(7);
        const bool power_law = kind < 2;
        std::string text = "[profile]\n" + profile(kind) + "[load]\ncontact_modulus = \"" +
                           number(1, 3) + "\"\nnu = \"" + number(0.1, 0.4) + "\"\n";
        switch (drawn(5)) {
        case 0: // full stick, or nothing
            text +=
                "P = 1\n" +
                (drawn(3) == 0 ? "" : "[shear]\nQ = \"" + number(-0.5, 0.5) + "\"\n" + tension());
            break;
        case 1:
            text += "P = 1\n[shear]\nQ = \"" + number(-0.5, 0.5) + "\"\npath = \"together\"\n";
            break;
        case 2: // a small tension, so that the stick zone stays inside
            text += "P = 1\n[shear]\nfriction = \"1/2\"\nQ = \"" + number(0.1, 0.4) + "\"\n" +
                    (power_law ? "" : "bulk_tension = \"" + number(-0.01, 0.01) + "\"\n");
            break;
        default:
            text += "[shear]\nfriction = \"1/2\"\n[[step]]\nP = 1\n";
            for (std::size_t step = drawn(6); step > 0; --step) {
                text += "[[step]]\nP = \"" + number(0.7, 1.4) + "\"\nQ = \"" + number(-0.33, 0.33) +
                        "\"\n";
            }
        }
        return text + "[ask]\ndigits = 50\n";
    }
    /// A number of thousandths from `from` to `to`.
    std::string number(double from, double to) {
        const long first = std::lround(1000 * from);
        const auto count = static_cast<std::size_t>(std::lround(1000 * to) - first + 1);
        return std::to_string(first + static_cast<long>(random_.below(count))) + "/1000";
    }
    std::size_t drawn(std::size_t count) { return random_.below(count); }

private:
    std::string tension() {
        return drawn(2) == 0 ? ""
                             : "bulk_tension = \"" + number(-0.3, 0.3) + "\"\nbulk_A = \"" +
                                   number(-0.3, 0.3) + "\"\n";
    }
    std::string profile(std::size_t kind) {
        const std::array<std::string, 4> exponents{"1", "3/2", "5/2", "3"};
        switch (kind) {
        case 0:
        case 1:
            return "kind = \"power-law\"\nm = \"" + exponents.at(drawn(4)) + "\"\nC = \"" +
                   number(0.2, 2) + "\"\n";
        case 2:
            return "kind = \"flat-and-rounded\"\nt = \"" + number(0.1, 0.9) + "\"\nR = \"" +
                   number(0.5, 3) + "\"\n";
        case 3:
            return "kind = \"tilted-flat-and-rounded\"\nt = \"" + number(0.1, 0.5) + "\"\nR = \"" +
                   number(0.5, 2) + "\"\nalpha = \"" + number(0.01, 0.1) + "\"\n";
        case 4:
            return "kind = \"wedge\"\nphi = \"" + number(0.1, 1) + "\"\n";
        case 5:
            return "kind = \"tilted-wedge\"\nphi = \"" + number(0.3, 1) + "\"\nalpha = \"" +
                   number(-0.1, 0.1) + "\"\n";
        default:
            return "kind = \"piecewise\"\nsymmetric = true\nknots = [\"1/4\", \"1/2\"]\nslopes = "
                   "[\"x/5\", "
                   "\"1/20 + x - 1/4\", \"3/10 + " +
                   number(0, 0.5) + " + 2*(x - 1/2)\"]\n";
        }
    }
    SplitMix64 random_;
};

} // namespace

// The integrals of Johnson's concentrated forces over p and q by tanh-sinh quadrature: they share
// no formula with the Cauchy integrals.
TEST_CASE("stresses at 500 drawn points of 60 drawn contacts agree with integrals to 50 digits" *
          doctest::test_suite("slow")) {
    const PrecisionScope precision(70);
    DrawnContacts draw(3450);
    std::size_t contacts = 0;
    std::size_t points = 0;
    std::size_t refused = 0;
    while (contacts < 60) {
        const std::string text = draw.scene();
        CAPTURE(text);
        std::optional<scenes::TractionIntegrals> integrals;
        Scene s;
        try {
            s = scene::parse_scene(text, "drawn.toml");
            integrals.emplace(s, 56);
        } catch (const InputError&) { // it slides, or the tension is too large
            REQUIRE(++refused < 60);
            continue;
        }
        ++contacts;
        s.ask.quantities = {scene::QuantityGroup::stress};
        const std::size_t count = contacts <= 20 ? 9 : 8;
        for (std::size_t i = 0; i < count; ++i) {
            s.ask.in_bodies.push_back({formula::Exact::parse(draw.number(-2, 2)),
                                       formula::Exact::parse(draw.number(0.3, 3)),
                                       draw.drawn(2) == 0 ? Body::A : Body::B});
        }
        const scene::SceneResult result = run_scene(s);
        for (const scene::RowsAt& at : result.at_places(scene::QuantityRow::Place::body)) {
            ++points;
            const scene::BodyPoint& point = s.ask.in_bodies[at.point()];
            const long side = point.body == Body::A ? 1 : -1;
            Real bulk(0);
            if (s.shear) {
                bulk = s.shear->bulk_A.to<Real>();
                bulk += side < 0 ? s.shear->bulk_tension.to<Real>() : Real(0);
            }
            const std::array<Real, 3> expected =
                integrals->at(point.x.to<Real>(), point.z.to<Real>(), side, 53, false);
            const auto agrees = [&](Quantity quantity, const Real& value) {
                CAPTURE(at.at(quantity).value.midpoint().str(52));
                CAPTURE(value.str(52));
                CHECK(at.at(quantity).proved);
                CHECK(abs(Real(scenes::real_of(at.at(quantity).value) - value)) < Real("1e-49"));
            };
            agrees(Quantity::sxx, expected[0] + bulk);
            agrees(Quantity::szz, expected[1]);
            agrees(Quantity::sxz, expected[2]);
        }
    }
    CHECK(points == 500);
}
