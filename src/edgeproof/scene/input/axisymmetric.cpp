// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/readers.hpp"

namespace edgeproof::scene {
namespace {

using formula::Expr;

/// Gamma((m + 1)/2)/Gamma(m/2 + 1); for whole m up to 100 without the gamma function, from
/// sqrt(pi) and 2/sqrt(pi) by Gamma(x + 1) = x Gamma(x) (DLMF 5.5.1).
Expr gamma_ratio(const Expr& m) {
    const Rational* q = m.rational();
    if (q == nullptr || denominator(*q) != 1 || *q > 100) {
        return Expr::call("gamma", {(m + whole(1)) / whole(2)}) /
               Expr::call("gamma", {m / whole(2) + whole(1)});
    }
    const long n = q->convert_to<long>();
    const Expr root = Expr::call("sqrt", {Expr::pi()});
    Expr ratio = n % 2 == 0 ? root : whole(2) / root;
    for (long k = n % 2 + 2; k <= n; k += 2) {
        ratio = ratio * whole(k - 1) / whole(k);
    }
    return ratio;
}

/// P/a^(m + 2) of a power law.
Expr force_factor(const Scene& scene) {
    const auto& [kappa, m] = *scene.round->law;
    return whole(2) * scene.contact_modulus.expr() * (m + whole(1)) * kappa / (m + whole(2));
}

} // namespace

bool is_axisymmetric(const io::TomlSection& profile) {
    if (!profile.has("geometry")) {
        return false;
    }
    const std::string geometry = profile.text("geometry");
    if (geometry != "plane" && geometry != "axisymmetric") {
        profile.reject("geometry", "unknown geometry '" + geometry + "'",
                       "write plane or axisymmetric");
    }
    return geometry == "axisymmetric";
}

// docs/axisymmetric.md, "Power laws": with h(s) = s integral_0^s g'(r)/sqrt(s^2 - r^2) dr = kappa
// s^(m+1), the pressure is that of a plane contact whose P'(s) is E* h'(s).
void make_axisymmetric(const io::TomlSection& profile, const io::TomlSection& load, Scene& scene) {
    if (!scene.profile || !scene.profile->symmetric() ||
        (scene.profile->kind() != contact::Profile::Kind::power_law &&
         !scene.profile->piecewise_linear())) {
        profile.reject("geometry",
                       "only power laws and symmetric, piecewise linear slopes are computed as "
                       "axisymmetric contacts",
                       "write kind = \"power-law\" (sphere: m = 1, C = 1/R; cone: m = 0), "
                       "flat-and-rounded, or piecewise with symmetric = true and linear slopes");
    }
    const bool power_law = scene.profile->kind() == contact::Profile::Kind::power_law;
    const bool by_force = load.has("P") || !scene.steps.empty();
    const formula::Exact given = scene.load.value;
    scene.round = Axisymmetric{{}, {}, load.has("delta") ? "from delta" : "given"};
    scene.round->profile = scene.profile;
    scene.round->load = (load.has("delta") ? "delta = " : "a = ") + given.text();
    if (power_law) {
        const Expr m = scene.profile->parameters().at("m").expr();
        const Expr C = scene.profile->parameters().at("C").expr();
        const Expr ratio = gamma_ratio(m);
        scene.round->law =
            Axisymmetric::Law{C * Expr::call("sqrt", {Expr::pi()}) * ratio / whole(2), m};
        scene.profile = contact::Profile::power_law(
            formula::Exact(C * (m + whole(1)) * ratio * ratio / whole(2)), formula::Exact(m));
    } else {
        scene.profile = scene.profile->revolved();
    }
    if (by_force) {
        set_total_force(scene, given);
        return;
    }
    if (load.has("delta")) {
        scene.round->approach = given;
        scene.load = contact::Load::approach(given);
    }
    if (power_law) {
        const auto& [kappa, m] = *scene.round->law;
        const Expr a =
            load.has("delta") ? pow(given.expr() / kappa, whole(1) / (m + whole(1))) : given.expr();
        scene.round->force = formula::Exact(force_factor(scene) * pow(a, m + whole(2)));
        if (!scene.round->approach) {
            scene.round->approach = formula::Exact(kappa * pow(a, m + whole(1)));
        }
        scene.load = contact::Load::right_edge(formula::Exact(a));
    }
}

void set_total_force(Scene& scene, const formula::Exact& P) {
    scene.round->size_from = "from P";
    scene.round->load = "P = " + P.text();
    scene.round->force = P;
    scene.load = contact::Load::force(P);
    if (scene.round->law) {
        const auto& [kappa, m] = *scene.round->law;
        const Expr a = pow(P.expr() / force_factor(scene), whole(1) / (m + whole(2)));
        scene.round->approach = formula::Exact(kappa * pow(a, m + whole(1)));
        scene.load = contact::Load::right_edge(formula::Exact(a));
    }
}

} // namespace edgeproof::scene
