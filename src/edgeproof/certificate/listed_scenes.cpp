// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/listed_scenes.hpp"

#include <cmath>
#include <string>

namespace edgeproof::certificate::listed_scenes {
namespace {

double number(const audit::SceneSpec& scene, const std::string& parameter) {
    return scene.parameter(parameter).to<double>();
}
bool flat_and_rounded(const audit::SceneSpec& s) {
    return s.profile == "flat-and-rounded" && s.parameters.contains("a");
}
bool without(const audit::SceneSpec& s, const std::string& load) {
    const auto found = s.parameters.find(load);
    return found != s.parameters.end() && found->second.sign() == 0;
}
bool under(const audit::SceneSpec& s, const std::string& load) {
    return s.parameters.contains(load) && !without(s, load);
}

} // namespace

bool tilted_wedge(const audit::SceneSpec& s) {
    return s.profile == "tilted-wedge" && std::abs(number(s, "alpha")) < number(s, "phi");
}
bool tilted_to_the_left(const audit::SceneSpec& s) {
    return tilted_wedge(s) && s.parameter("alpha").sign() > 0;
}
bool beyond_the_flat(const audit::SceneSpec& s) {
    return flat_and_rounded(s) &&
           formula::Exact(s.parameter("a").expr() - s.parameter("t").expr()).sign() > 0;
}
bool within_the_flat(const audit::SceneSpec& s) {
    return flat_and_rounded(s) && !beyond_the_flat(s);
}
bool force_alone(const audit::SceneSpec& s) { return without(s, "sig0") && under(s, "Q"); }
bool tension_alone(const audit::SceneSpec& s) { return without(s, "Q") && under(s, "sig0"); }
bool tilted_punch(const audit::SceneSpec& s) {
    return s.profile == "tilted-flat-and-rounded" && s.parameter("alpha").sign() > 0 &&
           s.parameter("t").sign() > 0 && s.parameter("R").sign() > 0;
}
bool power_law(const audit::SceneSpec& s) {
    return s.profile == "power-law" && s.parameter("m").sign() >= 0 && s.parameter("C").sign() > 0;
}
bool symmetric(const audit::SceneSpec& s) {
    return s.profile == "power-law" || s.profile == "flat-and-rounded" ||
           s.profile == "piecewise-symmetric";
}
bool power_law_or_rounded(const audit::SceneSpec& s) { return power_law(s) || beyond_the_flat(s); }
bool non_symmetric(const audit::SceneSpec& s) { return tilted_wedge(s) || tilted_punch(s); }
bool wedge_or_power_law_under_force(const audit::SceneSpec& s) {
    return force_alone(s) && (tilted_wedge(s) || power_law(s));
}
bool wedge_under_force(const audit::SceneSpec& s) { return force_alone(s) && tilted_wedge(s); }
bool under_a_force(const audit::SceneSpec& s) { return under(s, "Q"); }
bool parabola_in_plane_strain(const audit::SceneSpec& s) {
    if (!power_law(s) || !s.parameters.contains("Ey") || !s.parameters.contains("nu")) {
        return false;
    }
    const formula::Expr one = formula::Expr::number(1);
    const formula::Expr nu = s.parameter("nu").expr();
    const formula::Expr rest = one - nu * nu;
    return formula::Exact(s.parameter("m").expr() - one).sign() == 0 &&
           s.parameter("Ey").sign() > 0 && formula::Exact(rest).sign() > 0 &&
           formula::Exact(s.parameter("Es").expr() * rest - s.parameter("Ey").expr()).sign() == 0;
}
bool any_contact(const audit::SceneSpec& /*s*/) { return true; }

} // namespace edgeproof::certificate::listed_scenes
