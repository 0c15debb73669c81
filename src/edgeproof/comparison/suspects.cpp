// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/suspects.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace edgeproof::comparison {
namespace {

using formula::Expr;

Expr integer(long k) { return Expr::number(Rational(k)); }
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

class Suspects {
public:
    Suspects(const AlignedResult& data, const scene::Scene& scene, const ExactContact& exact,
             const std::function<void(const Suspect&)>& take)
        : data_(data), scene_(scene), exact_(exact), take_(take) {}

    void all() {
        factors();
        scales();
        moduli();
        sizes();
        places();
        terms();
    }

private:
    /// p as a function of the place, on the contact of `of`.
    void suspect(const std::string& name, const std::string& what, double a, double b,
                 const std::function<double(std::size_t)>& p) {
        check_interruption();
        Suspect s{name, what, a, b, {}};
        for (std::size_t i = 0; i < data_.nodes.size(); ++i) {
            s.p.push_back(p(i));
        }
        take_(s);
    }
    [[nodiscard]] double exact_p(std::size_t i) const {
        return data_.nodes[i].exact.p.value_or(nothing);
    }
    static double p_of(const ExactContact& contact, double x) {
        return contact.at(Real(x)).p.value_or(nothing);
    }

    void factor(const char* name, const std::string& what, double k) {
        suspect(name, what, exact_.a().value, exact_.b().value,
                [&](std::size_t i) { return k * exact_p(i); });
    }
    void both_ways(const char* name, const std::string& what, double k) {
        factor(name, "p is " + what + " times too large", k);
        factor(name, "p is " + what + " times too small", 1 / k);
    }
    void factors() {
        both_ways("factor-2", "2", 2);
        both_ways("factor-pi", "pi", std::numbers::pi);
        both_ways("factor-sqrt-pi", "sqrt(pi)", std::sqrt(std::numbers::pi));
        both_ways("unit-g", "9.80665", 9.80665);
        // 6894.757 Pa are one psi.
        for (const double ten : {1.0, 1e-3, 1e3}) {
            both_ways("unit-psi", fmt::format("{:g}", 6894.757293168 * ten), 6894.757293168 * ten);
        }
        for (const int n : {1, 2, 3, 4, 5, 6, 9}) {
            both_ways("power-of-ten", fmt::format("1e{}", n), std::pow(10.0, n));
        }
    }
    /// x in another unit.
    void scales() {
        const auto scale = [&](const char* name, double k) {
            suspect(name, fmt::format("x is {:g} times too large", k), exact_.a().value * k,
                    exact_.b().value * k,
                    [&](std::size_t i) { return p_of(exact_, data_.nodes[i].x / k); });
        };
        for (const int n : {1, 2, 3, 6}) {
            scale("power-of-ten", std::pow(10.0, n));
            scale("power-of-ten", std::pow(10.0, -n));
        }
        scale("unit-inch", 25.4);
        scale("unit-inch", 1 / 25.4);
        scale("full-width-for-half", 2);
        scale("full-width-for-half", 0.5);
    }

    /// The same contact with something else in its scene.
    void scene_with(const char* name, const std::string& what,
                    const std::function<void(scene::Scene&)>& change) {
        try {
            scene::Scene other = scene_;
            other.shear.reset();
            change(other);
            const ExactContact contact(other);
            suspect(name, what, contact.a().value, contact.b().value,
                    [&](std::size_t i) { return p_of(contact, data_.nodes[i].x); });
        } catch (const Error&) { // no contact: no program could have computed it
        }
    }
    void modulus(const char* name, const std::string& what, const Expr& modulus) {
        scene_with(name, what,
                   [&](scene::Scene& s) { s.contact_modulus = formula::Exact(modulus); });
    }
    void moduli() {
        const Expr E = scene_.contact_modulus.expr();
        if (!scene_.bodies) {
            modulus("factor-2", "E* is twice too large", E * integer(2));
            modulus("factor-2", "E* is half as large", E / integer(2));
            modulus("factor-pi", "E* is pi times too large", E * Expr::pi());
            modulus("factor-pi", "E* is pi times too small", E / Expr::pi());
            return;
        }
        const Expr E1 = scene_.bodies->E1.expr();
        const Expr E2 = scene_.bodies->E2.expr();
        const Expr nu1 = scene_.bodies->nu1.expr();
        const Expr nu2 = scene_.bodies->nu2.expr();
        const Expr one = integer(1);
        const bool alike = E1 == E2 && nu1 == nu2;
        const auto of_two = [&](const Expr& c1, const Expr& c2) { return one / (c1 + c2); };
        modulus("e-for-e-star", "E of body 1 for E*", E1);
        modulus("one-body-modulus", "E/(1 - nu^2) of body 1 for E*", E1 / (one - nu1 * nu1));
        modulus("shear-modulus", "2G of body 1 for E*", E1 / (one + nu1));
        modulus("shear-modulus", "G of body 1 for E*", E1 / (integer(2) * (one + nu1)));
        if (!alike) {
            modulus("e-for-e-star", "E of body 2 for E*", E2);
            modulus("one-body-modulus", "E/(1 - nu^2) of body 2 for E*", E2 / (one - nu2 * nu2));
            modulus("one-body-modulus", "body 1 for both", E1 / (integer(2) * (one - nu1 * nu1)));
            modulus("one-body-modulus", "body 2 for both", E2 / (integer(2) * (one - nu2 * nu2)));
        }
        modulus("nu-not-squared", "1 - nu for 1 - nu^2",
                of_two((one - nu1) / E1, (one - nu2) / E2));
        modulus("plane-stress", "plane stress, 1/E* = 1/E1 + 1/E2", of_two(one / E1, one / E2));
        modulus("shear-modulus", "2G of the bodies for E/(1 - nu^2)",
                of_two((one + nu1) / E1, (one + nu2) / E2));
    }

    void parameter(const char* name, const std::string& what, const char* key, const Expr& times) {
        if (!scene_.profile || !scene_.profile->parameters().contains(key)) {
            return;
        }
        scene_with(name, what, [&](scene::Scene& s) {
            const auto& values = scene_.profile->parameters();
            const auto get = [&](const char* k) {
                const formula::Exact& value = values.at(k);
                return k == std::string_view(key) ? formula::Exact(value.expr() * times) : value;
            };
            switch (scene_.profile->kind()) {
            case contact::Profile::Kind::power_law:
                s.profile = contact::Profile::power_law(get("C"), get("m"));
                return;
            case contact::Profile::Kind::flat_and_rounded:
                s.profile = contact::Profile::flat_and_rounded(get("t"), get("R"));
                return;
            case contact::Profile::Kind::tilted_wedge:
                s.profile = contact::Profile::tilted_wedge(get("phi"), get("alpha"));
                return;
            case contact::Profile::Kind::tilted_flat_and_rounded:
                s.profile =
                    contact::Profile::tilted_flat_and_rounded(get("alpha"), get("t"), get("R"));
                return;
            default: // nothing is suspected of a profile of another kind
                return;
            }
        });
    }
    void sizes() {
        const Expr two = integer(2);
        const Expr half = integer(1) / two;
        const bool circle =
            scene_.profile && scene_.profile->kind() == contact::Profile::Kind::power_law &&
            contact::certainly_zero(scene_.profile->parameters().at("m").expr() - integer(1));
        if (circle) {
            parameter("radius-as-diameter", "half the radius", "C", two);
            parameter("radius-as-diameter", "the diameter for the radius", "C", half);
        } else {
            parameter("factor-2", "C is twice too large", "C", two);
            parameter("factor-2", "C is half as large", "C", half);
        }
        parameter("radius-as-diameter", "the diameter for the radius", "R", two);
        parameter("radius-as-diameter", "half the radius", "R", half);
        parameter("flat-as-full-width", "the length of the flat for its half", "t", two);
        parameter("flat-as-full-width", "half of the flat's half-length", "t", half);
        const auto load = [&](const char* name, const std::string& what, const Expr& times) {
            scene_with(name, what, [&](scene::Scene& s) {
                s.load.value = formula::Exact(s.load.value.expr() * times);
            });
        };
        if (scene_.load.kind == contact::Load::Kind::force) {
            load("half-force", "half of P", half);
            load("half-force", "twice P", two);
        } else {
            load("full-width-for-half", "the width of the contact for a", two);
            load("full-width-for-half", "a quarter of the width for a", half);
        }
        if (scene_.moment) {
            scene_with("sign-of-moment", "M of the other sign",
                       [](scene::Scene& s) { s.moment = formula::Exact(-s.moment->expr()); });
        }
    }

    void places() {
        if (!exact_.symmetric()) {
            suspect("mirrored", "x runs the other way: the tilt is mirrored", exact_.b().value,
                    exact_.a().value,
                    [&](std::size_t i) { return p_of(exact_, -data_.nodes[i].x); });
        }
        for (const int rows : {1, -1}) {
            suspect("shifted-rows", "p stands one row off its x", exact_.a().value,
                    exact_.b().value, [&](std::size_t i) {
                        const auto at = static_cast<std::ptrdiff_t>(i) + rows;
                        return at < 0 || at >= std::ssize(data_.nodes)
                                   ? nothing
                                   : exact_p(static_cast<std::size_t>(at));
                    });
        }
        shifts();
    }
    /// The shift that fits best, by its derivative: small ones alone, as a large one is an origin.
    void shifts() {
        double shift = 0;
        for (int round = 0; round < 6; ++round) {
            double top = 0;
            double bottom = 0;
            for (const Node& node : data_.nodes) {
                const double step = 1e-4 * exact_.length();
                const double x = node.x - shift;
                const double margin = 0.05 * exact_.length();
                if (x > exact_.a().value - margin || x < -exact_.b().value + margin) {
                    continue;
                }
                const double slope = (p_of(exact_, x + step) - p_of(exact_, x - step)) / (2 * step);
                const double p = p_of(exact_, x);
                if (std::isfinite(slope) && std::isfinite(p)) {
                    top += slope * (p - node.p);
                    bottom += slope * slope;
                }
            }
            shift += bottom > 0 ? top / bottom : 0;
            if (std::abs(shift) > 0.1 * exact_.length()) {
                return;
            }
        }
        suspect("shifted-origin", fmt::format("x is shifted by {:.4g}", shift),
                exact_.a().value + shift, exact_.b().value - shift,
                [&](std::size_t i) { return p_of(exact_, data_.nodes[i].x - shift); });
    }

    void terms() {
        static constexpr std::array names{"one-term", "two-term", "three-term"};
        for (std::size_t n = 1; n <= names.size(); ++n) {
            suspect(names[n - 1],
                    fmt::format("the first {} of the expansion at the nearer edge for p",
                                n == 1 ? "term" : fmt::format("{} terms", n)),
                    exact_.a().value, exact_.b().value, [&](std::size_t i) {
                        const auto& place = data_.nodes[i].exact;
                        if (!place.inside()) {
                            return 0.0;
                        }
                        double sum = 0;
                        for (std::size_t k = n; k-- > 0;) {
                            sum = sum * place.u() + exact_.c(place.nearer(), k).value;
                        }
                        return sum * std::sqrt(place.u());
                    });
        }
    }

    const AlignedResult& data_;
    const scene::Scene& scene_;
    const ExactContact& exact_;
    const std::function<void(const Suspect&)>& take_;
};

} // namespace

void for_each_suspect(const AlignedResult& data, const scene::Scene& scene,
                      const ExactContact& exact, const std::function<void(const Suspect&)>& take) {
    const PrecisionScope scope(ExactContact::place_digits);
    Suspects(data, scene, exact, take).all();
}

} // namespace edgeproof::comparison
