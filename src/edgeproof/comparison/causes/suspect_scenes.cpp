// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/causes/suspects.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"

#include <map>
#include <string>

namespace edgeproof::comparison {
namespace {

using formula::Expr;

Expr integer(long k) { return Expr::number(Rational(k)); }

void suspect_moduli(const SuspectMaker& make) {
    const scene::Scene& scene = make.scene();
    const auto modulus = [&](const char* name, const std::string& what, const Expr& value) {
        make.add_scene(name, what,
                       [&](scene::Scene& s) { s.contact_modulus = formula::Exact(value); });
    };
    if (!scene.bodies) {
        const Expr E = scene.contact_modulus.expr();
        modulus("factor-2", "E* is twice too large", E * integer(2));
        modulus("factor-2", "E* is half as large", E / integer(2));
        modulus("factor-pi", "E* is pi times too large", E * Expr::pi());
        modulus("factor-pi", "E* is pi times too small", E / Expr::pi());
        return;
    }
    const Expr E1 = scene.bodies->E1.expr();
    const Expr E2 = scene.bodies->E2.expr();
    const Expr nu1 = scene.bodies->nu1.expr();
    const Expr nu2 = scene.bodies->nu2.expr();
    const Expr one = integer(1);
    const bool alike = E1 == E2 && nu1 == nu2;
    const auto of_two = [&](const Expr& c1, const Expr& c2) { return one / (c1 + c2); };
    modulus("e-for-e-star", "E of body 1 instead of E*", E1);
    modulus("one-body-modulus", "E/(1 - nu^2) of body 1 instead of E*", E1 / (one - nu1 * nu1));
    modulus("shear-modulus", "2G of body 1 instead of E*", E1 / (one + nu1));
    modulus("shear-modulus", "G of body 1 instead of E*", E1 / (integer(2) * (one + nu1)));
    if (!alike) {
        modulus("e-for-e-star", "E of body 2 instead of E*", E2);
        modulus("one-body-modulus", "E/(1 - nu^2) of body 2 instead of E*", E2 / (one - nu2 * nu2));
        modulus("one-body-modulus", "the constants of body 1 for both bodies",
                E1 / (integer(2) * (one - nu1 * nu1)));
        modulus("one-body-modulus", "the constants of body 2 for both bodies",
                E2 / (integer(2) * (one - nu2 * nu2)));
    }
    modulus("nu-not-squared", "1 - nu instead of 1 - nu^2",
            of_two((one - nu1) / E1, (one - nu2) / E2));
    modulus("plane-stress", "plane stress, 1/E* = 1/E1 + 1/E2", of_two(one / E1, one / E2));
    modulus("shear-modulus", "2G of the bodies instead of E/(1 - nu^2)",
            of_two((one + nu1) / E1, (one + nu2) / E2));
}

using Parameters = std::map<std::string, formula::Exact>;

/// The parameters of the profile; for a punch that a moment tilts, those other than its tilt.
Parameters parameters_of(const scene::Scene& scene) {
    if (scene.profile) {
        return scene.profile->parameters();
    }
    const contact::TiltedPunch& punch = *scene.punch;
    return punch.kind == contact::Profile::Kind::tilted_wedge
               ? Parameters{{"phi", punch.phi}}
               : Parameters{{"t", punch.t}, {"R", punch.R}};
}

/// Adds the profile with `change` applied to each parameter.
void suspect_profile(const SuspectMaker& make, const char* name, const std::string& what,
                     const std::function<Expr(std::string_view, const Expr&)>& change) {
    const Parameters parameters = parameters_of(make.scene());
    make.add_scene(name, what, [&](scene::Scene& s) {
        const auto get = [&](const char* key) {
            return formula::Exact(change(key, parameters.at(key).expr()));
        };
        using contact::Profile;
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
        default: // there are no suspects for other kinds of profiles
            return;
        }
    });
}

void suspect_angles(const SuspectMaker& make, const Parameters& parameters) {
    const Expr degree = Expr::pi() / integer(180);
    const auto both = [&](const char* name, const std::string& what, const auto& change) {
        for (const std::string_view only : {"", "phi", "alpha"}) {
            const bool has_both = parameters.contains("phi") && parameters.contains("alpha");
            if (only.empty() ? has_both : parameters.contains(std::string(only))) {
                suspect_profile(make, name, only.empty() ? what : what + " of " + std::string(only),
                                [&](std::string_view key, const Expr& value) {
                                    const bool angle = key == "phi" || key == "alpha";
                                    return angle && (only.empty() || key == only) ? change(value)
                                                                                  : value;
                                });
            }
        }
    };
    both("tan-of-angle", "the tangent instead of the angle",
         [](const Expr& value) { return Expr::call("tan", {value}); });
    both("tan-of-angle", "the sine instead of the angle",
         [](const Expr& value) { return Expr::call("sin", {value}); });
    both("degrees", "the angle in degrees instead of radians",
         [&](const Expr& value) { return value / degree; });
    both("degrees", "the angle converted from degrees to radians twice",
         [&](const Expr& value) { return value * degree; });
    if (parameters.contains("alpha")) {
        suspect_profile(make, "mirrored", "the tilt has the wrong sign",
                        [](std::string_view key, const Expr& value) {
                            return key == "alpha" ? -value : value;
                        });
        suspect_profile(make, "no-tilt", "the tilt is left out",
                        [](std::string_view key, const Expr& value) {
                            return key == "alpha" ? integer(0) : value;
                        });
    }
}

void suspect_sizes(const SuspectMaker& make) {
    const scene::Scene& scene = make.scene();
    const Expr two = integer(2);
    const Expr half = integer(1) / two;
    const Parameters parameters = parameters_of(scene);
    const auto parameter = [&](const char* name, const std::string& what, std::string_view which,
                               const Expr& times) {
        if (parameters.contains(std::string(which))) {
            suspect_profile(make, name, what, [&](std::string_view key, const Expr& value) {
                return key == which ? value * times : value;
            });
        }
    };
    const bool circle = scene.profile &&
                        scene.profile->kind() == contact::Profile::Kind::power_law &&
                        contact::certainly_zero(parameters.at("m").expr() - integer(1));
    if (circle) {
        parameter("radius-as-diameter", "half the radius", "C", two);
        parameter("radius-as-diameter", "the diameter instead of the radius", "C", half);
    } else {
        parameter("factor-2", "C is twice too large", "C", two);
        parameter("factor-2", "C is half as large", "C", half);
    }
    parameter("radius-as-diameter", "the diameter instead of the radius", "R", two);
    parameter("radius-as-diameter", "half the radius", "R", half);
    parameter("flat-as-full-width", "the length of the flat instead of its half-length", "t", two);
    parameter("flat-as-full-width", "half of the flat's half-length", "t", half);
    if (scene.radii) {
        const auto curvature = [&](const std::string& what, const Expr& C) {
            suspect_profile(make, "one-body-radius", what,
                            [&](std::string_view, const Expr&) { return C; });
        };
        const Expr R1 = scene.radii->R1.expr();
        const Expr R2 = scene.radii->R2.expr();
        const Expr one = integer(1);
        curvature("R1 instead of R, 1/R = 1/R1 + 1/R2", one / R1);
        curvature("R2 instead of R, 1/R = 1/R1 + 1/R2", one / R2);
        curvature("R1 + R2 instead of R", one / (R1 + R2));
        curvature("the mean of R1 and R2 instead of R", two / (R1 + R2));
        curvature("1/R1 - 1/R2 instead of 1/R1 + 1/R2", one / R1 - one / R2);
        curvature("1/R2 - 1/R1 instead of 1/R1 + 1/R2", one / R2 - one / R1);
    }
    suspect_angles(make, parameters);
}

void suspect_loads(const SuspectMaker& make) {
    const scene::Scene& scene = make.scene();
    const Expr two = integer(2);
    const Expr half = integer(1) / two;
    const auto load = [&](const char* name, const std::string& what, const Expr& times) {
        make.add_scene(name, what, [&](scene::Scene& s) {
            s.load.value = formula::Exact(s.load.value.expr() * times);
        });
    };
    if (scene.load.kind == contact::Load::Kind::force) {
        load("half-force", "half of P", half);
        load("half-force", "twice P", two);
    } else {
        load("full-width-for-half", "the width of the contact instead of a", two);
        load("full-width-for-half", "a quarter of the width instead of a", half);
    }
    if (scene.moment) {
        const auto moment = [&](const char* name, const std::string& what, const Expr& times) {
            make.add_scene(name, what, [&](scene::Scene& s) {
                s.moment = formula::Exact(s.moment->expr() * times);
            });
        };
        moment("sign-of-moment", "M with the wrong sign", integer(-1));
        moment("half-moment", "half of M", half);
        moment("half-moment", "twice M", two);
    }
}

} // namespace

void suspect_scenes(const SuspectMaker& make) {
    suspect_moduli(make);
    suspect_sizes(make);
    suspect_loads(make);
}

} // namespace edgeproof::comparison
