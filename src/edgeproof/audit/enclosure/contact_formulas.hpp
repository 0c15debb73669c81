// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/enclosure/tilted_path.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::audit {

using formula::Exact;
using formula::Expr;

/// The functions of a contact inside an integral, as formulas for Integrand. They contain a, b, Q,
/// sig0 and special names that no text can contain (`constants`). Available for the paper's
/// profiles; throws Error for others.
class ContactFormulas {
public:
    /// Keeps references to the profile and the contact.
    ContactFormulas(const contact::Profile& profile, const contact::BallContact& contact,
                    const Ball& modulus)
        : profile_(profile), contact_(contact), modulus_(modulus) {
        named("modulus of the contact", modulus);
        switch (profile.kind()) {
        case contact::Profile::Kind::power_law: {
            const Rational* m = parameter("m").rational();
            if (m == nullptr) {
                throw Error("a power law whose exponent is not rational has no enclosure inside "
                            "an integral");
            }
            exponent_ = *m;
            named("factor of the force rate", contact.force_rate() / pow(contact.a(), *m));
            named("factor of the pressure", contact.force_rate() / Ball::pi(contact.bits()));
            break;
        }
        case contact::Profile::Kind::tilted_wedge:
            named("factor of the force rate", contact.force_rate());
            named("ratio of the edges", contact.b() / contact.a());
            break;
        case contact::Profile::Kind::flat_and_rounded:
            break;
        case contact::Profile::Kind::tilted_flat_and_rounded:
            if (profile.knots().size() == 3 && !profile.symmetric()) {
                break;
            }
            [[fallthrough]];
        default:
            throw Error("a profile of kind " + profile.kind_name() +
                        " has no enclosure inside an integral");
        }
        if (!exponent_) {
            read_pressure();
        }
    }

    [[nodiscard]] const std::map<std::string, Ball, std::less<>>& constants() const {
        return constants_;
    }
    [[nodiscard]] bool symmetric() const { return profile_.symmetric(); }

    /// Returns g1(x), or |g1(x)|, in the piece that contains `near`.
    [[nodiscard]] Expr slope(const Expr& x, const Ball& near, bool absolute) const {
        std::size_t piece = 0;
        for (const std::size_t knot : changing_knots(absolute)) {
            if (beyond(near, profile_.knots()[knot].expr())) {
                piece = knot + 1;
            }
        }
        const Expr g = substitute(profile_.pieces()[piece].slope, "x", x);
        // g' <= 0 left of the origin and >= 0 to the right of it.
        return absolute && piece <= profile_.origin() ? -g : g;
    }
    /// Return P1of(s) and bof(s) for contacts like the one whose right edge is `near`; nothing if
    /// they are available only on a path of angles.
    [[nodiscard]] std::optional<Expr> force_rate(const Expr& s, const Ball& near) const {
        switch (profile_.kind()) {
        case contact::Profile::Kind::power_law:
            return Expr::symbol("factor of the force rate") * pow(s, Expr::number(*exponent_));
        case contact::Profile::Kind::tilted_wedge:
            return Expr::symbol("factor of the force rate");
        case contact::Profile::Kind::flat_and_rounded: {
            const Expr t = parameter("t");
            if (!beyond(near, t)) {
                return integer(0);
            }
            // This is pi/2 - asin(t/s) in a form that keeps its digits and its root at s = t.
            return Expr::symbol("modulus of the contact") * s / parameter("R") * integer(2) *
                   call_of("atan", {root_of((s - t) / (s + t))});
        }
        default:
            if (beyond(near, parameter("alpha") * parameter("R"))) {
                return std::nullopt;
            }
            // The whole contact is on the right arc.
            return Expr::symbol("modulus of the contact") * Expr::pi() * s /
                   (integer(2) * parameter("R"));
        }
    }
    [[nodiscard]] std::optional<Expr> left_edge(const Expr& s, const Ball& near) const {
        if (profile_.symmetric()) {
            return s;
        }
        if (profile_.kind() == contact::Profile::Kind::tilted_wedge) {
            return Expr::symbol("ratio of the edges") * s;
        }
        if (beyond(near, parameter("alpha") * parameter("R"))) {
            return std::nullopt;
        }
        return s;
    }
    /// Returns the path of angles for contacts like that one, if they need one.
    [[nodiscard]] std::optional<TiltedPath> path(const Ball& near) const {
        if (profile_.kind() != contact::Profile::Kind::tilted_flat_and_rounded ||
            !beyond(near, parameter("alpha") * parameter("R"))) {
            return std::nullopt;
        }
        const long bits = contact_.bits();
        const auto value = [&](const char* name) {
            return enclosed_constant(Exact(parameter(name)), bits);
        };
        const Ball r = value("alpha") * value("R");
        const Ball left = -contact_.with_right_edge(near).b();
        const bool on_arc = !beyond(left, profile_.knots()[0].expr());
        return TiltedPath(on_arc ? TiltedPath::LeftEdge::on_left_arc
                                 : TiltedPath::LeftEdge::on_flat,
                          r, value("t"), value("R"), modulus_);
    }
    /// Returns q(x) under full stick.
    [[nodiscard]] static Expr traction(const Expr& x) {
        const Expr tension = Expr::symbol("sig0") * (integer(2) * x + edge_b - edge_a) / integer(8);
        return (Expr::symbol("Q") / Expr::pi() + tension) / root_of((edge_a - x) * (x + edge_b));
    }
    /// Returns a function whose real part is p(x) and which is analytic above the contact: the
    /// logarithm of the distance from a corner is taken as log_above. Returns nothing for a power
    /// law with a non-integer exponent.
    [[nodiscard]] std::optional<Expr> pressure_above(const Expr& x) const {
        const Expr right = root_of(edge_a - x);
        const Expr left = root_of(x + (symmetric() ? edge_a : edge_b));
        if (exponent_) {
            if (!whole_exponent()) {
                return std::nullopt;
            }
            const Expr z = x / edge_a;
            return whole_power_pressure(right * left / edge_a, z, call_of("log_above", {z}));
        }
        Expr sum = Expr::symbol("arc of the contact") * (right * left);
        for (std::size_t i = 0; i < profile_.knots().size(); ++i) {
            if (!constants_.contains(indexed("knot", i))) {
                continue;
            }
            const auto at_knot = [&](const char* name) { return Expr::symbol(indexed(name, i)); };
            // The function G, with |v - x| as the real part of a logarithm.
            const Expr green =
                integer(2) * call_of("log", {at_knot("inset") * left + at_knot("outset") * right}) -
                call_of("log", {edge_a + (symmetric() ? edge_a : edge_b)}) -
                call_of("log_above", {x - at_knot("knot")});
            sum = sum + (at_knot("jump") + at_knot("drop") * (at_knot("knot") - x)) * green;
        }
        return Expr::symbol("factor of the pressure") * sum;
    }
    /// Returns p(x) of a power law, near the origin or near an edge, for x with the sign of `near`.
    /// For y = 1 - z^2, I_m = w 2F1((1 - m)/2, 1; 3/2; y); and by the connection from y to 1 - y
    /// (Abramowitz and Stegun 15.3.6)
    ///     I_m = (w/m) 2F1((1 - m)/2, 1; 1 - m/2; z^2) + (sqrt(pi)/2) Gamma(-m/2)/Gamma((1 - m)/2)
    ///     z^m.
    [[nodiscard]] Expr power_law_pressure(const Expr& x, const Ball& near) const {
        if (!exponent_) {
            throw Error("'p' has no enclosure inside such an integral");
        }
        const Expr m = Expr::number(*exponent_);
        const Expr half = Expr::number(Rational(1, 2));
        const Expr z = (certainly_positive(near) ? x : -x) / edge_a;
        const Expr w = root_of_y(x);
        if (whole_exponent()) {
            return whole_power_pressure(w, z, call_of("log", {z}));
        }
        const Expr first = (integer(1) - m) * half;
        const Ball size = abs(near) / contact_.a() * 10;
        Expr integral;
        if (certainly_less(size, Ball(7, size.bits()))) {
            const Expr even =
                w / m *
                call_of("gauss", {first, integer(1), integer(1) - m * half, pow(z, integer(2))});
            integral = even + root_of(Expr::pi()) * half * call_of("gamma", {-(m * half)}) /
                                  call_of("gamma", {first}) * pow(z, m);
        } else {
            const Expr y = (edge_a - x) * (x + edge_a) / pow(edge_a, integer(2));
            integral = w * call_of("gauss", {first, integer(1), Expr::number(Rational(3, 2)), y});
        }
        return Expr::symbol("factor of the pressure") * integral;
    }

    /// Returns the arguments at which g1 (or |g1|), p, P1of or bof changes its formula: constants,
    /// and b^{-1} of constants; none for other functions.
    [[nodiscard]] std::vector<Expr> knots(std::string_view function, bool absolute) const {
        std::vector<Expr> all;
        if (function == "g1") {
            for (const std::size_t knot : changing_knots(absolute)) {
                all.push_back(profile_.knots()[knot].expr());
            }
        } else if (function == "p") {
            const Expr inner = edge_a * Expr::number(Rational(7, 10));
            all = {-inner, integer(0), inner};
        } else if (function == "P1of" || function == "bof") {
            if (profile_.kind() == contact::Profile::Kind::flat_and_rounded) {
                all = {parameter("t")};
            } else if (profile_.kind() == contact::Profile::Kind::tilted_flat_and_rounded) {
                const Expr r = parameter("alpha") * parameter("R");
                all = {r, call_of("binv", {r + integer(2) * parameter("t")})};
            }
        }
        return all;
    }

private:
    [[nodiscard]] bool whole_exponent() const {
        return exponent_ && denominator(*exponent_) == 1 && *exponent_ <= most_whole;
    }
    /// p of a power law with a whole exponent, for w = sqrt(1 - z^2), z = |x|/a and log(z).
    /// I_m = (w + (m - 1) z^2 I_{m-2})/m, I_0 = log((1 + w)/z), I_1 = w.
    [[nodiscard]] Expr whole_power_pressure(const Expr& w, const Expr& z, const Expr& log_z) const {
        const long m = exponent_->convert_to<long>();
        Expr sum = m % 2 == 1 ? w : call_of("log", {integer(1) + w}) - log_z;
        for (long k = m % 2 + 2; k <= m; k += 2) {
            sum = (w + integer(k - 1) * (pow(z, integer(2)) * sum)) / integer(k);
        }
        return Expr::symbol("factor of the pressure") * sum;
    }
    [[nodiscard]] Expr parameter(const char* name) const {
        return profile_.parameters().at(name).expr();
    }
    /// Introduces a name for a number.
    Expr named(const std::string& name, const Ball& value) {
        constants_.insert_or_assign(name, value);
        return Expr::symbol(name);
    }

    void read_pressure() {
        const auto& slope = contact_.slope();
        for (std::size_t i = 0; i < slope.knots.size(); ++i) {
            if (contact_.bends_inside(i)) {
                const contact::Mark<Ball>& mark = contact_.knot_marks()[i];
                named(indexed("knot", i), slope.knots[i]);
                named(indexed("jump", i), slope.jump(i));
                named(indexed("drop", i), slope.rate_drop(i));
                named(indexed("inset", i), contact::Field<Ball>::root(mark.right));
                named(indexed("outset", i), contact::Field<Ball>::root(mark.left));
            }
        }
        named("arc of the contact", contact_.arc());
        named("factor of the pressure", contact_.pressure_factor());
    }
    /// Returns the knots at which the formula of g1, or of |g1|, changes.
    [[nodiscard]] std::vector<std::size_t> changing_knots(bool absolute) const {
        std::vector<std::size_t> knots;
        for (std::size_t i = 0; i < profile_.knots().size(); ++i) {
            const bool changes = !(profile_.pieces()[i].slope == profile_.pieces()[i + 1].slope);
            if (changes || (absolute && i == profile_.origin())) {
                knots.push_back(i);
            }
        }
        return knots;
    }
    [[nodiscard]] bool beyond(const Ball& near, const Expr& knot) const {
        const Ball at = enclosed_constant(Exact(knot), contact_.bits());
        if (overlaps(near, at)) {
            throw BudgetError("a place that cannot be distinguished from a knot");
        }
        return certainly_less(at, near);
    }
    /// w = sqrt(1 - z^2), z = |x|/a.
    [[nodiscard]] Expr root_of_y(const Expr& x) const {
        return root_of((edge_a - x) * (x + edge_a)) / edge_a;
    }

    static Expr integer(long n) { return Expr::number(Rational(n)); }
    static Expr call_of(const char* f, std::vector<Expr> args) {
        return Expr::call(f, std::move(args));
    }
    static Expr root_of(const Expr& x) { return call_of("sqrt", {x}); }
    static std::string indexed(const char* name, std::size_t i) {
        return std::string(name) + " " + std::to_string(i);
    }
    /// The greatest exponent of a power law that is written as a formula.
    static constexpr long most_whole = 200;
    static inline const Expr edge_a = Expr::symbol("a");
    static inline const Expr edge_b = Expr::symbol("b");

    const contact::Profile& profile_;
    const contact::BallContact& contact_;
    Ball modulus_;
    std::map<std::string, Ball, std::less<>> constants_;
    std::optional<Rational> exponent_; ///< of a power law
};

} // namespace edgeproof::audit
