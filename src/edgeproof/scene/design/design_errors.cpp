// SPDX-License-Identifier: BSD-3-Clause
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

/// The pieces of g'; of a symmetric one those for x > 0.
struct Pieces {
    std::vector<Expr> knots;
    std::vector<Expr> slopes;
    bool symmetric = false;
};

/// A kind of profile that is made of a few numbers: its pieces as formulas in them.
struct PiecesOfKind {
    std::string_view kind;
    std::vector<const char*> knots;
    std::vector<const char*> slopes;
    bool symmetric;
};

Pieces pieces_of(const DesignFormulas& of) {
    static const std::vector<PiecesOfKind> kinds{
        {"flat-and-rounded", {"t"}, {"0", "(x - t)/R"}, true},
        {"tilted-wedge", {"0"}, {"-(phi + alpha)", "phi - alpha"}, false},
        {"tilted-flat-and-rounded",
         {"-alpha*R - 2*t", "-alpha*R", "0"},
         {"(x + 2*t)/R", "-alpha", "x/R", "x/R"},
         false}};
    const auto row = std::ranges::find(kinds, of.kind(), &PiecesOfKind::kind);
    if (row == kinds.end()) {
        return {of.list("knots", false), of.list("slopes", true), of.flag("symmetric")};
    }
    const auto formulas = [&](const std::vector<const char*>& texts) {
        std::vector<Expr> all;
        for (const char* const text : texts) {
            all.push_back(formula::parse(text, formula::Symbols{"x", "t", "R", "phi", "alpha"}));
            for (const char* const key : {"t", "R", "phi", "alpha"}) {
                if (const auto value = of.number_or_none("profile", key)) {
                    all.back() = substitute(all.back(), key, *value);
                }
            }
        }
        return all;
    };
    return {formulas(row->knots), formulas(row->slopes), row->symmetric};
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

std::optional<ParametricSlope> slope_of(const Pieces& given, const DesignScene& design,
                                        std::string& why_not) {
    ParametricSlope s;
    s.symmetric = given.symmetric;
    for (const Expr& slope : given.slopes) {
        const auto linear = contact::as_linear(slope, "x");
        if (!linear) {
            why_not = "a piece of the slope is curved: enclosures over a range of the parameter "
                      "are known for piecewise linear slopes, power laws and full stick";
            return {};
        }
        s.pieces.push_back({linear->at_origin, linear->rate});
    }
    s.knots = given.knots;
    if (s.symmetric) {
        s.origin = s.knots.size();
        s.knots.insert(s.knots.begin(), whole(0));
        for (const Expr& knot : given.knots) {
            s.knots.insert(s.knots.begin(), -knot);
        }
        const std::vector<ParametricSlope::Piece> right = s.pieces;
        for (const auto& [at_origin, rate] : right) {
            s.pieces.insert(s.pieces.begin(), {-at_origin, rate});
        }
    } else {
        s.origin = static_cast<std::size_t>(std::ranges::find_if(s.knots, identically_zero) -
                                            s.knots.begin());
        if (s.origin == s.knots.size()) {
            s.origin = knots_before_origin(s.knots, design.parameter, design.range.from);
            if (s.origin != knots_before_origin(s.knots, design.parameter, design.range.to)) {
                why_not = "a knot passes the origin within the range";
                return {};
            }
            const auto at = static_cast<std::ptrdiff_t>(s.origin);
            s.pieces.insert(s.pieces.begin() + at, s.pieces[s.origin]);
            s.knots.insert(s.knots.begin() + at, whole(0));
        }
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

std::vector<contact::ErrorFamily> DesignScene::errors(std::string& why_not) const {
    contact::ErrorQuestion question;
    question.terms = terms;
    question.unit = unit;
    const DesignFormulas of(*top_, parameter);
    std::vector<contact::ErrorFamily> all;
    const auto load = load_of(of, why_not);
    if (!load) {
        return all;
    }
    const Profile profile = *at(range.from).profile;
    const bool power_law = profile.kind() == Profile::Kind::power_law; // cylinders and wedges, too
    const Pieces pieces = power_law ? Pieces{{}, {}, true} : pieces_of(of);
    std::optional<Expr> length;
    if (pieces.symmetric && load->a) {
        length = whole(2) * *load->a;
    }
    std::optional<ParametricSlope> slope;
    if (!shear && !power_law) {
        slope = slope_of(pieces, *this, why_not);
        if (!slope) {
            return all;
        }
    }
    if (shear && at(range.from).proportional()) {
        why_not = "q is proportional to p: its relative error is that of the pressure";
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
        } else if (power_law) {
            if (unit == contact::ReachUnit::distance && !load->a) {
                why_not = "the half-width of a power law under a given load is not enclosed over a "
                          "range of the parameter: give a, or unit = \"fraction\"";
                return {};
            }
            all.push_back(contact::power_law_errors(
                of.number_or_none("profile", "m").value_or(profile.parameters().at("m").expr()),
                load->a, question));
        } else {
            all.push_back(contact::linear_slope_errors(*slope, *load, question));
        }
    }
    return all;
}

} // namespace edgeproof::scene
