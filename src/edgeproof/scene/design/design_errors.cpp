// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/algebra/form.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/design/design_file.hpp"
#include "edgeproof/scene/input/readers.hpp"

#include <algorithm>
#include <set>

namespace edgeproof::scene {
namespace {

using contact::ParametricSlope;

/// The numbers of a design scene as formulas in its parameter.
class DesignFormulas {
public:
    DesignFormulas(const io::TomlSection& top, const std::string& name) : top_(top), names_{name} {}

    [[nodiscard]] Expr number(const char* section, const std::string& key) const {
        const io::TomlSection s = top_.section(section);
        if (s.is_table(key)) {
            return Expr::symbol(key);
        }
        return parsed(s.written(key), names_);
    }
    [[nodiscard]] std::optional<Expr> number_or_none(const char* section, const char* key) const {
        return top_.has(section) && top_.section(section).has(key)
                   ? std::optional(number(section, key))
                   : std::nullopt;
    }
    [[nodiscard]] std::vector<Expr> list(const char* key, bool in_x) const {
        std::vector<Expr> all;
        const io::TomlSection profile = top_.section("profile");
        if (profile.has(key)) {
            std::set<std::string> names = names_;
            if (in_x) {
                names.insert("x");
            }
            for (const std::string& text : profile.written_list(key)) {
                all.push_back(parsed(text, names));
            }
        }
        return all;
    }
    [[nodiscard]] std::string kind() const { return top_.section("profile").text("kind"); }
    [[nodiscard]] bool flag(const char* key) const {
        const io::TomlSection profile = top_.section("profile");
        return profile.has(key) && profile.flag(key);
    }

private:
    [[nodiscard]] static Expr parsed(const std::string& text, const std::set<std::string>& names) {
        return formula::parse(text, formula::Symbols(names));
    }
    const io::TomlSection& top_;
    std::set<std::string> names_;
};

ParametricSlope flat_and_rounded(const DesignFormulas& of) {
    const Expr t = of.number("profile", "t");
    const Expr rate = whole(1) / of.number("profile", "R");
    const Expr rise = t / of.number("profile", "R");
    const Expr zero = whole(0);
    return {{.knots = {-t, zero, t},
             .pieces = {{rise, rate}, {zero, zero}, {zero, zero}, {-rise, rate}},
             .corners = {false, false, false},
             .jumps = {},
             .origin = 1},
            true};
}

ParametricSlope tilted_wedge(const DesignFormulas& of) {
    const Expr phi = of.number("profile", "phi");
    const Expr alpha = of.number("profile", "alpha");
    return {{.knots = {whole(0)},
             .pieces = {{-(phi + alpha), whole(0)}, {phi - alpha, whole(0)}},
             .corners = {true},
             .jumps = {}}};
}

ParametricSlope tilted_flat_and_rounded(const DesignFormulas& of) {
    const Expr alpha = of.number("profile", "alpha");
    const Expr R = of.number("profile", "R");
    const Expr two_t = whole(2) * of.number("profile", "t");
    const Expr rate = whole(1) / R;
    const Expr end = -(alpha * R);
    const Expr zero = whole(0);
    return {{.knots = {end - two_t, end, zero},
             .pieces = {{two_t / R, rate}, {-alpha, zero}, {zero, rate}, {zero, rate}},
             .corners = {false, false, false},
             .jumps = {},
             .origin = 2}};
}

/// True if exact algebra shows that a formula in the parameter is zero for all its values.
bool identically_zero(const Expr& e) {
    return algebra::form_of(e,
                            [](std::string_view name) { return algebra::Form::name(name, false); })
        .is_zero();
}

/// Returns the number of knots left of the origin for one value of the parameter.
std::size_t knots_before_origin(const std::vector<Expr>& knots, const std::string& parameter,
                                const Rational& value) {
    return static_cast<std::size_t>(std::ranges::count_if(knots, [&](const Expr& knot) {
        return Exact(substitute(knot, parameter, Expr::number(value))).sign() < 0;
    }));
}

std::optional<ParametricSlope> piecewise(const DesignFormulas& of, const DesignScene& design,
                                         std::string& why_not) {
    std::vector<Expr> knots = of.list("knots", false);
    std::vector<ParametricSlope::Piece> pieces;
    for (const Expr& slope : of.list("slopes", true)) {
        const auto linear = contact::as_linear(slope, "x");
        if (!linear) {
            why_not = "a piece of the slope is curved: enclosures over a range of the parameter "
                      "are known for piecewise linear slopes, power laws and full stick";
            return {};
        }
        pieces.push_back({linear->at_origin, linear->rate});
    }
    ParametricSlope s;
    s.symmetric = of.flag("symmetric");
    if (s.symmetric) {
        std::vector<Expr> all;
        std::vector<ParametricSlope::Piece> both;
        for (std::size_t i = knots.size(); i-- > 0;) {
            all.push_back(-knots[i]);
        }
        s.origin = all.size();
        all.push_back(whole(0));
        all.insert(all.end(), knots.begin(), knots.end());
        for (std::size_t i = pieces.size(); i-- > 0;) {
            both.push_back({-pieces[i].at_origin, pieces[i].rate});
        }
        both.insert(both.end(), pieces.begin(), pieces.end());
        s.knots = std::move(all);
        s.pieces = std::move(both);
    } else {
        s.origin = knots_before_origin(knots, design.parameter, design.range.from);
        if (s.origin != knots_before_origin(knots, design.parameter, design.range.to)) {
            why_not = "a knot passes the origin within the range";
            return {};
        }
        const auto at = static_cast<std::ptrdiff_t>(s.origin);
        if (s.origin == knots.size() || !identically_zero(knots[s.origin])) {
            pieces.insert(pieces.begin() + at, pieces[s.origin]);
            knots.insert(knots.begin() + at, whole(0));
        }
        s.knots = std::move(knots);
        s.pieces = std::move(pieces);
    }
    for (std::size_t i = 0; i < s.knots.size(); ++i) {
        const auto value = [&](const ParametricSlope::Piece& p) {
            return p.at_origin + p.rate * s.knots[i];
        };
        s.corners.push_back(!identically_zero(value(s.pieces[i + 1]) - value(s.pieces[i])));
    }
    return s;
}

std::optional<contact::ParametricLoad> load_of(const DesignFormulas& of, std::string& why_not) {
    contact::ParametricLoad load;
    load.a = of.number_or_none("load", "a");
    load.P = of.number_or_none("load", "P");
    const auto modulus = of.number_or_none("load", "contact_modulus");
    if (of.number_or_none("load", "M")) {
        why_not = "the tilt is solved for from a moment";
        return {};
    }
    const auto of_load = [&](const char* key) { return of.number("load", key); };
    load.contact_modulus =
        modulus ? *modulus
                : composite_modulus(of_load("E1"), of_load("nu1"), of_load("E2"), of_load("nu2"));
    return load;
}

} // namespace

std::vector<std::unique_ptr<contact::ErrorFamily>> DesignScene::errors(std::string& why_not) const {
    contact::ErrorQuestion question;
    question.terms = terms;
    question.unit = unit;
    const DesignFormulas of(*top_, parameter);
    const std::string kind = of.kind();
    std::vector<std::unique_ptr<contact::ErrorFamily>> all;
    const auto load = load_of(of, why_not);
    if (!load) {
        return all;
    }
    const bool symmetric_kind = kind == "power-law" || kind == "flat-and-rounded" ||
                                (kind == "piecewise" && of.flag("symmetric"));
    std::optional<Expr> length;
    if (symmetric_kind && load->a) {
        length = whole(2) * *load->a;
    }
    std::optional<ParametricSlope> slope;
    if (!shear && kind != "power-law") {
        slope = kind == "flat-and-rounded"          ? std::optional(flat_and_rounded(of))
                : kind == "tilted-wedge"            ? std::optional(tilted_wedge(of))
                : kind == "tilted-flat-and-rounded" ? std::optional(tilted_flat_and_rounded(of))
                                                    : piecewise(of, *this, why_not);
        if (!slope) {
            return all;
        }
    }
    if (shear && top_->section("shear").has("path") &&
        top_->section("shear").text("path") == "together") {
        why_not =
            "P and Q grow together: q = (Q/P) p, whose relative error is that of the pressure";
        return all;
    }
    for (const Edge edge : edges) {
        question.edge = edge;
        if (shear) {
            if (!length) {
                why_not = "a + b is no formula in the parameter: give a symmetric profile and a";
                return {};
            }
            all.push_back(contact::full_stick_errors(
                of.number_or_none("shear", "Q").value_or(whole(0)),
                of.number_or_none("shear", "bulk_tension").value_or(whole(0)), *length, question));
        } else if (kind == "power-law") {
            if (unit == contact::ReachUnit::distance && !load->a) {
                why_not = "the half-width of a power law under a given load is not enclosed over a "
                          "range of the parameter: give a, or unit = \"fraction\"";
                return {};
            }
            all.push_back(contact::power_law_errors(of.number("profile", "m"), load->a, question));
        } else {
            all.push_back(contact::linear_slope_errors(*slope, *load, question));
        }
    }
    return all;
}

} // namespace edgeproof::scene
