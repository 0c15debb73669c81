// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/theory.hpp"

namespace edgeproof::certificate {
namespace {

using Parameters = std::vector<std::pair<std::string, std::string>>;

/// `parameters` by their names in ledgers; `fraction`: of the contact's length, from the right edge
/// to x.
SampledTheory sampled(Theory theory, const std::string& profile, const Parameters& parameters,
                      const std::string& x, const std::string& fraction) {
    SampledTheory s;
    s.theory = std::move(theory);
    s.sample.scene.family = profile;
    s.sample.scene.profile = profile;
    for (const auto& [name, value] : parameters) {
        const formula::Exact exact = formula::Exact::parse(value);
        const std::string coq_name = name == "R" ? "R0" : name; // R is Coq's type of real numbers
        s.theory.names.emplace(name, coq_name);
        s.theory.constants.emplace_back(coq_name, coq_number(exact.rational()));
        s.sample.scene.parameters.insert_or_assign(name, exact);
    }
    s.theory.names.emplace("x", "x");
    s.theory.constants.emplace_back("x", coq_number(formula::Exact::parse(x).rational()));
    s.sample.fraction = formula::Exact::parse(fraction);
    return s;
}

Theory tilted_wedge() {
    Theory theory;
    theory.imports = {"Contact", "Coefficients", "Edges", "Tactics", "TiltedWedge"};
    theory.names = {{"b", "(gam * a)"}};
    const std::string slope = "(slope phi (tilt phi gam))";
    theory.right = {{"r0", "r1", "r2"},
                    "right_edge_series Es " + slope + " a r0 r1 r2",
                    "eapply right_edge, smooth_contact; positive"};
    theory.left = {{"l0", "l1", "l2"},
                   "left_edge_series Es " + slope + " (gam * a) l0 l1 l2",
                   "refine (left_edge_of_a _ _ a _ _ _ _ (fun s => gam * s) _ _ _ _ _ _); "
                   "[apply smooth_contact | apply left_of_a]; positive"};
    theory.load = {{"P0"}, "is_load Es " + slope + " a (gam * a) P0", "apply wedge_load; positive"};
    theory.pressure = {
        {"p0"}, "is_pressure Es " + slope + " a x p0", "apply pressure_right_of_apex; positive"};
    theory.unfold = "c0, c1, c2, left_c0, left_c1, left_c2";
    return theory;
}

Theory flat_and_rounded() {
    Theory theory;
    theory.imports = {"Contact", "Coefficients", "Edges", "Tactics", "FlatAndRounded"};
    theory.names = {{"b", "a"}};
    theory.right = {{"r0", "r1", "r2"},
                    "right_edge_series Es (slope t R0) a r0 r1 r2",
                    "eapply right_edge, smooth_contact; positive"};
    theory.load = {{"P0"}, "is_load Es (slope t R0) a a P0", "apply load_value; positive"};
    theory.pressure = {
        {"p0"}, "is_pressure Es (slope t R0) a x p0", "apply pressure_beyond_the_flat; positive"};
    theory.integrals = {{"integral((Pi/2 - asin(t/s))*s/sqrt(s^2 - x^2), s, max(x, t), a)",
                         "apply rounded_integral; positive"}};
    theory.unfold = "c0, c1, c2, load_rate, load_rate_2, load_rate_3";
    return theory;
}

} // namespace

std::vector<SampledTheory> sampled_theories(std::string_view profile) {
    const auto wedge = [](const std::string& gam, const std::string& a, const std::string& x,
                          const std::string& fraction) {
        SampledTheory s = sampled(tilted_wedge(), "tilted-wedge",
                                  {{"Es", "1"}, {"phi", "1"}, {"gam", gam}, {"a", a}}, x, fraction);
        s.sample.scene.parameters.insert_or_assign(
            "alpha", formula::Exact::parse("2/pi*asin((1-" + gam + ")/(1+" + gam + "))"));
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

} // namespace edgeproof::certificate
