// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/theory/theory.hpp"

#include <fmt/format.h>

#include <utility>

namespace edgeproof::certificate {
namespace {

using Parameters = std::vector<std::pair<std::string, std::string>>;

/// `parameters` have their names in ledgers. `fraction` is the distance of x from the right edge,
/// divided by the length of the contact.
SampledTheory sampled(Theory theory, const std::string& profile, const Parameters& parameters,
                      const std::string& x, const std::string& fraction) {
    SampledTheory s;
    s.theory = std::move(theory);
    const std::vector<Constant> made_of_them = std::exchange(s.theory.constants, {});
    s.sample.scene.family = profile;
    s.sample.scene.profile = profile;
    for (const auto& [name, value] : parameters) {
        const Exact exact = Exact::parse(value);
        const std::string coq_name = name == "R" ? "R0" : name; // R is Coq's type of real numbers
        s.theory.names.emplace(name, coq_name);
        s.theory.constants.push_back({coq_name, coq_number(exact.rational())});
        s.sample.scene.parameters.insert_or_assign(name, exact);
    }
    s.theory.names.emplace("x", "x");
    s.theory.constants.push_back({"x", coq_number(Exact::parse(x).rational())});
    s.theory.constants.insert(s.theory.constants.end(), made_of_them.begin(), made_of_them.end());
    s.sample.fraction = Exact::parse(fraction);
    return s;
}

/// Gives parameters the same names in Coq as in ledgers.
void name_alike(Theory& theory, std::initializer_list<const char*> names) {
    for (const char* name : names) {
        theory.names.emplace(name, name);
    }
}

Theory tilted_wedge() {
    Theory theory;
    theory.imports = {"Contact", "Coefficients", "Edges", "ClosedForm",
                      "Tactics", "TiltedWedge",  "Unique"};
    theory.names = {{"b", "(gam * a)"}};
    const std::string slope = "(slope phi (tilt phi gam))";
    const std::string rises = "apply wedge_rises, tilt_range; positive";
    theory.right = {{"r0", "r1", "r2"},
                    "is_the_right_series Es " + slope + " a r0 r1 r2",
                    "apply (the_right_series _ _ 0); [" + rises +
                        " | positive | eapply right_edge, smooth_contact; positive]"};
    theory.left = {{"l0", "l1", "l2"},
                   "is_the_left_series Es " + slope + " (gam * a) l0 l1 l2",
                   "apply (the_left_series _ _ 0); [apply mirrored_wedge_rises, tilt_range; "
                   "positive | positive | refine (left_edge_of_a _ _ a _ _ _ _ (fun s => gam * s) "
                   "_ _ _ _ _ _); [apply smooth_contact | apply left_of_a]; positive]"};
    theory.left_position = {{},
                            "is_the_left_edge " + slope + " a (gam * a)",
                            "apply (the_left_edge _ 0); [" + rises +
                                " | positive | positive | apply wedge_consistent; positive]"};
    theory.load = {{"P0"},
                   "is_the_load Es " + slope + " a (gam * a) P0",
                   "apply (the_load _ _ 0); [" + rises +
                       " | positive | positive | apply wedge_consistent; positive | apply "
                       "wedge_load; positive]"};
    theory.pressure = {{"p0"},
                       "is_the_pressure Es " + slope + " a x p0",
                       "apply (the_pressure _ _ 0); [" + rises +
                           " | positive | apply pressure_right_of_apex; positive]"};
    return theory;
}

Theory flat_and_rounded() {
    Theory theory = symmetric_punch("punch", "Part t 0 (1 / R0)", "((t + x) / 2)");
    theory.imports.emplace_back("FlatAndRounded");
    theory.integrals = {{"integral((Pi/2 - asin(t/s))*s/sqrt(s^2 - x^2), s, max(x, t), a)",
                         "is_improper_integral", "apply rounded_integral; positive"}};
    return theory;
}

} // namespace

Theory symmetric_punch(const std::string& punch, const std::string& parts,
                       const std::string& beyond, const std::string& mark) {
    Theory theory;
    theory.imports = {"Contact",   "Coefficients", "Edges",  "ClosedForm",
                      "Symmetric", "Unique",       "Tactics"};
    theory.names = {{"b", "a"}};
    const std::string rises = fmt::format("(first {0})); [apply punch_rises; convex constants | "
                                          "before constants | ",
                                          punch);
    const std::string r = fmt::format("r0{0} r1{0} r2{0}", mark);
    theory.right = {{"r0" + mark, "r1" + mark, "r2" + mark},
                    fmt::format("is_the_right_series Es (slope {}) a {}", punch, r),
                    fmt::format("apply (the_right_series _ _ {}apply right_edge with (1 := "
                                "smooth_contact Es {} {} a ltac:(sides constants) ltac:(sides "
                                "constants))]",
                                rises, punch, beyond)};
    const std::string consistent = "before constants | apply consistent_total; sides constants";
    theory.left_position = {{},
                            fmt::format("is_the_left_edge (slope {}) a a", punch),
                            "apply (the_left_edge _ " + rises + consistent + "]"};
    theory.load = {{"P0" + mark},
                   fmt::format("is_the_load Es (slope {}) a a P0{}", punch, mark),
                   "apply (the_load _ _ " + rises + consistent +
                       " | apply load_total; sides constants]"};
    theory.pressure = {{"p0" + mark},
                       fmt::format("is_the_pressure Es (slope {}) a x p0{}", punch, mark),
                       fmt::format("apply (the_pressure _ _ {}apply (pressure Es {} {}); sides "
                                   "constants]",
                                   rises, punch, beyond)};
    theory.constants = {{punch, fmt::format("cons ({}) nil", parts), "list part"}};
    return theory;
}

std::vector<SampledTheory> sampled_theories(std::string_view profile) {
    const auto wedge = [](const std::string& gam, const std::string& a, const std::string& x,
                          const std::string& fraction) {
        SampledTheory s = sampled(tilted_wedge(), "tilted-wedge",
                                  {{"Es", "1"}, {"phi", "1"}, {"gam", gam}, {"a", a}}, x, fraction);
        s.sample.scene.parameters.insert_or_assign(
            "alpha", Exact::parse("2/pi*asin((1-" + gam + ")/(1+" + gam + "))"));
        return s;
    };
    const auto flat = [](const std::string& t, const std::string& a, const std::string& x,
                         const std::string& fraction) {
        return sampled(flat_and_rounded(), "flat-and-rounded",
                       {{"Es", "1"}, {"t", t}, {"R", "1"}, {"a", a}}, x, fraction);
    };
    if (profile == "tilted-wedge") {
        return {wedge("1/4", "1", "1/2", "2/5"), wedge("1/9", "9", "4", "1/2"),
                wedge("1/4", "4", "2", "2/5")};
    }
    if (profile == "flat-and-rounded") {
        return {flat("1", "2", "3/2", "1/8"), flat("3", "5", "4", "1/10")};
    }
    return {};
}

std::optional<Theory> theory_of_form(std::string_view profile) {
    if (profile == "tilted-wedge") {
        Theory theory = tilted_wedge();
        name_alike(theory, {"Es", "phi", "gam", "a"});
        theory.names.emplace("alpha", "(tilt phi gam)");
        theory.pressure = {};
        theory.all_of_form = {"Es phi gam a", "0 < phi /\\ 0 < gam /\\ 0 < a",
                              "intros form. assert (0 < gam * a) by (apply Rmult_lt_0_compat; lra)",
                              "identity_of_wedge a gam", ""};
        return theory;
    }
    if (profile == "flat-and-rounded") {
        const std::string parts = "Part t 0 (1 / R0)";
        const std::string punch = fmt::format("(cons ({}) nil)", parts);
        Theory theory = symmetric_punch(punch, parts, "((t + a) / 2)");
        theory.constants.clear();
        theory.imports.emplace_back("FlatAndRounded");
        name_alike(theory, {"Es", "t", "a"});
        theory.names.emplace("R", "R0"); // R is Coq's type of real numbers
        theory.pressure = {};
        theory.all_of_form = {"Es t R0 a", "0 < t < a /\\ 0 < R0",
                              "intros form. assert (0 < 1 / R0) by (apply Rdiv_lt_0_compat; lra)",
                              "identity_of_rounded t a", ""};
        return theory;
    }
    if (profile == "power-law") {
        Theory theory;
        theory.imports = {"Contact", "Coefficients", "Edges",   "Unique",
                          "Tactics", "Gamma",        "PowerLaw"};
        theory.names = {{"b", "a"}, {"gamma", "Gam"}};
        name_alike(theory, {"Es", "C", "m", "a", "x"});
        theory.right = {{"r0", "r1", "r2"},
                        "is_the_right_series Es (power_slope C m) a r0 r1 r2",
                        "apply (the_right_series _ _ 0); [apply power_slope_rises; lra | lra | "
                        "apply right_edge with (1 := power_smooth_contact Es C m ltac:(lra) a "
                        "ltac:(lra))]"};
        theory.load = {
            {"P0"}, "is_the_load Es (power_slope C m) a a P0", "apply power_the_load; lra"};
        theory.pressure = {
            {"p0"}, "is_the_pressure Es (power_slope C m) a x p0", "apply power_the_pressure; lra"};
        theory.integrals = {{"integral(s^m/sqrt(s^2 - x^2), s, x, a)", "is_improper_integral",
                             "apply power_integral; lra"}};
        theory.all_of_form = {"Es C m a", "0 < C /\\ 0 <= m /\\ 0 < a",
                              "intros Gam is_gamma_G form",
                              "identity_of_power_law is_gamma_G Gam m a", "0 < x < a"};
        return theory;
    }
    return std::nullopt;
}

namespace {

Theory full_stick(Edge edge, const std::string& tension) {
    Theory theory;
    theory.imports = {"Contact", "Coefficients", "Edges", "Tactics", "Shear", "Unique"};
    const bool right = edge == Edge::right;
    theory.names = {{"u", right ? "(a - x)" : "(b + x)"}, {"sig0", tension}, {"b", "b"}};
    const std::string traction = fmt::format("(full_stick Q {} a b)", tension);
    theory.right_shear = {{"s0", "s1", "s2"},
                          fmt::format("is_the_right_shear_series {} a s0 s1 s2", traction),
                          "apply the_right_shear_series, right_shear; positive"};
    theory.left_shear = {{"v0", "v1", "v2"},
                         fmt::format("is_the_left_shear_series {} b v0 v1 v2", traction),
                         "apply the_left_shear_series, left_shear; positive"};
    return theory;
}

} // namespace

Theory theory_of_shear(Edge edge, const std::string& tension) {
    Theory theory = full_stick(edge, tension);
    name_alike(theory, {"a", "Q", "x"});
    theory.names.erase("u");
    theory.integrals = {{fmt::format("integral(Q/(Pi*sqrt((a - s)*(s + b))) + {}*(2*s + b - "
                                     "a)/(8*sqrt((a - s)*(s + b))), s, -b, a)",
                                     tension),
                         "is_integral_between", "apply force_of_traction; lra"}};
    const std::string strain = "apply strain_of_traction; lra";
    theory.integrals.push_back(
        {fmt::format("pv((Q/(Pi*sqrt((a - s)*(s + b))) + {}*(2*s + b - a)/(8*sqrt((a - s)*(s + "
                     "b))))/(s - x), s, -b, a, x)",
                     tension),
         "is_principal_value", strain});
    theory.integrals.push_back({"pv(q(s)/(s - x), s, -b, a, x)", "is_principal_value", strain});
    theory.imports.emplace_back("Stick");
    theory.traction = fmt::format("full_stick Q {} a b", tension);
    theory.all_of_form = {"a b Q " + tension, "0 < a + b", "intros form", "identity_of_shear a b",
                          "- b < x < a"};
    return theory;
}

SampledTheory sheared_contact(Edge edge, const Tension& tension) {
    const bool right = edge == Edge::right;
    // A wedge with these edges, so that the enclosures have the positions of the edges.
    SampledTheory s = sampled(full_stick(edge, tension.name), "tilted-wedge",
                              {{"a", "4"}, {"Q", "1"}}, "2", right ? "2/5" : "3/5");
    s.theory.constants.push_back({"b", "1"});
    s.theory.constants.push_back({tension.name, tension.coq});
    for (const auto& [name, value] :
         Parameters{{"Es", "1"}, {"phi", "1"}, {"gam", "1/4"}, {"alpha", "2/pi*asin(3/5)"}}) {
        s.sample.scene.parameters.insert_or_assign(name, Exact::parse(value));
    }
    s.sample.scene.parameters.insert_or_assign("sig0", tension.exact);
    s.sample.edge = edge;
    return s;
}

SampledTheory power_law_contact(long m, const std::string& mark, const Rational& x) {
    Theory theory = m == 0 ? symmetric_punch("wedge", "Part 0 C 0", "(x / 2)", mark)
                           : symmetric_punch("parabola", "Part 0 0 C", "(x / 2)", mark);
    theory.names.emplace("m", std::to_string(m));
    SampledTheory s = sampled(std::move(theory), "power-law", {{"Es", "1"}, {"C", "1"}, {"a", "1"}},
                              x.str(), Rational((1 - x) / 2).str());
    s.sample.scene.parameters.insert_or_assign("m", Exact::parse(std::to_string(m)));
    return s;
}

Theory smooth_contact(bool symmetric) {
    Theory theory;
    theory.assumes_contact = true;
    theory.imports = {"Contact", "Coefficients", "Edges", "Unique", "Tactics"};
    theory.names = {{"a", "a"}, {"Es", "Es"}, {"P1", "(P1 a)"}, {"P2", "(P2 a)"}, {"P3", "(P3 a)"}};
    if (symmetric) {
        theory.names.insert({{"b", "a"}, {"b1", "1"}, {"b2", "0"}, {"b3", "0"}});
    } else {
        theory.names.insert({{"b", "(b a)"}, {"b1", "(b1 a)"}, {"b2", "(b2 a)"}, {"b3", "(b3 a)"}});
    }
    theory.right = {{"r0", "r1", "r2"},
                    "is_the_right_series Es g1 a r0 r1 r2",
                    "apply (the_right_series _ _ y); [apply convex | apply convex | exact "
                    "(right_edge _ _ _ _ _ _ _ _ _ _ contact)]"};
    if (!symmetric) {
        theory.left = {{"l0", "l1", "l2"},
                       "is_the_left_series Es g1 (b a) l0 l1 l2",
                       "apply (the_left_series _ _ z); [apply convex | apply convex | exact "
                       "(left_edge_of_a _ _ _ _ _ _ _ _ _ _ _ _ contact left)]"};
    }
    return theory;
}

} // namespace edgeproof::certificate
