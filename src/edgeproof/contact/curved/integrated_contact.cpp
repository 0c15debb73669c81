// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/algebra/identity.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/exact_contact.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/contact/profile/slope.hpp"
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

/// True if the pieces on both sides of a knot are proved to be one formula, which has a Taylor
/// series at the knot.
bool one_formula(const Profile& profile, std::size_t knot) {
    const Expr& right = profile.pieces()[knot + 1].slope;
    if (profile.has_corner(knot) || !algebra::proved_zero(right - profile.pieces()[knot].slope)) {
        return false;
    }
    const std::vector<Ball> series =
        slope_series(right, enclosed_constant(profile.knots()[knot], slope_bits), 2, slope_bits);
    return std::ranges::all_of(series, [](const Ball& g) { return g.is_finite(); });
}

} // namespace

IntegratedContact::IntegratedContact(const Profile& profile, const Exact& contact_modulus,
                                     const Load& load, long bits)
    : PlaneContact(profile, enclosed_constant(contact_modulus, bits), bits), load_(load) {
    if (load.kind == Load::Kind::right_edge) {
        known_a_ = load.value;
        a_ = enclosed_constant(load.value, bits);
        find_knots_on_edges();
    }
    if (load.kind == Load::Kind::right_edge && profile.symmetric()) {
        b_ = a_;
    } else {
        enclose_edges();
    }
    check_reach(profile_, a_, b_);
}

Box IntegratedContact::over_spans(const Ball& a, const Ball& b,
                                  const SlopeOnSpan::Integrand& f) const {
    const long accuracy = goal_between(a, b, bits_);
    Box sum(bits_);
    for (const quadrature::ThetaSpan& span : spans(a, b)) {
        const SlopeOnSpan on{profile_.pieces()[span.piece].slope, roots().formulas[span.formula],
                             span, (a - b) / 2, (a + b) / 2};
        sum = sum + on.integral(f, accuracy, bits_);
    }
    return sum;
}

// docs/curved-slopes.md, "What is integrated".
Ball IntegratedContact::slope_integral(const Ball& a, const Ball& b, long harmonic) const {
    return over_spans(a, b,
                      [&](const SlopeOnSpan& on, const Box& t, const Box& s) {
                          return on.value(t, s) * on.cosine(harmonic, t, s);
                      })
        .real();
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

IntegratedContact IntegratedContact::mirrored() const {
    IntegratedContact other(*this);
    other.mirror();
    other.forget();
    other.roots_.reset();
    return other;
}

void IntegratedContact::forget() {
    disks_.clear();
    over_theta_.reset();
    field_data_.reset();
}

std::vector<Ball> IntegratedContact::expansion(Edge edge, std::size_t terms) const {
    if (edge == Edge::left && (zone_ || !profile_.symmetric())) {
        return mirrored().right_expansion(terms);
    }
    return right_expansion(terms);
}

// I_k (docs/expansions.md, "Coefficients of curved slopes").
Ball IntegratedContact::coefficient(const Ball& x, const std::vector<SlopeAt>& here,
                                    bool from_right_edge) const {
    return over_spans(a_, b_,
                      [&](const SlopeOnSpan& on, const Box& t, const Box& s) {
                          const auto own = std::ranges::find(here, on.span.piece, &SlopeAt::piece);
                          const bool holds_x = own != here.end();
                          return on.quotient(x, (holds_x ? *own : here.front()).taylor, holds_x,
                                             from_right_edge, t, s);
                      })
        .real();
}

Ball IntegratedContact::coefficient(std::size_t k, std::size_t piece, const Ball& x,
                                    bool from_right_edge) const {
    return coefficient(x, {{piece, series_of_slope(piece, x, k + 1)}}, from_right_edge);
}

std::vector<Ball> IntegratedContact::coefficients_by_disk(std::size_t piece,
                                                          std::size_t terms) const {
    // A disk is computed to about half of its working bits (disk_goal).
    const PressureDisk disk(over_theta(), piece, a_, gap_at(a_), terms, 2 * bits_ + 48);
    std::vector<Ball> I;
    if (disk.found()) {
        const BallSeries at = disk.at(Ball(0, bits_), terms);
        for (std::size_t k = 0; k < terms; ++k) {
            I.push_back(at[k].with_bits(bits_));
        }
    }
    return I;
}

std::optional<std::size_t> IntegratedContact::edge_piece(Edge edge) const {
    std::size_t piece = 0;
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        const Ball inwards = edge == Edge::right ? a_ - slope_.knots[i] : slope_.knots[i] + b_;
        if (on_edge_[i] != edge && bends(i) && contains_zero(inwards)) {
            return {};
        }
        const bool on_or_beyond = on_edge_[i] == edge || !certainly_positive(inwards);
        piece = on_or_beyond == (edge == Edge::left) ? i + 1 : piece;
    }
    return whole_piece(piece);
}

std::vector<Ball> IntegratedContact::right_expansion(std::size_t terms) const {
    const auto at_edge = edge_piece(Edge::right);
    if (!at_edge) {
        return std::vector<Ball>(terms, unknown_ball(bits_));
    }
    const std::size_t last = *at_edge;
    // p = (E*/(2 pi)) sqrt(u (D - u)) I(x), where I is the sum of I_k (-u)^k (docs/expansions.md,
    // "Coefficients of curved slopes").
    std::vector<Ball> I =
        terms < least_terms_of_disk ? std::vector<Ball>{} : coefficients_by_disk(last, terms);
    for (std::size_t k = I.size(); k < terms; ++k) {
        I.push_back(coefficient(k, last, a_, true));
    }
    for (std::size_t k = 1; k < terms; k += 2) {
        I[k] = -I[k];
    }
    const Ball D = a_ + b_;
    BallSeries rest(Ball(1, bits_), terms); // 1 - u/D
    if (terms > 1) {
        rest.set(1, -1 / D);
    }
    const Ball scale = modulus_ / (Ball::pi(bits_) * 2) * sqrt(D);
    return (BallSeries(I) * sqrt(rest) * scale).coefficients();
}

std::vector<Ball> IntegratedContact::series_of_slope(std::size_t piece, const Ball& x,
                                                     std::size_t terms) const {
    return slope_series(profile_.pieces()[piece].slope, x, terms, bits_);
}

Ball IntegratedContact::pressure(Edge edge, const Exact& u) const {
    const Ball from_edge = enclosed_constant(u, bits_);
    const Ball other = a_ + b_ - from_edge;
    if (certainly_negative(from_edge) || certainly_negative(other)) {
        throw DomainError("a point lies outside the contact");
    }
    const Ball x = edge == Edge::right ? a_ - from_edge : from_edge - b_;
    if (const auto piece = piece_of(x)) {
        return pressure_at(from_edge, x, *piece, {});
    }
    if (const auto a = known(edge)) {
        const Expr exactly = edge == Edge::right ? a->expr() - u.expr() : u.expr() - a->expr();
        if (const auto knot = knot_at(Exact(exactly))) {
            return pressure_at_knot(from_edge, *knot);
        }
    }
    return unknown_ball(bits_);
}

Ball IntegratedContact::pressure(Edge edge, const Ball& u, const Exact& x) const {
    const auto knot = knot_at(x);
    return knot ? pressure_at_knot(u, *knot) : pressure(edge, u);
}

std::optional<std::size_t> IntegratedContact::knot_at(const std::optional<Exact>& x) const {
    for (std::size_t i = 0; x && i < slope_.knots.size(); ++i) {
        if (inside(i) && !profile_.has_corner(i) &&
            overlaps(enclosed_constant(*x, bits_), slope_.knots[i]) &&
            certainly_zero(x->expr() - profile_.knots()[i].expr())) {
            return i;
        }
    }
    return {};
}

Ball IntegratedContact::pressure_at(const Ball& from_edge, const Ball& x, std::size_t piece,
                                    const std::optional<std::size_t>& on_knot) const {
    const Ball other = a_ + b_ - from_edge;
    std::vector<SlopeAt> here{{piece, series_of_slope(piece, x, 1)}};
    if (on_knot) { // each of two pieces that meet at x is evaluated by its own expression
        const std::size_t other_piece = whole_piece(*on_knot + 1);
        here.push_back({other_piece, series_of_slope(other_piece, x, 1)});
    }
    // eqn:SIEPressure regularised (docs/curved-slopes.md, "What is integrated")
    return modulus_ / (Ball::pi(bits_) * 2) * sqrt(from_edge * other) * coefficient(x, here, false);
}

std::vector<quadrature::ThetaSpan> IntegratedContact::piece_spans(const Ball& a,
                                                                  const Ball& b) const {
    // The order is from the right, where theta = 0. A knot that may lie on an edge is set to that
    // edge.
    std::vector<quadrature::ThetaSpan> list;
    Ball from(0, bits_);
    for (std::size_t i = slope_.knots.size() + 1; i-- > 0;) {
        const auto here = i > 0 ? on_edge_[i - 1] : std::optional<Edge>(Edge::left);
        const Mark<Ball> next =
            here ? end_mark(Extent<Ball>{a, b}, *here) : clamped_mark({a, b}, slope_.knots[i - 1]);
        if (i > 0 && (next.end == Edge::right || (!next.end && !bends(i - 1)))) {
            continue;
        }
        const std::size_t whole = whole_piece(i);
        list.push_back({.piece = whole, .from = from, .to = next.h, .formula = whole});
        from = next.h;
        if (next.end) {
            break;
        }
    }
    return list;
}

bool IntegratedContact::bends(std::size_t knot) const { return roots().bends[knot]; }

std::size_t IntegratedContact::whole_piece(std::size_t piece) const {
    while (piece < slope_.knots.size() && !bends(piece)) {
        ++piece;
    }
    return piece;
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
            found.bends.push_back(!one_formula(profile_, i) || sides[0].root != 0 ||
                                  sides[1].root != 0);
        }
        roots_ = std::make_shared<const Roots>(std::move(found));
    }
    return *roots_;
}

// docs/curved-slopes.md, "What is integrated": a branch point on a knot, |s - v| = w^n.
std::vector<quadrature::ThetaSpan> IntegratedContact::spans(const Ball& a, const Ball& b,
                                                            const std::optional<Ball>& cut) const {
    const Ball centre = (a - b) / 2;
    const Ball half = (a + b) / 2;
    std::vector<quadrature::ThetaSpan> list;
    std::vector<quadrature::ThetaSpan> pieces = piece_spans(a, b);
    std::optional<std::size_t> after; // the piece that begins at the cut
    for (std::size_t i = 0; cut && !after && i < pieces.size(); ++i) {
        if (certainly_less(pieces[i].from, *cut) && certainly_less(*cut, pieces[i].to)) {
            pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(i), pieces[i]);
            pieces[i].to = *cut;
            pieces[i + 1].from = *cut;
            after = i + 1;
        }
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const quadrature::ThetaSpan& whole = pieces[i];
        const Ball between = middle((whole.from + whole.to) / 2);
        const Ball s = centre + half * cos(between);
        // Next to the knot at the right end of the piece, and next to the knot at its left end.
        const auto rooted = [&](std::size_t knot, std::size_t side) {
            const Roots::Root& root = roots().of_knots[knot].at(side);
            const Ball distance = side == 0 ? slope_.knots[knot] - s : s - slope_.knots[knot];
            std::optional<quadrature::ThetaSpan> span;
            if (root.root != 0 && certainly_less(slope_.knots[knot], a) &&
                certainly_less(-b, slope_.knots[knot]) && certainly_positive(distance)) {
                span = {.piece = whole.piece,
                        .from = Ball(0, bits_),
                        .to = pow(distance, Rational(1, root.root)),
                        .formula = root.formula,
                        .root = root.root,
                        .side = side == 0 ? -1 : 1,
                        .knot = slope_.knots[knot]};
            }
            return span;
        };
        const auto right =
            whole.piece < slope_.knots.size() && after != i ? rooted(whole.piece, 0) : std::nullopt;
        std::size_t last = whole.piece; // at the left end
        while (last > 0 && !bends(last - 1)) {
            --last;
        }
        const auto left = last > 0 && after != i + 1 ? rooted(last - 1, 1) : std::nullopt;
        if (!right && !left) {
            list.push_back(whole);
            continue;
        }
        quadrature::ThetaSpan part = whole;
        part.to = between;
        list.push_back(right ? *right : part);
        part.from = between;
        part.to = whole.to;
        list.push_back(left ? *left : part);
    }
    return list;
}

} // namespace edgeproof::contact
