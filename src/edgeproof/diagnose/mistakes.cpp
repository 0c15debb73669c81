// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/diagnose/diagnose.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/formula/parse.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace edgeproof::diagnose {
namespace {

using contact::Profile;
using formula::Exact;
using formula::Expr;
using scene::Load;
using scene::LoadStep;
using scene::Scene;
using scene::ShearSpec;

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

/// What is wrong and when, and the formula of the wrong number. In it x is the right number, and
/// E1, nu1, E2, nu2, R1 and R2 are those of the scene.
struct Row {
    std::string_view when;
    std::string_view name;
    std::string what;
    std::string formula;
};
const Row named_rows[] = {
    {"bodies", "e-for-e-star", "E of body 1 instead of E*", "E1"},
    {"bodies", "one-body-modulus", "E/(1 - nu^2) of body 1 instead of E*", "E1/(1 - nu1^2)"},
    {"bodies", "shear-modulus", "2G of body 1 instead of E*", "E1/(1 + nu1)"},
    {"bodies", "shear-modulus", "G of body 1 instead of E*", "E1/(2*(1 + nu1))"},
    {"unlike", "e-for-e-star", "E of body 2 instead of E*", "E2"},
    {"unlike", "one-body-modulus", "E/(1 - nu^2) of body 2 instead of E*", "E2/(1 - nu2^2)"},
    {"unlike", "one-body-modulus", "the constants of body 1 for both bodies", "E1/(2*(1 - nu1^2))"},
    {"unlike", "one-body-modulus", "the constants of body 2 for both bodies", "E2/(2*(1 - nu2^2))"},
    {"bodies", "nu-not-squared", "1 - nu instead of 1 - nu^2", "1/((1 - nu1)/E1 + (1 - nu2)/E2)"},
    {"bodies", "plane-stress", "plane stress, 1/E* = 1/E1 + 1/E2", "1/(1/E1 + 1/E2)"},
    {"bodies", "sum-of-moduli", "the sum of the moduli E/(1 - nu^2) instead of E*",
     "E1/(1 - nu1^2) + E2/(1 - nu2^2)"},
    {"bodies", "sum-of-moduli", "the sum of E1 and E2 instead of E*", "E1 + E2"},
    {"bodies", "sum-of-moduli", "the mean of E1 and E2 instead of E*", "(E1 + E2)/2"},
    {"bodies", "shear-modulus", "2G of the bodies instead of E/(1 - nu^2)",
     "1/((1 + nu1)/E1 + (1 + nu2)/E2)"},
    {"bodies", "factor-2", "half of E*", "x/2"},
    {"unlike", "factor-2", "twice E*", "2*x"},
    {"bodies", "shear-modulus", "G of the bodies instead of E",
     "1/(2*(1 + nu1)*(1 - nu1^2)/E1 + 2*(1 + nu2)*(1 - nu2^2)/E2)"},
    {"modulus", "factor-2", "twice E*", "2*x"},
    {"modulus", "factor-2", "half of E*", "x/2"},
    {"modulus", "factor-pi", "pi times E*", "Pi*x"},
    {"modulus", "factor-pi", "E* divided by pi", "x/Pi"},
    {"circle", "radius-as-diameter", "half the radius", "2*x"},
    {"circle", "radius-as-diameter", "the diameter instead of the radius", "x/2"},
    {"C", "factor-2", "twice C", "2*x"},
    {"C", "factor-2", "half of C", "x/2"},
    {"R", "radius-as-diameter", "the diameter instead of the radius", "2*x"},
    {"R", "radius-as-diameter", "half the radius", "x/2"},
    {"t", "flat-as-full-width", "the length of the flat instead of its half-length", "2*x"},
    {"t", "flat-as-full-width", "half of the flat's half-length", "x/2"},
    {"radii", "one-body-radius", "R1 instead of R, 1/R = 1/R1 + 1/R2", "1/R1"},
    {"radii", "one-body-radius", "R2 instead of R, 1/R = 1/R1 + 1/R2", "1/R2"},
    {"radii", "one-body-radius", "R1 + R2 instead of R", "1/(R1 + R2)"},
    {"radii", "one-body-radius", "the mean of R1 and R2 instead of R", "2/(R1 + R2)"},
    {"radii", "one-body-radius", "1/R1 - 1/R2 instead of 1/R1 + 1/R2", "1/R1 - 1/R2"},
    {"radii", "one-body-radius", "1/R2 - 1/R1 instead of 1/R1 + 1/R2", "1/R2 - 1/R1"},
    {"tangent", "tangent-of-angle", "the tangent instead of the angle", "tan(x)"},
    {"sine", "tangent-of-angle", "the sine instead of the angle", "sin(x)"},
    {"degrees", "degrees", "the angle in degrees instead of radians", "x*180/Pi"},
    {"radians", "degrees", "the angle converted from degrees to radians twice", "x*Pi/180"},
    {"alpha", "mirrored", "the tilt of the wrong sign", "-x"},
    {"alpha", "no-tilt", "no tilt", "0"},
    {"P", "half-force", "half of P", "x/2"},
    {"P", "half-force", "twice P", "2*x"},
    {"radian", "force-per-radian", "P divided by 2 pi", "x/(2*Pi)"},
    {"radian", "force-per-radian", "2 pi P", "2*Pi*x"},
    {"delta", "half-approach", "half of delta", "x/2"},
    {"delta", "half-approach", "twice delta", "2*x"},
    {"a", "full-width-for-half", "the width of the contact instead of a", "2*x"},
    {"a", "full-width-for-half", "a quarter of the width instead of a", "x/2"},
    {"M", "sign-of-moment", "M with the wrong sign", "-x"},
    {"M", "half-moment", "half of M", "x/2"},
    {"M", "half-moment", "twice M", "2*x"},
    {"Q", "half-shear-force", "half of Q", "x/2"},
    {"Q", "half-shear-force", "twice Q", "2*x"},
    {"bulk_tension", "half-tension", "half of the bulk tension", "x/2"},
    {"bulk_tension", "half-tension", "twice the bulk tension", "2*x"},
    {"bulk_tension", "no-tension", "no bulk tension", "0"},
    {"bulk_tension", "sign-of-tension", "the bulk tension of the wrong sign relative to Q", "-x"},
};

/// The rows, and those of a modulus under plane stress for usual values of nu.
std::vector<Row> rows() {
    std::vector<Row> all(std::begin(named_rows), std::end(named_rows));
    for (const std::string nu : {"1/4", "0.28", "3/10", "0.32", "1/3", "0.35", "1/2"}) {
        all.push_back({"modulus", "plane-stress",
                       "plane stress, E instead of E/(1 - nu^2), if nu is " + nu,
                       "x*(1 - (" + nu + ")^2)"});
    }
    return all;
}

using Wrong = std::function<Exact(const Exact&)>;
using Keys = std::set<std::string>;

Wrong wrong_number(const std::string& formula, const Scene& scene) {
    return [formula, bodies = scene.bodies, radii = scene.radii](const Exact& x) {
        std::map<std::string, Exact> numbers{{"x", x}};
        if (bodies) {
            numbers.insert({{"E1", bodies->E1},
                            {"nu1", bodies->nu1},
                            {"E2", bodies->E2},
                            {"nu2", bodies->nu2}});
        }
        if (radii) {
            numbers.insert({{"R1", radii->R1}, {"R2", radii->R2}});
        }
        formula::Symbols symbols;
        for (const auto& [name, number] : numbers) {
            symbols.add(name);
        }
        Expr value = formula::parse(formula, symbols);
        for (const auto& [name, number] : numbers) {
            value = substitute(value, name, number.expr());
        }
        return Exact(value);
    };
}

/// The parameters of the profile, or of the punch.
std::map<std::string, Exact> parameters_of(const Scene& scene) {
    if (scene.profile) {
        return scene.given_profile().parameters();
    }
    return scene.punch->kind == Profile::Kind::tilted_wedge
               ? std::map<std::string, Exact>{{"phi", scene.punch->phi}}
               : std::map<std::string, Exact>{{"t", scene.punch->t}, {"R", scene.punch->R}};
}

/// Changes the profile as the scene gives it (change_given()).
void change_profile(Scene& scene, const Keys& keys, const Wrong& wrong) {
    auto parameters = scene.profile ? scene.profile->parameters() : parameters_of(scene);
    for (auto& [key, value] : parameters) {
        value = keys.contains(key) ? wrong(value) : value;
    }
    const auto at = [&](const char* key) { return parameters.at(key); };
    if (scene.punch) {
        scene.punch = scene.punch->kind == Profile::Kind::tilted_wedge
                          ? contact::TiltedPunch::wedge(at("phi"))
                          : contact::TiltedPunch::flat_and_rounded(at("t"), at("R"));
        return;
    }
    switch (scene.profile->kind()) {
    case Profile::Kind::power_law:
        scene.profile = Profile::power_law(at("C"), at("m"));
        return;
    case Profile::Kind::flat_and_rounded:
        scene.profile = Profile::flat_and_rounded(at("t"), at("R"));
        return;
    case Profile::Kind::tilted_wedge:
        scene.profile = Profile::tilted_wedge(at("phi"), at("alpha"));
        return;
    case Profile::Kind::tilted_flat_and_rounded:
        scene.profile = Profile::tilted_flat_and_rounded(at("alpha"), at("t"), at("R"));
        return;
    default: // other kinds of profiles have no parameters
        return;
    }
}

/// Changes the load as the scene gives it (change_given()).
void change_load(Scene& scene, const Wrong& wrong) {
    if (scene.history) {
        change_steps(scene, [&](LoadStep& step) { step.P = wrong(step.P); });
    } else {
        scene.load.value = wrong(scene.load.value);
    }
}

/// Collects the mistakes of one scene.
class Catalogue {
public:
    explicit Catalogue(const Scene& scene) : scene_(scene), parameters_(parameters_of(scene)) {}

    [[nodiscard]] std::vector<Mistake> of_contact() && {
        const auto& bodies = scene_.bodies;
        const bool alike = bodies && bodies->E1.expr() == bodies->E2.expr() &&
                           bodies->nu1.expr() == bodies->nu2.expr();
        add(bodies ? alike ? Keys{"bodies"} : Keys{"bodies", "unlike"} : Keys{"modulus"},
            modulus_advice,
            [](Scene& s, const Wrong& wrong) { s.contact_modulus = wrong(s.contact_modulus); });
        sizes();
        loads();
        return std::move(list_);
    }
    [[nodiscard]] std::vector<Mistake> of_shear() && {
        const ShearSpec& shear = *scene_.shear;
        if (scene_.history || shear.Q.sign() != 0) {
            add({"Q"}, shear_advice, [](Scene& s, const Wrong& wrong) {
                if (s.history) {
                    change_steps(s, [&](LoadStep& step) { step.Q = wrong(step.Q); });
                } else {
                    s.shear->Q = wrong(s.shear->Q);
                }
            });
        }
        if (scene_.history) {
            add("no-history", "P applied first, then Q, instead of the steps", history_advice,
                [](Scene& s) {
                    s.history.reset();
                    s.steps.clear();
                });
            // If steps are repeated, the first pass is enough: the others are like it, or nearly.
            for (std::size_t k = 1; k <= std::min(scene_.steps.size(), most_other_steps); ++k) {
                if (k != scene_.step) {
                    add_step(k, [k](Scene& s) { set_step(s, k); });
                }
            }
        }
        if (shear.bulk_tension.sign() != 0) {
            add({"bulk_tension"}, tension_advice, [](Scene& s, const Wrong& wrong) {
                s.shear->bulk_tension = wrong(s.shear->bulk_tension);
            });
        }
        if (shear.friction) {
            add("no-slip", "full stick, without friction", friction_advice, [](Scene& s) {
                s.shear->friction.reset();
                s.history.reset();
                s.steps.clear();
            });
        }
        return std::move(list_);
    }

private:
    void add(std::string_view name, std::string what, std::string_view advice,
             std::function<void(Scene&)> change) {
        list_.push_back({name, std::move(what), advice,
                         [change = std::move(change)](Scene& s) { change_given(s, change); }});
    }
    void add_step(std::size_t k, const std::function<void(Scene&)>& change) {
        add("another-step", "the state after step " + std::to_string(k), history_advice, change);
    }
    /// Adds the rows of the table; `set` puts the wrong number into a scene.
    void add(const Keys& when, std::string_view advice,
             const std::function<void(Scene&, const Wrong&)>& set, const std::string& of = "") {
        static const std::vector<Row> table = rows();
        for (const Row& row : table) {
            if (when.contains(std::string(row.when))) {
                add(row.name, row.what + of, advice,
                    [set, wrong = wrong_number(row.formula, scene_)](Scene& s) { set(s, wrong); });
            }
        }
    }
    /// Adds the rows for parameters of the profile, if it has them.
    void add_profile(const std::string& when, std::string_view advice, const Keys& keys,
                     const std::string& of = "") {
        if (std::ranges::all_of(keys, [&](const auto& key) { return parameters_.contains(key); })) {
            add(
                {when}, advice,
                [keys](Scene& s, const Wrong& wrong) { change_profile(s, keys, wrong); }, of);
        }
    }

    void sizes() {
        const bool circle =
            scene_.profile && scene_.given_profile().kind() == Profile::Kind::power_law &&
            contact::certainly_zero(parameters_.at("m").expr() - Expr::number(Rational(1)));
        add_profile(circle ? "circle" : "C", circle ? radius_advice : constant_advice, {"C"});
        add_profile("R", radius_advice, {"R"});
        add_profile("t", flat_advice, {"t"});
        if (scene_.radii) {
            add_profile("radii", curvature_advice, {"C"});
        }
        for (const char* const when : {"tangent", "sine", "degrees", "radians"}) {
            add_profile(when, angle_advice, {"phi", "alpha"});
            add_profile(when, angle_advice, {"phi"}, " of phi");
            add_profile(when, angle_advice, {"alpha"}, " of alpha");
        }
        add_profile("alpha", tilt_advice, {"alpha"});
    }

    void forces_of_steps() {
        std::vector<Exact> seen{scene_.load.value};
        for (std::size_t k = 1; k <= scene_.steps.size() && seen.size() <= most_other_steps; ++k) {
            const Exact P = scene_.steps[k - 1].P;
            const bool known = std::ranges::any_of(seen, [&](const Exact& other) {
                return Exact(P.expr() - other.expr()).sign() == 0;
            });
            if (!known && P.sign() > 0) {
                seen.push_back(P);
                add_step(k, [k, P](Scene& s) {
                    if (s.history) {
                        set_step(s, k);
                    } else {
                        s.load = Load::force(P);
                    }
                });
            }
        }
    }
    void loads() {
        const Load::Kind given = scene_.given_load().kind;
        if (given == Load::Kind::force) {
            const auto advice = scene_.round ? round_force_advice : force_advice;
            add({"P"}, advice, change_load);
            forces_of_steps();
            if (scene_.round) {
                add({"radian"}, advice, change_load);
            }
        } else if (given == Load::Kind::approach) {
            add({"delta"}, approach_advice, change_load);
        } else {
            add({"a"}, width_advice, change_load);
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
            add({"M"}, moment_advice,
                [](Scene& s, const Wrong& wrong) { s.moment = wrong(*s.moment); });
        }
    }

    const Scene& scene_;
    std::map<std::string, Exact> parameters_;
    std::vector<Mistake> list_;
};

} // namespace

void scale_load(Scene& scene, const Rational& factor) {
    const Wrong scaled = [&](const Exact& x) { return Exact(x.expr() * Expr::number(factor)); };
    change_given(scene, [&](Scene& s) { change_load(s, scaled); });
    if (scene.moment) {
        scene.moment = scaled(*scene.moment);
    }
}

std::vector<Mistake> contact_mistakes(const Scene& scene) { return Catalogue(scene).of_contact(); }

std::vector<Mistake> shear_mistakes(const Scene& scene) { return Catalogue(scene).of_shear(); }

} // namespace edgeproof::diagnose
