// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/formula/evaluation/complex_taylor.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace edgeproof::contact {
namespace {

const Expr symbol_x = Expr::symbol("x");  // NOLINT: Expr is immutable and needs no other source
const Expr number_zero = Expr::number(0); // NOLINT

bool is_literal_zero(const Expr& e) {
    const Rational* q = e.rational();
    return q != nullptr && *q == 0;
}

/// -e(-x): the slope of the mirror image.
Expr mirrored(const Expr& e) {
    const auto linear = as_linear(e, "x");
    if (linear) {
        return is_literal_zero(linear->at_origin) ? e : linear->rate * symbol_x - linear->at_origin;
    }
    return -substitute(e, "x", -symbol_x);
}

} // namespace

Profile Profile::assemble(Kind kind, std::vector<Exact> knots, std::vector<Expr> slopes) {
    Profile p;
    p.kind_ = kind;
    // The origin is a knot even where g' is smooth: the consistency condition has one integral for
    // each side of it.
    std::size_t at = 0;
    while (at < knots.size() && knots[at].sign() < 0) {
        ++at;
    }
    if (at == knots.size() || knots[at].sign() != 0) {
        knots.insert(knots.begin() + static_cast<std::ptrdiff_t>(at), Exact(number_zero));
        slopes.insert(slopes.begin() + static_cast<std::ptrdiff_t>(at), slopes[at]);
    }
    p.origin_ = at;
    p.knots_ = std::move(knots);
    for (const Expr& slope : slopes) {
        p.pieces_.push_back({slope, as_linear(slope, "x")});
    }
    p.corner_.assign(p.knots_.size(), false);
    return p;
}

void Profile::continue_outer_pieces() {
    for (const Edge edge : {Edge::right, Edge::left}) {
        const auto end = rising_limit(*this, edge);
        if (!end) {
            continue;
        }
        const Expr at = end->at.expr();
        const Expr rate = Expr::number(end->rate);
        const Expr line = substitute(end->slope, "x", at) - rate * at + rate * symbol_x;
        const SlopePiece piece{line, as_linear(line, "x")};
        if (edge == Edge::right) {
            right_limit_ = end->at;
            knots_.push_back(end->at);
            pieces_.push_back(piece);
            corner_.push_back(false);
        } else {
            left_limit_ = end->at;
            knots_.insert(knots_.begin(), end->at);
            pieces_.insert(pieces_.begin(), piece);
            corner_.insert(corner_.begin(), false);
            ++origin_;
        }
    }
}

Profile Profile::power_law(const Exact& C, const Exact& m) {
    require(C.sign() > 0, "the power-law constant C = " + C.text() + " is not positive",
            "give C > 0");
    require(m.sign() >= 0, "the power-law exponent m = " + m.text() + " is negative",
            "give m >= 0 (0: a wedge, 1: Hertz)");
    const Expr& c = C.expr();
    const Rational* exponent = m.expr().rational();
    std::vector<Expr> slopes;
    // moore-hills EQ10
    if (exponent != nullptr && *exponent == 0) {
        slopes = {-c, c};
    } else if (exponent != nullptr && *exponent == 1) {
        slopes = {c * symbol_x, c * symbol_x};
    } else {
        slopes = {-(c * pow(-symbol_x, m.expr())), c * pow(symbol_x, m.expr())};
    }
    Profile p = assemble(Kind::power_law, {Exact(number_zero)}, std::move(slopes));
    p.corner_[0] = exponent != nullptr && *exponent == 0;
    p.symmetric_ = true;
    p.parameters_ = {{"C", C}, {"m", m}};
    return p;
}

Profile Profile::flat_and_rounded(const Exact& t, const Exact& R) {
    require(t.sign() >= 0, "the half-length of the flat t = " + t.text() + " is negative",
            "give t >= 0");
    require(R.sign() > 0, "the radius R = " + R.text() + " is not positive", "give R > 0");
    const Expr& T = t.expr();
    const Expr& r = R.expr();
    // moore-hills EQ16
    Profile p = t.sign() == 0 ? assemble(Kind::flat_and_rounded, {}, {symbol_x / r})
                              : assemble(Kind::flat_and_rounded, {Exact(-T), t},
                                         {(symbol_x + T) / r, number_zero, (symbol_x - T) / r});
    p.symmetric_ = true;
    p.parameters_ = {{"t", t}, {"R", R}};
    return p;
}

Profile Profile::tilted_wedge(const Exact& phi, const Exact& alpha) {
    require(phi.sign() > 0, "the wedge angle phi = " + phi.text() + " is not positive",
            "give phi > 0 (the half-angle is pi/2 - phi)");
    const Expr& f = phi.expr();
    const Expr& al = alpha.expr();
    require(Exact(f - al).sign() > 0 && Exact(f + al).sign() > 0,
            "the tilt alpha = " + alpha.text() + " is not smaller than phi = " + phi.text(),
            "give |alpha| < phi: beyond, one face of the wedge lifts off");
    // moore-hills EQ26
    Profile p = assemble(Kind::tilted_wedge, {Exact(number_zero)}, {-(f + al), f - al});
    p.corner_[0] = true;
    p.symmetric_ = alpha.sign() == 0;
    p.parameters_ = {{"phi", phi}, {"alpha", alpha}};
    return p;
}

Profile Profile::tilted_flat_and_rounded(const Exact& alpha, const Exact& t, const Exact& R) {
    require(alpha.sign() >= 0, "the tilt alpha = " + alpha.text() + " is negative",
            "give alpha >= 0, clockwise; mirror the scene for the other sense");
    require(t.sign() >= 0, "the half-length of the flat t = " + t.text() + " is negative",
            "give t >= 0");
    require(R.sign() > 0, "the radius R = " + R.text() + " is not positive", "give R > 0");
    const Expr& al = alpha.expr();
    const Expr& r = R.expr();
    const Expr two_t = Expr::number(2) * t.expr();
    std::vector<Exact> knots;
    std::vector<Expr> slopes;
    if (t.sign() == 0) {
        slopes = {symbol_x / r};
    } else if (alpha.sign() == 0) {
        // The minimum of an upright punch is the whole flat; the paper's frame (moore-hills EQ33)
        // then has its origin at the right end of the flat.
        knots = {Exact(-two_t), Exact(number_zero)};
        slopes = {(symbol_x + two_t) / r, number_zero, symbol_x / r};
    } else {
        // moore-hills EQ33
        knots = {Exact(-(al * r) - two_t), Exact(-(al * r))};
        slopes = {(symbol_x + two_t) / r, -al, symbol_x / r};
    }
    Profile p = assemble(Kind::tilted_flat_and_rounded, std::move(knots), std::move(slopes));
    p.parameters_ = {{"alpha", alpha}, {"t", t}, {"R", R}};
    return p;
}

namespace {

/// Writes hypot and atan2 with functions that are analytic where they are.
Expr with_analytic_functions(const Expr& e) {
    if (e.args().empty()) {
        return e;
    }
    std::vector<Expr> args;
    std::ranges::transform(e.args(), std::back_inserter(args), with_analytic_functions);
    if (e.builtin() != formula::Builtin::hypot && e.builtin() != formula::Builtin::atan2) {
        return Expr::with_args(e, std::move(args));
    }
    const Expr root = Expr::call("sqrt", {args[0] * args[0] + args[1] * args[1]});
    // DLMF 4.24(iii): half of the angle
    return e.builtin() == formula::Builtin::hypot
               ? root
               : Expr::number(2) * Expr::call("atan", {args[0] / (root + args[1])});
}

/// Returns the slopes of analytic pieces, which all enclosures need.
std::vector<Expr> analytic_pieces(const std::vector<Expr>& slopes) {
    std::vector<Expr> analytic;
    for (const Expr& given : slopes) {
        Expr slope = with_analytic_functions(given);
        const bool has_corners = formula::any_part(slope, [](const Expr& part) {
            using enum formula::Builtin;
            return part.builtin() == abs || part.builtin() == sgn || part.builtin() == step ||
                   part.builtin() == max || part.builtin() == min;
        });
        require(as_linear(slope, "x") || formula::has_complex_taylor(slope),
                "the slope " + to_text(given) +
                    (has_corners
                         ? " is made of several analytic functions (abs, sgn, step, max, min)"
                         : " has an integral or a sum"),
                has_corners ? "write it as pieces, with a knot where the formula changes"
                            : "write it with elementary functions of x");
        analytic.push_back(std::move(slope));
    }
    return analytic;
}

} // namespace

Profile Profile::piecewise(const std::vector<Exact>& knots, const std::vector<Expr>& slopes) {
    require(slopes.size() == knots.size() + 1,
            "a piecewise profile with " + std::to_string(knots.size()) + " knots has " +
                std::to_string(slopes.size()) + " pieces",
            "give one piece more than knots");
    Profile p = assemble(Kind::piecewise, knots, analytic_pieces(slopes));
    p.corner_ = checked_corners(p);
    p.continue_outer_pieces();
    return p;
}

Profile Profile::piecewise_symmetric(const std::vector<Exact>& knots,
                                     const std::vector<Expr>& slopes) {
    require(slopes.size() == knots.size() + 1,
            "a symmetric piecewise profile with " + std::to_string(knots.size()) +
                " knots in x > 0 has " + std::to_string(slopes.size()) + " pieces",
            "give one piece more than knots; the left half is its mirror image");
    require(knots.empty() || knots.front().sign() > 0,
            "a symmetric piecewise profile has a knot at or left of the origin",
            "give knots x > 0 only; the origin is always one");
    std::vector<Exact> all;
    std::vector<Expr> both;
    for (std::size_t i = knots.size(); i-- > 0;) {
        all.emplace_back(-knots[i].expr());
    }
    all.emplace_back(number_zero);
    all.insert(all.end(), knots.begin(), knots.end());
    const std::vector<Expr> pieces = analytic_pieces(slopes);
    for (std::size_t i = pieces.size(); i-- > 0;) {
        both.push_back(mirrored(pieces[i]));
    }
    both.insert(both.end(), pieces.begin(), pieces.end());
    Profile p = assemble(Kind::piecewise, all, both);
    p.symmetric_ = true;
    p.corner_ = checked_corners(p);
    return p;
}

std::string Profile::kind_name() const {
    constexpr std::array names{"power-law", "flat-and-rounded", "tilted-wedge",
                               "tilted-flat-and-rounded", "piecewise"};
    static_assert(names.size() == static_cast<std::size_t>(Kind::piecewise) + 1);
    return names.at(static_cast<std::size_t>(kind_));
}

bool Profile::piecewise_linear() const noexcept {
    return std::all_of(pieces_.begin(), pieces_.end(),
                       [](const SlopePiece& piece) { return piece.linear.has_value(); });
}

std::optional<std::size_t> Profile::flat_end(Edge edge) const {
    const bool right = edge == Edge::right;
    const auto is_flat = [&](std::size_t piece) {
        const auto& line = pieces_[piece].linear;
        return line && is_literal_zero(line->at_origin) && is_literal_zero(line->rate);
    };
    std::size_t knot = origin_;
    while (knot != (right ? knots_.size() - 1 : 0) && is_flat(right ? knot + 1 : knot)) {
        knot = right ? knot + 1 : knot - 1;
    }
    return knot == origin_ ? std::nullopt : std::optional(knot);
}

Profile Profile::reflected() const {
    Profile p;
    // The mirror image of a tilted profile is tilted anticlockwise, so that only symmetric profiles
    // keep their kind.
    p.kind_ = symmetric_ ? kind_ : Kind::piecewise;
    p.symmetric_ = symmetric_;
    p.axisymmetric_ = axisymmetric_;
    if (symmetric_) {
        p.parameters_ = parameters_;
    }
    for (std::size_t i = knots_.size(); i-- > 0;) {
        p.knots_.emplace_back(i == origin_ ? number_zero : -knots_[i].expr());
        p.corner_.push_back(corner_[i]);
    }
    for (std::size_t i = pieces_.size(); i-- > 0;) {
        const Expr slope = mirrored(pieces_[i].slope);
        p.pieces_.push_back({slope, as_linear(slope, "x")});
    }
    p.origin_ = knots_.size() - 1 - origin_;
    const auto mirrored_place = [](const std::optional<Exact>& x) {
        return x ? std::optional(Exact(-x->expr())) : std::nullopt;
    };
    p.left_limit_ = mirrored_place(right_limit_);
    p.right_limit_ = mirrored_place(left_limit_);
    return p;
}

namespace {

using Linear = SlopePiece::Linear;
using Kind = Expr::Kind;

bool is_literal_one(const Expr& e) {
    const Rational* q = e.rational();
    return q != nullptr && *q == 1;
}

// Sums with 0 and products with 0 and 1 are simplified, so that the pieces of the common profiles
// stay readable and constants are recognised.
Expr plus(const Expr& x, const Expr& y) {
    return is_literal_zero(x) ? y : is_literal_zero(y) ? x : x + y;
}
Expr minus(const Expr& x, const Expr& y) {
    return is_literal_zero(y) ? x : is_literal_zero(x) ? -y : x - y;
}
Expr times(const Expr& x, const Expr& y) {
    if (is_literal_zero(x) || is_literal_zero(y)) {
        return Expr::number(0);
    }
    return is_literal_one(x) ? y : is_literal_one(y) ? x : x * y;
}

} // namespace

std::optional<Linear> as_linear(const Expr& e, std::string_view x) {
    const Expr zero = Expr::number(0);
    if (!free_symbols(e).contains(std::string(x))) {
        return Linear{e, zero};
    }
    switch (e.kind()) {
    case Kind::symbol:
        return Linear{zero, Expr::number(1)};
    case Kind::neg: {
        const auto f = as_linear(e.arg(0), x);
        if (!f) {
            return {};
        }
        return Linear{minus(zero, f->at_origin), minus(zero, f->rate)};
    }
    case Kind::add:
    case Kind::sub: {
        const auto f = as_linear(e.arg(0), x);
        const auto g = as_linear(e.arg(1), x);
        if (!f || !g) {
            return {};
        }
        const auto combine = e.kind() == Kind::add ? plus : minus;
        return Linear{combine(f->at_origin, g->at_origin), combine(f->rate, g->rate)};
    }
    case Kind::mul: {
        const auto f = as_linear(e.arg(0), x);
        const auto g = as_linear(e.arg(1), x);
        if (!f || !g || (!is_literal_zero(f->rate) && !is_literal_zero(g->rate))) {
            return {};
        }
        const Linear& form = is_literal_zero(f->rate) ? *g : *f;
        const Expr& factor = is_literal_zero(f->rate) ? f->at_origin : g->at_origin;
        return Linear{times(form.at_origin, factor), times(form.rate, factor)};
    }
    case Kind::div: {
        const auto f = as_linear(e.arg(0), x);
        const auto g = as_linear(e.arg(1), x);
        if (!f || !g || !is_literal_zero(g->rate)) {
            return {};
        }
        const auto over = [&](const Expr& c) { return is_literal_zero(c) ? c : c / g->at_origin; };
        return Linear{over(f->at_origin), over(f->rate)};
    }
    default:
        return {};
    }
}

} // namespace edgeproof::contact
