// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/mistakes/scene_mistakes.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace edgeproof::scene {
namespace {

using Parameters = std::map<std::string, Exact>;

constexpr std::string_view modulus_advice =
    "contact_modulus is E* with 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2: both bodies deform, in "
    "plane strain";
constexpr std::string_view angle_advice = "angles are in radians; do not convert them";
constexpr std::string_view tilt_advice = "alpha is the tilt, positive clockwise";
constexpr std::string_view radius_advice = "R is the radius of the arcs";
constexpr std::string_view curvature_advice = "1/R = 1/R1 + 1/R2; a hollow has a negative radius";
constexpr std::string_view constant_advice = "C is the constant of the slope: g' = C x^m";
constexpr std::string_view flat_advice = "the flat is 2 t wide";
constexpr std::string_view force_advice = "P is the whole normal force per unit length";
constexpr std::string_view round_force_advice = "P is the whole normal force";
constexpr std::string_view approach_advice =
    "delta is the approach of distant points of the two bodies";
constexpr std::string_view width_advice =
    "a is the distance from the minimum of the profile to the right edge, the half-width of a "
    "symmetric contact";
constexpr std::string_view moment_advice = "M is the moment about the origin, per unit length";
constexpr std::string_view shear_advice = "Q is the whole shear force per unit length";
constexpr std::string_view tension_advice =
    "bulk_tension is that of the other body less that of this one";
constexpr std::string_view friction_advice =
    "friction is the coefficient of friction: |q| <= friction p";

constexpr std::string_view history_advice =
    "the traction depends on all loads before, and is asked for after the step that counts";
constexpr std::size_t most_other_steps = 12;

Expr integer(long k) { return Expr::number(Rational(k)); }

/// Collects the mistakes of one scene.
class Catalogue {
public:
    explicit Catalogue(const Scene& scene) : scene_(scene) {
        if (scene.profile) {
            parameters_ = scene.given_profile().parameters();
        } else if (scene.punch->kind == Profile::Kind::tilted_wedge) {
            parameters_ = {{"phi", scene.punch->phi}};
        } else {
            parameters_ = {{"t", scene.punch->t}, {"R", scene.punch->R}};
        }
    }

    [[nodiscard]] std::vector<SceneMistake> of_contact() && {
        moduli();
        sizes();
        loads();
        return std::move(list_);
    }
    [[nodiscard]] std::vector<SceneMistake> of_shear() && {
        const auto times = [&](std::string_view name, const char* what, std::string_view advice,
                               Exact ShearSpec::*of, const Expr& k) {
            add(name, what, advice,
                [of, k](Scene& s) { (*s.shear).*of = Exact(((*s.shear).*of).expr() * k); });
        };
        if (scene_.history) {
            history();
        } else if (scene_.shear->Q.sign() != 0) {
            times("half-shear-force", "half of Q", shear_advice, &ShearSpec::Q, half);
            times("half-shear-force", "twice Q", shear_advice, &ShearSpec::Q, two);
        }
        if (scene_.shear->bulk_tension.sign() != 0) {
            const auto tension = &ShearSpec::bulk_tension;
            times("half-tension", "half of the bulk tension", tension_advice, tension, half);
            times("half-tension", "twice the bulk tension", tension_advice, tension, two);
            add("no-tension", "no bulk tension", tension_advice,
                [](Scene& s) { s.shear->bulk_tension = Exact(); });
            add("sign-of-tension", "the bulk tension of the wrong sign relative to Q",
                tension_advice,
                [](Scene& s) { s.shear->bulk_tension = Exact(-s.shear->bulk_tension.expr()); });
        }
        if (scene_.shear->friction) {
            add("no-slip", "full stick, without friction", friction_advice, [](Scene& s) {
                s.shear->friction.reset();
                s.history.reset();
                s.steps.clear();
            });
        }
        return std::move(list_);
    }

private:
    /// The mistakes in the shear forces of steps.
    void history() {
        const auto times = [&](const char* what, const Expr& k) {
            add("half-shear-force", what, shear_advice, [k](Scene& s) {
                change_steps(s, [&](LoadStep& step) { step.Q = Exact(step.Q.expr() * k); });
            });
        };
        times("half of Q", half);
        times("twice Q", two);
        add("no-history", "P applied first, then Q, instead of the steps", history_advice,
            [](Scene& s) {
                s.history.reset();
                s.steps.clear();
            });
        // If steps are repeated, the first pass is enough: the others are like it, or nearly so.
        const std::size_t different = std::min(scene_.steps.size(), most_other_steps);
        for (std::size_t k = 1; k <= different; ++k) {
            if (k != scene_.step) {
                add("another-step", "the state after step " + std::to_string(k), history_advice,
                    [k](Scene& s) { set_step(s, k); });
            }
        }
    }

    void add(std::string_view name, std::string what, std::string_view advice,
             std::function<void(Scene&)> change) {
        list_.push_back({name, std::move(what), advice,
                         [change = std::move(change)](Scene& s) { change_given(s, change); }});
    }

    void modulus(std::string_view name, std::string what, const Expr& value) {
        add(name, std::move(what), modulus_advice,
            [value](Scene& s) { s.contact_modulus = Exact(value); });
    }
    void moduli() {
        if (!scene_.bodies) {
            const Expr E = scene_.contact_modulus.expr();
            modulus("factor-2", "twice E*", E * two);
            modulus("factor-2", "half of E*", E / two);
            modulus("factor-pi", "pi times E*", E * Expr::pi());
            modulus("factor-pi", "E* divided by pi", E / Expr::pi());
            // If the other body is rigid, E* is E/(1 - nu^2) of this one, with an unknown nu.
            for (const char* const nu : {"1/4", "0.28", "3/10", "0.32", "1/3", "0.35", "1/2"}) {
                const Expr squared = Exact::parse(std::string(nu) + "*" + nu).expr();
                modulus("plane-stress",
                        "plane stress, E instead of E/(1 - nu^2), if nu is " + std::string(nu),
                        E * (integer(1) - squared));
            }
            return;
        }
        const Expr E1 = scene_.bodies->E1.expr();
        const Expr E2 = scene_.bodies->E2.expr();
        const Expr nu1 = scene_.bodies->nu1.expr();
        const Expr nu2 = scene_.bodies->nu2.expr();
        const Expr one = integer(1);
        const bool alike = E1 == E2 && nu1 == nu2;
        const auto of_two = [&](const Expr& c1, const Expr& c2) { return one / (c1 + c2); };
        modulus("e-for-e-star", "E of body 1 instead of E*", E1);
        modulus("one-body-modulus", "E/(1 - nu^2) of body 1 instead of E*", E1 / (one - nu1 * nu1));
        modulus("shear-modulus", "2G of body 1 instead of E*", E1 / (one + nu1));
        modulus("shear-modulus", "G of body 1 instead of E*", E1 / (two * (one + nu1)));
        if (!alike) {
            modulus("e-for-e-star", "E of body 2 instead of E*", E2);
            modulus("one-body-modulus", "E/(1 - nu^2) of body 2 instead of E*",
                    E2 / (one - nu2 * nu2));
            modulus("one-body-modulus", "the constants of body 1 for both bodies",
                    E1 / (two * (one - nu1 * nu1)));
            modulus("one-body-modulus", "the constants of body 2 for both bodies",
                    E2 / (two * (one - nu2 * nu2)));
        }
        modulus("nu-not-squared", "1 - nu instead of 1 - nu^2",
                of_two((one - nu1) / E1, (one - nu2) / E2));
        modulus("plane-stress", "plane stress, 1/E* = 1/E1 + 1/E2", of_two(one / E1, one / E2));
        modulus("sum-of-moduli", "the sum of the moduli E/(1 - nu^2) instead of E*",
                E1 / (one - nu1 * nu1) + E2 / (one - nu2 * nu2));
        modulus("sum-of-moduli", "the sum of E1 and E2 instead of E*", E1 + E2);
        modulus("sum-of-moduli", "the mean of E1 and E2 instead of E*", (E1 + E2) / two);
        modulus("shear-modulus", "2G of the bodies instead of E/(1 - nu^2)",
                of_two((one + nu1) / E1, (one + nu2) / E2));
        const Expr both = of_two((one - nu1 * nu1) / E1, (one - nu2 * nu2) / E2);
        modulus("factor-2", "half of E*", both / two);
        if (!alike) { // else it is that of one body
            modulus("factor-2", "twice E*", both * two);
        }
        const auto with_g = [&](const Expr& E, const Expr& nu) {
            return two * (one + nu) * (one - nu * nu) / E;
        };
        modulus("shear-modulus", "G of the bodies instead of E",
                of_two(with_g(E1, nu1), with_g(E2, nu2)));
    }

    /// Adds the profile with `change` applied to each parameter.
    void profile(std::string_view name, std::string what, std::string_view advice,
                 const std::function<Expr(std::string_view, const Expr&)>& change) {
        add(name, std::move(what), advice, [parameters = parameters_, change](Scene& s) {
            const auto get = [&](const char* key) {
                return Exact(change(key, parameters.at(key).expr()));
            };
            if (s.punch) {
                s.punch = s.punch->kind == Profile::Kind::tilted_wedge
                              ? contact::TiltedPunch::wedge(get("phi"))
                              : contact::TiltedPunch::flat_and_rounded(get("t"), get("R"));
                return;
            }
            switch (s.profile->kind()) {
            case Profile::Kind::power_law:
                s.profile = Profile::power_law(get("C"), parameters.at("m"));
                return;
            case Profile::Kind::flat_and_rounded:
                s.profile = Profile::flat_and_rounded(get("t"), get("R"));
                return;
            case Profile::Kind::tilted_wedge:
                s.profile = Profile::tilted_wedge(get("phi"), get("alpha"));
                return;
            case Profile::Kind::tilted_flat_and_rounded:
                s.profile = Profile::tilted_flat_and_rounded(get("alpha"), get("t"), get("R"));
                return;
            default: // other kinds of profiles have no parameters
                return;
            }
        });
    }
    void parameter(std::string_view name, const char* what, std::string_view advice,
                   std::string_view which, const Expr& times) {
        if (parameters_.contains(std::string(which))) {
            profile(name, what, advice, [which, times](std::string_view key, const Expr& value) {
                return key == which ? value * times : value;
            });
        }
    }
    void sizes() {
        const bool circle = scene_.profile &&
                            scene_.given_profile().kind() == Profile::Kind::power_law &&
                            contact::certainly_zero(parameters_.at("m").expr() - integer(1));
        if (circle) {
            parameter("radius-as-diameter", "half the radius", radius_advice, "C", two);
            parameter("radius-as-diameter", "the diameter instead of the radius", radius_advice,
                      "C", half);
        } else {
            parameter("factor-2", "twice C", constant_advice, "C", two);
            parameter("factor-2", "half of C", constant_advice, "C", half);
        }
        parameter("radius-as-diameter", "the diameter instead of the radius", radius_advice, "R",
                  two);
        parameter("radius-as-diameter", "half the radius", radius_advice, "R", half);
        parameter("flat-as-full-width", "the length of the flat instead of its half-length",
                  flat_advice, "t", two);
        parameter("flat-as-full-width", "half of the flat's half-length", flat_advice, "t", half);
        if (scene_.radii) {
            const auto curvature = [&](const char* what, const Expr& C) {
                profile("one-body-radius", what, curvature_advice,
                        [C](std::string_view, const Expr&) { return C; });
            };
            const Expr R1 = scene_.radii->R1.expr();
            const Expr R2 = scene_.radii->R2.expr();
            const Expr one = integer(1);
            curvature("R1 instead of R, 1/R = 1/R1 + 1/R2", one / R1);
            curvature("R2 instead of R, 1/R = 1/R1 + 1/R2", one / R2);
            curvature("R1 + R2 instead of R", one / (R1 + R2));
            curvature("the mean of R1 and R2 instead of R", two / (R1 + R2));
            curvature("1/R1 - 1/R2 instead of 1/R1 + 1/R2", one / R1 - one / R2);
            curvature("1/R2 - 1/R1 instead of 1/R1 + 1/R2", one / R2 - one / R1);
        }
        angles();
    }
    void angle(std::string_view name, const std::string& what,
               const std::function<Expr(const Expr&)>& change) {
        for (const std::string_view only : {"", "phi", "alpha"}) {
            const bool has_both = parameters_.contains("phi") && parameters_.contains("alpha");
            if (only.empty() ? has_both : parameters_.contains(std::string(only))) {
                profile(name, only.empty() ? what : what + " of " + std::string(only), angle_advice,
                        [only, change](std::string_view key, const Expr& value) {
                            const bool angle = key == "phi" || key == "alpha";
                            return angle && (only.empty() || key == only) ? change(value) : value;
                        });
            }
        }
    }
    void angles() {
        const Expr degree = Expr::pi() / integer(180);
        angle("tangent-of-angle", "the tangent instead of the angle",
              [](const Expr& value) { return Expr::call("tan", {value}); });
        angle("tangent-of-angle", "the sine instead of the angle",
              [](const Expr& value) { return Expr::call("sin", {value}); });
        angle("degrees", "the angle in degrees instead of radians",
              [degree](const Expr& value) { return value / degree; });
        angle("degrees", "the angle converted from degrees to radians twice",
              [degree](const Expr& value) { return value * degree; });
        if (parameters_.contains("alpha")) {
            profile("mirrored", "the tilt of the wrong sign", tilt_advice,
                    [](std::string_view key, const Expr& value) {
                        return key == "alpha" ? -value : value;
                    });
            profile("no-tilt", "no tilt", tilt_advice, [](std::string_view key, const Expr& value) {
                return key == "alpha" ? integer(0) : value;
            });
        }
    }

    void forces_of_steps() {
        std::vector<Exact> seen{scene_.load.value};
        for (std::size_t k = 1; k <= scene_.steps.size() && seen.size() <= most_other_steps; ++k) {
            const Exact P = scene_.steps[k - 1].P;
            const bool known = std::ranges::any_of(seen, [&](const Exact& other) {
                return Exact(P.expr() - other.expr()).sign() == 0;
            });
            if (known || P.sign() <= 0) {
                continue;
            }
            seen.push_back(P);
            add("another-step", "the state after step " + std::to_string(k), history_advice,
                [k, P](Scene& s) {
                    if (s.history) {
                        set_step(s, k);
                    } else {
                        s.load = Load::force(P);
                    }
                });
        }
    }

    void loads() {
        const auto load = [&](std::string_view name, const char* what, std::string_view advice,
                              const Expr& times) {
            add(name, what, advice, [times](Scene& s) {
                if (s.history) {
                    change_steps(s, [&](LoadStep& step) { step.P = Exact(step.P.expr() * times); });
                } else {
                    s.load.value = Exact(s.load.value.expr() * times);
                }
            });
        };
        const Load::Kind given = scene_.given_load().kind;
        if (given == Load::Kind::force) {
            const auto advice = scene_.round ? round_force_advice : force_advice;
            load("half-force", "half of P", advice, half);
            load("half-force", "twice P", advice, two);
            forces_of_steps();
            if (scene_.round) {
                const Expr turn = two * Expr::pi();
                load("force-per-radian", "P divided by 2 pi", advice, integer(1) / turn);
                load("force-per-radian", "2 pi P", advice, turn);
            }
        } else if (given == Load::Kind::approach) {
            load("half-approach", "half of delta", approach_advice, half);
            load("half-approach", "twice delta", approach_advice, two);
        } else {
            load("full-width-for-half", "the width of the contact instead of a", width_advice, two);
            load("full-width-for-half", "a quarter of the width instead of a", width_advice, half);
        }
        if (scene_.round && given != Load::Kind::approach) {
            list_.push_back({"plane-for-axisymmetric", "the plane contact of the same profile",
                             "the bodies are bodies of revolution", [](Scene& s) {
                                 s.profile = s.round->profile;
                                 s.load = s.round->load;
                                 s.round.reset();
                             }});
        }
        if (scene_.moment) {
            const auto moment = [&](std::string_view name, const char* what, const Expr& times) {
                add(name, what, moment_advice,
                    [times](Scene& s) { s.moment = Exact(s.moment->expr() * times); });
            };
            moment("sign-of-moment", "M with the wrong sign", integer(-1));
            moment("half-moment", "half of M", half);
            moment("half-moment", "twice M", two);
        }
    }

    const Expr two = integer(2);
    const Expr half = Expr::number(Rational(1, 2));
    const Scene& scene_;
    Parameters parameters_;
    std::vector<SceneMistake> list_;
};

} // namespace

std::vector<SceneMistake> contact_mistakes(const Scene& scene) {
    return Catalogue(scene).of_contact();
}

std::vector<SceneMistake> shear_mistakes(const Scene& scene) { return Catalogue(scene).of_shear(); }

} // namespace edgeproof::scene
