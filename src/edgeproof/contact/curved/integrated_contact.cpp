// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_marks.hpp"
#include "edgeproof/contact/profile/profile_checks.hpp"
#include "edgeproof/contact/profile/slope_from_knot.hpp"
#include "edgeproof/formula/evaluation/complex_taylor.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace edgeproof::contact {
namespace {

/// With this number of terms or more one disk is cheaper than one integral for each term; the
/// integrands cancel near the edge, the more the higher the power.
constexpr std::size_t least_terms_of_disk = 6;

/// Returns the bits of accuracy wanted of an integral: between edges that are wide balls more bits
/// are not attainable, and the attempt takes long.
long goal_between(const Ball& a, const Ball& b, long bits) {
    constexpr long spare = 8;
    const long accuracy = Ball(a + b).relative_accuracy_bits(); // of an exact sum: beyond all bits
    return accuracy >= bits ? bits : std::min(bits, std::max(spare, accuracy + spare));
}

} // namespace

bool IntegratedContact::handles(const Profile& profile) {
    return std::all_of(profile.pieces().begin(), profile.pieces().end(),
                       [](const SlopePiece& piece) { return has_complex_taylor(piece.slope); });
}

IntegratedContact::IntegratedContact(const Profile& profile, const formula::Exact& contact_modulus,
                                     const Load& load, long bits)
    : profile_(profile), load_(load), bits_(bits),
      modulus_(enclosed_constant(contact_modulus, bits)) {
    for (const formula::Exact& knot : profile.knots()) {
        knots_.push_back(enclosed_constant(knot, bits));
    }
    on_edge_.assign(knots_.size(), std::nullopt);
    if (load.kind == Load::Kind::right_edge) {
        a_ = enclosed_constant(load.value, bits);
        find_knots_on_edges();
    }
    if (load.kind == Load::Kind::right_edge && profile.symmetric()) {
        b_ = a_;
    } else {
        enclose_edges(contact_modulus);
    }
    check_reach(profile_, a_, b_);
}

void IntegratedContact::find_knots_on_edges() {
    for (std::size_t i = 0; i < knots_.size(); ++i) {
        const formula::Expr& a = load_.value.expr();
        const formula::Expr& knot = profile_.knots()[i].expr();
        if (overlaps(knots_[i], a_) && certainly_zero(a - knot)) {
            on_edge_[i] = Edge::right;
        } else if ((profile_.symmetric() || odd_) && overlaps(-knots_[i], a_) &&
                   certainly_zero(a + knot)) {
            on_edge_[i] = Edge::left;
        }
    }
}

std::optional<formula::Exact> IntegratedContact::known(Edge edge) const {
    const bool known = load_.kind == Load::Kind::right_edge &&
                       (edge == Edge::right || profile_.symmetric() || odd_);
    return known ? std::optional(load_.value) : std::nullopt;
}

bool IntegratedContact::edge_may_be_on_knot() const {
    for (const Ball& knot : knots_) {
        if ((!known(Edge::right) && overlaps(knot, a_)) ||
            (!known(Edge::left) && overlaps(-knot, b_))) {
            return true;
        }
    }
    return false;
}

// docs/curved-slopes.md, "What is integrated".
Ball IntegratedContact::slope_integral(const Ball& a, const Ball& b, long harmonic) const {
    Ball sum(0, bits_);
    for (const quadrature::ThetaSpan& span : spans(a, b)) {
        SlopeIntegrand f = integrand(span, a, b);
        f.harmonic = harmonic;
        f.goal = zone_ ? goal_between(a, b, bits_) : 0;
        sum += integrate(f, span, bits_);
    }
    return sum;
}

/// P = (E*/2) times the integral of g'(s) (s - c)/w(s) ds (eqn:AppliedNormalForce_NonSym with
/// eqn:Consistency).
Ball IntegratedContact::force_of(const Ball& a, const Ball& b) const {
    return modulus_ * (a + b) / 4 * slope_integral(a, b, 1);
}

Ball IntegratedContact::moment() const {
    if (profile_.symmetric()) {
        return {0, bits_};
    }
    // M is (E*/4) times the integral of w (v + c) dg'(v) (docs/mechanics.md, "One measure, six
    // kernels"), integrated by parts.
    const Ball d = (a_ + b_) / 2;
    return modulus_ / 4 * d *
           (d * slope_integral(a_, b_, 2) + (a_ - b_) * slope_integral(a_, b_, 1));
}

std::vector<Ball> IntegratedContact::expansion(Edge edge, std::size_t terms) const {
    if (edge == Edge::left && (zone_ || !profile_.symmetric())) {
        IntegratedContact mirror(*this);
        mirror.profile_ = profile_.reflected();
        mirror.knots_.clear();
        for (const formula::Exact& knot : mirror.profile_.knots()) {
            mirror.knots_.push_back(enclosed_constant(knot, bits_));
        }
        std::reverse(mirror.on_edge_.begin(), mirror.on_edge_.end());
        for (auto& edge_of_knot : mirror.on_edge_) {
            edge_of_knot = edge_of_knot ? std::optional(opposite(*edge_of_knot)) : std::nullopt;
        }
        std::swap(mirror.a_, mirror.b_);
        mirror.disks_.clear();
        mirror.over_theta_.reset();
        mirror.roots_.reset();
        return mirror.right_expansion(terms);
    }
    return right_expansion(terms);
}

// I_k (docs/expansions.md, "Coefficients of curved slopes").
Ball IntegratedContact::coefficient(std::size_t k, std::size_t piece, const Ball& x,
                                    const std::vector<Ball>& taylor, bool from_right_edge) const {
    const std::vector<Ball> head(taylor.begin(),
                                 taylor.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    Ball sum(0, bits_);
    for (const quadrature::ThetaSpan& span : spans(a_, b_)) {
        SlopeIntegrand f = integrand(span, a_, b_);
        f.x = &x;
        f.holds_x = span.piece == piece;
        f.taylor = &head;
        f.from_right_edge = from_right_edge;
        f.goal = zone_ ? goal_between(a_, b_, bits_) : 0;
        sum += integrate(f, span, bits_);
    }
    return sum;
}

std::vector<Ball> IntegratedContact::coefficients_by_disk(std::size_t piece,
                                                          std::size_t terms) const {
    Ball gap = a_ + b_;
    for (std::size_t i = 0; i < knots_.size(); ++i) {
        if (inside(i)) {
            gap = min(gap, abs(Ball(a_ - knots_[i])));
        }
    }
    // A disk is computed to about half of its working bits (disk_goal).
    const PressureDisk disk(over_theta(), piece, a_, gap, terms, 2 * bits_ + 48);
    std::vector<Ball> I;
    if (disk.found()) {
        const BallSeries at = disk.at(Ball(0, bits_), terms);
        for (std::size_t k = 0; k < terms; ++k) {
            I.push_back(at[k].with_bits(bits_));
        }
    }
    return I;
}

std::vector<Ball> IntegratedContact::right_expansion(std::size_t terms) const {
    Ball unknown(0, bits_);
    arb_indeterminate(unknown.data());
    std::size_t last = 0; // the piece at the edge
    for (std::size_t i = 0; i < knots_.size(); ++i) {
        if (certainly_less(knots_[i], a_)) {
            ++last;
        } else if (!certainly_less(a_, knots_[i]) && on_edge_[i] != Edge::right) {
            return std::vector<Ball>(terms, unknown);
        }
    }
    // p = (E*/(2 pi)) sqrt(u (D - u)) I(x), where I is the sum of I_k (-u)^k (docs/expansions.md,
    // "Coefficients of curved slopes").
    std::vector<Ball> I =
        terms < least_terms_of_disk ? std::vector<Ball>{} : coefficients_by_disk(last, terms);
    const std::vector<Ball> taylor = series_of_slope(last, a_, terms);
    for (std::size_t k = I.size(); k < terms; ++k) {
        I.push_back(coefficient(k, last, a_, taylor, true));
    }
    for (std::size_t k = 1; k < terms; k += 2) {
        I[k] = -I[k];
    }
    const Ball D = a_ + b_;
    std::vector<Ball> root{Ball(1, bits_)}; // of sqrt(1 - u/D) (DLMF 4.6.7)
    for (std::size_t k = 1; k < terms; ++k) {
        const long n = static_cast<long>(k);
        root.push_back(root.back() * (2 * n - 3) / (2 * n) / D);
    }
    const Ball scale = modulus_ / (Ball::pi(bits_) * 2) * sqrt(D);
    std::vector<Ball> c;
    for (std::size_t n = 0; n < terms; ++n) {
        Ball sum(0, bits_);
        for (std::size_t k = 0; k <= n; ++k) {
            sum += I[k] * root[n - k];
        }
        c.push_back(scale * sum);
    }
    return c;
}

std::vector<Ball> IntegratedContact::series_of_slope(std::size_t piece, const Ball& x,
                                                     std::size_t terms) const {
    return slope_series(profile_.pieces()[piece].slope, x, terms, bits_);
}

Ball IntegratedContact::pressure(Edge edge, const formula::Exact& u) const {
    const Ball from_edge = enclosed_constant(u, bits_);
    const Ball other = a_ + b_ - from_edge;
    if (certainly_negative(from_edge) || certainly_negative(other)) {
        throw DomainError("a point lies outside the contact");
    }
    const Ball x = edge == Edge::right ? a_ - from_edge : from_edge - b_;
    Ball unknown(0, bits_);
    arb_indeterminate(unknown.data());
    // The piece that contains x. On a knot where g' only bends, both pieces give the same value.
    std::size_t piece = 0;
    std::optional<std::size_t> on_knot;
    for (std::size_t i = 0; i < knots_.size(); ++i) {
        if (certainly_less(knots_[i], x)) {
            piece = i + 1;
        } else if (!certainly_less(x, knots_[i])) {
            const bool given = known(edge).has_value();
            const formula::Expr& a = load_.value.expr();
            const formula::Expr exactly = edge == Edge::right ? a - u.expr() : u.expr() - a;
            if (profile_.has_corner(i) || !given ||
                !certainly_zero(exactly - profile_.knots()[i].expr())) {
                return unknown;
            }
            on_knot = i;
            piece = i;
        }
    }
    const Ball slope = series_of_slope(piece, x, 1)[0];
    Ball sum(0, bits_);
    for (const quadrature::ThetaSpan& span : spans(a_, b_)) {
        SlopeIntegrand f = integrand(span, a_, b_);
        // Each of two pieces that meet at x is evaluated by its own expression; their values at x
        // are equal.
        const Ball here =
            on_knot && span.piece == *on_knot + 1 ? series_of_slope(span.piece, x, 1)[0] : slope;
        f.x = &x;
        f.slope_at_x = &here;
        f.holds_x = span.piece == piece || (on_knot && span.piece == *on_knot + 1);
        sum += integrate(f, span, bits_);
    }
    // eqn:SIEPressure regularised (docs/curved-slopes.md, "What is integrated")
    return modulus_ / (Ball::pi(bits_) * 2) * sqrt(from_edge * other) * sum;
}

std::vector<quadrature::ThetaSpan> IntegratedContact::piece_spans(const Ball& a,
                                                                  const Ball& b) const {
    // The order is from the right, where theta = 0. A knot that may lie on an edge is set to that
    // edge.
    std::vector<quadrature::ThetaSpan> list;
    Ball from(0, bits_);
    for (std::size_t i = knots_.size() + 1; i-- > 0;) {
        const auto here = i > 0 ? on_edge_[i - 1] : std::optional<Edge>(Edge::left);
        const Mark<Ball> next =
            here ? end_mark(Extent<Ball>{a, b}, *here) : clamped_mark({a, b}, knots_[i - 1]);
        if (i > 0 && next.end == Edge::right) {
            continue;
        }
        list.push_back({.piece = i, .from = from, .to = next.h, .formula = i});
        from = next.h;
        if (next.end) {
            break;
        }
    }
    return list;
}

const IntegratedContact::Roots& IntegratedContact::roots() const {
    if (!roots_) {
        Roots found;
        for (const SlopePiece& piece : profile_.pieces()) {
            found.formulas.push_back(piece.slope);
        }
        for (std::size_t i = 0; i < profile_.knots().size(); ++i) {
            std::array<Roots::Root, 2> sides;
            for (const std::size_t side : {0U, 1U}) {
                const SlopePiece& piece = profile_.pieces()[i + side];
                auto root_form =
                    piece.linear
                        ? std::nullopt
                        : slope_at_root(piece.slope, profile_.knots()[i].expr(), side == 1);
                if (root_form) {
                    sides.at(side) = {found.formulas.size(), root_form->root};
                    found.formulas.push_back(std::move(root_form->slope));
                }
            }
            found.of_knots.push_back(sides);
        }
        roots_ = std::make_shared<const Roots>(std::move(found));
    }
    return *roots_;
}

// docs/curved-slopes.md, "What is integrated": a branch point on a knot, |s - v| = w^n.
std::vector<quadrature::ThetaSpan> IntegratedContact::spans(const Ball& a, const Ball& b) const {
    const Ball centre = (a - b) / 2;
    const Ball half = (a + b) / 2;
    std::vector<quadrature::ThetaSpan> list;
    for (const quadrature::ThetaSpan& whole : piece_spans(a, b)) {
        Ball middle((whole.from + whole.to) / 2);
        arb_get_mid_arb(middle.data(), middle.data());
        const Ball s = centre + half * cos(middle);
        // Next to the knot at the right end of the piece, and next to the knot at its left end.
        const auto rooted = [&](std::size_t knot, std::size_t side) {
            const Roots::Root& root = roots().of_knots[knot].at(side);
            const Ball distance = side == 0 ? knots_[knot] - s : s - knots_[knot];
            std::optional<quadrature::ThetaSpan> span;
            if (root.root != 0 && certainly_less(knots_[knot], a) &&
                certainly_less(-b, knots_[knot]) && certainly_positive(distance)) {
                span = {.piece = whole.piece,
                        .from = Ball(0, bits_),
                        .to = pow(distance, Rational(1, root.root)),
                        .formula = root.formula,
                        .root = root.root,
                        .side = side == 0 ? -1 : 1,
                        .knot = knots_[knot]};
            }
            return span;
        };
        const auto right = whole.piece < knots_.size() ? rooted(whole.piece, 0) : std::nullopt;
        const auto left = whole.piece > 0 ? rooted(whole.piece - 1, 1) : std::nullopt;
        if (!right && !left) {
            list.push_back(whole);
            continue;
        }
        quadrature::ThetaSpan part = whole;
        part.to = middle;
        list.push_back(right ? *right : part);
        part.from = middle;
        part.to = whole.to;
        list.push_back(left ? *left : part);
    }
    return list;
}

SlopeIntegrand IntegratedContact::integrand(const quadrature::ThetaSpan& span, const Ball& a,
                                            const Ball& b) const {
    return {&profile_.pieces()[span.piece].slope, &roots().formulas[span.formula], (a - b) / 2,
            (a + b) / 2};
}

} // namespace edgeproof::contact
