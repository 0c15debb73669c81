// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/stated_contact.hpp"

#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/theory/theory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace edgeproof::certificate {
namespace {

/// The same fields as `part` in Symmetric.v.
struct Part {
    Exact from;
    Exact corner;
    Exact curvature;
};

/// Writes a number that is zero as 0.
Exact simplified(Exact number) { return number.sign() == 0 ? Exact() : std::move(number); }

/// Returns the parts of a symmetric profile within the contact.
std::vector<Part> parts_of(const contact::Profile& profile, double a) {
    const auto& parameters = profile.parameters();
    const Exact zero;
    if (profile.kind() == contact::Profile::Kind::flat_and_rounded) {
        return {{parameters.at("t"), zero, Exact(Expr::number(1) / parameters.at("R").expr())}};
    }
    std::vector<Part> parts;
    Expr value = Expr::number(0);
    Expr rate = Expr::number(0);
    for (std::size_t knot = profile.origin(); knot < profile.knots().size(); ++knot) {
        const Exact& from = profile.knots()[knot];
        const contact::SlopePiece& piece = profile.pieces()[knot + 1];
        if (!piece.linear) {
            throw NotStated("curved profiles are not stated");
        }
        if (from.to<double>() >= a) {
            break;
        }
        const auto [at_origin, new_rate] = *piece.linear;
        const bool first = knot == profile.origin(); // nothing to subtract
        const Exact corner = simplified(Exact(
            first ? at_origin : at_origin + new_rate * from.expr() - (value + rate * from.expr())));
        const Exact curvature = simplified(Exact(first ? new_rate : new_rate - rate));
        if (corner.sign() != 0 || curvature.sign() != 0) {
            parts.push_back({from, corner, curvature});
        }
        value = at_origin;
        rate = new_rate;
    }
    return parts;
}

StatedContact symmetric_contact(const contact::Profile& profile, const Exact& a) {
    StatedContact c;
    // Scaling.v comes before Symmetric.v, because both have a lemma pressure_scaled.
    c.imports = {"Contact", "Coefficients", "Edges",  "ClosedForm",
                 "Scaling", "Symmetric",    "Unique", "Tactics"};
    std::string list = "nil";
    StatedEdge& edge = c.right;
    edge.edge = "a";
    edge.distance = a.to<double>();
    double logarithms = 0;
    double rest = 0;
    bool convex = true; // part by part
    for (const Part& part : parts_of(profile, edge.distance)) {
        convex = convex && part.corner.sign() >= 0 && part.curvature.sign() >= 0;
        const auto t = part.from.to<double>();
        const auto d = part.corner.to<double>();
        const auto k = part.curvature.to<double>();
        list =
            fmt::format("cons (Part {} {} {}) {}", in_coq(part.from), in_coq(part.corner),
                        in_coq(part.curvature), list == "nil" ? list : fmt::format("({})", list));
        edge.innermost = std::max(edge.innermost, t);
        const double w2 = edge.distance * edge.distance - t * t;
        edge.steepness = std::max(edge.steepness, 2 * edge.distance / w2);
        logarithms += (std::abs(d - k * t) + std::abs(k * t)) / std::sqrt(w2);
        rest += d / std::sqrt(w2) + k * std::acos(t / edge.distance);
    }
    edge.cancelling = std::max(1.0, logarithms / rest);
    c.constants = {{"punch", list, "list part"}};
    edge.slope = "(slope punch)";
    if (convex) {
        edge.rises_at = "(first punch)";
        edge.rises = "apply punch_rises; convex constants";
        edge.inside = "before constants";
    }
    c.load = {{"P0"}, "is_load Es (slope punch) a a P0", "apply load_total; sides constants"};
    c.left = edge;
    c.left.slope = "(mirrored (slope punch))";
    c.left.mirrored = true;
    if (convex) {
        c.left.rises = "apply mirrored_punch_rises; convex constants";
    }
    const std::string beyond = coq_decimal((edge.innermost + edge.distance) / 2, 15, false).text;
    const std::string series =
        fmt::format("apply right_edge with (1 := smooth_contact Es punch ({}) a ltac:(sides "
                    "constants) ltac:(sides constants))",
                    beyond);
    c.right.series = {{"r0", "r1", "r2"},
                      (convex ? "is_the_right_series" : "right_edge_series") +
                          std::string(" Es (slope punch) a r0 r1 r2"),
                      c.right.unique("the_right_series", series)};
    c.left.series = {
        {"r0", "r1", "r2"},
        (convex ? "is_the_left_series" : "left_edge_series") +
            std::string(" Es (slope punch) a r0 r1 r2"),
        c.left.unique(
            "the_left_series",
            fmt::format("apply (left_edge_series_of Es punch ({})); [sides constants | {}]", beyond,
                        series))};
    return c;
}

StatedContact tilted_wedge(const contact::Profile& profile, const Exact& a, const Exact* given) {
    StatedContact c;
    c.imports = {"Contact",     "Coefficients", "Edges",   "ClosedForm",
                 "TiltedWedge", "Unique",       "Scaling", "Tactics"};
    const Exact& phi = profile.parameters().at("phi");
    const Exact& alpha = profile.parameters().at("alpha");
    c.constants = {{"phi", in_coq(phi)}, {"alpha", in_coq(alpha)}, {"gam", "ratio_of phi alpha"}};
    std::string range;
    std::string is_tilted = "apply tilt_of_ratio. sides constants.";
    if (given != nullptr) {
        if (!given->is_rational()) {
            throw NotStated("of wedges with a given b/a, those with a rational one are stated");
        }
        const Rational g = given->rational();
        c.constants.back().value = in_coq(*given);
        range = "rewrite <- (proj2 tilted); ";
        is_tilted = fmt::format(
            "split; [sides constants |]. assert (Hpi := PI_RGT_0). unfold tilt. constants.\n"
            "  replace ((1 - {0}) / (1 + {0})) with {1} by field. field. lra.",
            coq_number(g), coq_number(Rational((1 - g) / (1 + g))));
    }
    c.lemma = fmt::format("(* The tilt has the left edge at gam a. *)\n"
                          "Lemma tilted : 0 < gam /\\ tilt phi gam = alpha.\n"
                          "Proof. {} Qed.\n\n",
                          is_tilted);
    const double sine = std::sin(std::numbers::pi / 2 * alpha.to<double>() / phi.to<double>());
    const double gam = (1 - sine) / (1 + sine);
    const std::string tilt = "rewrite <- (proj2 tilted); ";
    c.right.wedge = c.left.wedge = true;
    c.left.mirrored = true;
    c.right.slope = "(slope phi alpha)";
    c.left.slope = "(mirrored (slope phi alpha))";
    c.right.edge = "a";
    c.left.edge = "(gam * a)";
    c.right.distance = a.to<double>();
    c.left.distance = gam * c.right.distance;
    c.right.steepness = gam / ((1 + gam) * c.right.distance);
    c.left.steepness = (1 / gam) / ((1 + 1 / gam) * c.left.distance);
    c.right.rises_at = c.left.rises_at = "0";
    const std::string in_range = given == nullptr ? "" : ", tilt_range";
    c.right.rises = fmt::format("{}apply wedge_rises{}; sides constants", range, in_range);
    c.left.rises = fmt::format("{}apply mirrored_wedge_rises{}; sides constants", range, in_range);
    c.right.inside = c.left.inside = "sides constants";
    c.right.series = {{"r0", "r1", "r2"},
                      "is_the_right_series Es (slope phi alpha) a r0 r1 r2",
                      c.right.unique("the_right_series",
                                     tilt + "eapply right_edge, smooth_contact; sides constants")};
    c.left.series = {
        {"r0", "r1", "r2"},
        "is_the_left_series Es (slope phi alpha) (gam * a) r0 r1 r2",
        c.left.unique("the_left_series",
                      tilt + "refine (left_edge_of_a _ _ a _ _ _ _ (fun s => gam * s) _ _ _ _ _ "
                             "_); [apply smooth_contact | apply left_of_a]; sides constants")};
    c.load = {{"P0"},
              "is_load Es (slope phi alpha) a (gam * a) P0",
              tilt + "apply wedge_load; sides constants"};
    return c;
}

std::string power_of_ten(std::string digits, long exponent) {
    while (digits.size() > 1 && digits.ends_with('0') && exponent < 0) {
        digits.pop_back();
        ++exponent;
    }
    return exponent == 0  ? digits
           : exponent < 0 ? fmt::format("{} / 10 ^ {}", digits, -exponent)
                          : fmt::format("{} * 10 ^ {}", digits, exponent);
}

} // namespace

std::string in_coq(const Exact& number) {
    const std::string text = coq_text(number.expr(), {});
    const bool atom = text.find(' ') == std::string::npos ||
                      (text.front() == '(' && text.find('(', 1) == std::string::npos);
    return atom ? text : "(" + text + ")";
}

CoqDecimal coq_decimal(const std::string& number) {
    const bool negative = number.starts_with('-');
    const std::size_t e = number.find_first_of("eE");
    const std::string mantissa = number.substr(negative ? 1 : 0, e - (negative ? 1 : 0));
    long exponent = e == std::string::npos ? 0 : std::stol(number.substr(e + 1));
    std::string digits;
    bool behind_point = false;
    for (const char c : mantissa) {
        if (c == '.') {
            behind_point = true;
            continue;
        }
        if (c < '0' || c > '9') {
            throw NotStated(fmt::format("the value {} is not a decimal number", number));
        }
        digits += c;
        exponent -= behind_point ? 1 : 0;
    }
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
    const std::string size = power_of_ten(digits, exponent);
    return {negative ? "- (" + size + ")" : size, std::stod(number), exponent};
}

CoqDecimal coq_decimal(double number, int digits, bool upwards) {
    const long exponent = static_cast<long>(std::floor(std::log10(number))) - digits + 1;
    const double scaled = number / std::pow(10.0, static_cast<double>(exponent));
    const double count = upwards ? std::ceil(scaled) : std::floor(scaled);
    return {power_of_ten(fmt::format("{:.0f}", count), exponent),
            count * std::pow(10.0, static_cast<double>(exponent)), exponent};
}

std::string StatedEdge::pressure_at(const std::string& u, const std::string& p) const {
    return fmt::format("{} Es {} {} ({} - {}) {}",
                       rises.empty() ? "is_pressure" : "is_the_pressure", slope, edge, edge, u, p);
}

std::string StatedEdge::unique(const std::string& lemma, const std::string& proof) const {
    return rises.empty() ? proof
                         : fmt::format("apply ({} _ _ {}); [{} | {} | {}]", lemma, rises_at, rises,
                                       inside, proof);
}

StatedEdge::Proofs StatedEdge::at(double u, const std::string& what) const {
    const double place = distance - u;
    if (place <= innermost || place - innermost < 1e-9 * distance) {
        throw NotStated(fmt::format("{} is nearer to the origin than a knot of the profile, or at "
                                    "it: pressures are stated beyond all knots",
                                    what));
    }
    if (wedge) {
        return {unique("the_pressure", fmt::format("rewrite <- (proj2 tilted); apply "
                                                   "pressure_{}_of_apex; sides constants",
                                                   mirrored ? "left" : "right")),
                "rewrite proportional_near; [| sides constants | sides constants]"};
    }
    const std::string beyond = coq_decimal((innermost + place) / 2, 15, false).text;
    const std::string pressure =
        fmt::format("apply (pressure Es punch ({})); sides constants", beyond);
    return {unique("the_pressure",
                   mirrored
                       ? fmt::format("apply (left_pressure Es punch ({})); [sides constants | {}]",
                                     beyond, pressure)
                       : pressure),
            fmt::format("rewrite (pressure_scaled Es a u ({})); [| sides constants | sides "
                        "constants | lra]",
                        beyond)};
}

std::string StatedContact::definitions() const { return certificate::constants(constants) + lemma; }

std::string StatedContact::head(const std::string& comment) const {
    return comment + imports_text(imports) + definitions();
}

StatedContact stated_contact(const contact::Profile& profile, const Exact& a,
                             const Exact& contact_modulus, const Exact* gam) {
    StatedContact c = [&] {
        if (profile.kind() == contact::Profile::Kind::tilted_wedge) {
            return tilted_wedge(profile, a, gam);
        }
        if (profile.symmetric() && profile.piecewise_linear()) {
            return symmetric_contact(profile, a);
        }
        throw NotStated(fmt::format("the Coq files have no theory of the profile: {}, {}",
                                    profile.kind_name(),
                                    profile.piecewise_linear() ? "not symmetric" : "curved"));
    }();
    c.constants.insert(c.constants.begin(), {{"Es", in_coq(contact_modulus)}, {"a", in_coq(a)}});
    return c;
}

std::string sum_of_terms(std::size_t terms) {
    static const char* const sums[] = {"r0 * sqrt u", "r0 * sqrt u + r1 * (u * sqrt u)",
                                       "r0 * sqrt u + r1 * (u * sqrt u) + r2 * (u ^ 2 * sqrt u)"};
    if (terms < 1 || terms > 3) {
        throw NotStated("extents are stated for up to three terms");
    }
    return sums[terms - 1];
}

std::string extent_theorem(const std::string& name, const StatedEdge& edge,
                           const ExtentStatement& extent) {
    const auto tolerance = extent.tolerance.to<double>();
    // Up to `near`, the arguments of the logarithms are so small that two terms of their series
    // suffice.
    const double least = std::min(0.2, tolerance / (5 * edge.cancelling));
    const CoqDecimal squares = coq_decimal(least, 2, true);
    const double depth = edge.distance - edge.innermost;
    const CoqDecimal near = coq_decimal(
        std::min({least / (1.2 * edge.steepness), tolerance * depth / 50, extent.within.value / 2}),
        2, false);
    const auto [pressure, root] = edge.at(extent.beyond.value, "the extent");
    const std::string e = in_coq(extent.tolerance);
    const std::string sum = sum_of_terms(extent.terms);
    const std::string p = edge.pressure_at("u", "p0");
    return fmt::format(
        "Theorem {0} : exists r0 r1 r2,\n  {1} /\\\n"
        "  (forall u, 0 < u <= {2} -> exists p0, {3} /\\\n    Rabs (p0 - ({4})) <= {5} * p0) /\\\n"
        "  (forall u, u = {6} -> exists p0, {3} /\\\n    {5} * p0 < Rabs (p0 - ({4}))){7}.\n"
        "Proof.\n  eexists. eexists. eexists. split. {{ {8}. }}\n"
        "  split; [{14}].\n  - intros u Hu. eexists. split. {{ {9}. }}\n"
        "    destruct (Rle_lt_dec u ({10})) as [Hn | Hn].\n"
        "    + {11}.\n      near_the_edge constants u ({10}) ({12}). interval with (i_prec 90).\n"
        "    + assert (H : {10} <= u <= {2}) by lra. clear Hu Hn. plain constants. unfold atanh.\n"
        "      apply Rminus_le. first [interval with (i_bisect u, i_taylor u, i_depth 60)\n"
        "        | interval with (i_bisect u, i_taylor u, i_prec 90, i_depth 60)].\n"
        "  - intros u ->. eexists. split. {{ {9}. }}\n"
        "    plain constants. unfold atanh. apply Rminus_lt. interval with (i_prec 90).\n"
        "{13}Qed.\n\n",
        name, edge.series.statement, extent.within.text, p, sum, e, extent.beyond.text,
        extent.more.empty() ? "" : " /\\\n  " + extent.more, edge.series.proof, pressure, near.text,
        root, squares.text,
        extent.more.empty() ? ""
                            : "  - plain constants. repeat split; interval with (i_prec 90).\n",
        extent.more.empty() ? "|" : "| split");
}

} // namespace edgeproof::certificate
