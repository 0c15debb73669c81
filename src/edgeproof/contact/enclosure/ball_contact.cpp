// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_contact.hpp"

#include "edgeproof/contact/enclosure/ball_marks.hpp"
#include "edgeproof/contact/enclosure/exact_edges.hpp"
#include "edgeproof/formula/evaluate.hpp"
#include "edgeproof/formula/exact/identity.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <optional>

namespace edgeproof::contact {
namespace {

/// How a zero is searched for.
struct Search {
    bool prove = true;     ///< without, only the place that the search came to
    bool nested = false;   ///< the function is itself solved for: known to fewer bits
    int most_stalls = 400; ///< steps that lead nowhere, before the search ends
};

Ball middle(const Ball& x) { return {x.midpoint(), x.bits()}; }

/// A zero of f, which is monotone on the positive axis, by the interval form of Newton's method:
/// when middle - f(middle)/f'(X) lies inside X, there is exactly one zero in X, and it lies there.
/// f(x) > 0 is to mean that the zero lies beyond x; `rate` encloses f' (of one sign) over a ball.
template <class F, class Rate>
Ball isolate_zero(const F& f, const Rate& rate, const Ball& start, const char* what,
                  const Search& search) {
    const long bits = start.bits();
    Ball x = middle(start);
    // Walk until a sign change is certain, then Newton on midpoints: none of this proves anything.
    std::optional<Ball> lo;
    std::optional<Ball> hi;
    long factor = 2;
    for (int k = 0; k < 64 && !(lo && hi); ++k) {
        const Ball value = f(x);
        if (certainly_positive(value)) {
            lo = x;
            x = middle(x * factor);
        } else if (certainly_negative(value)) {
            hi = x;
            x = middle(x / factor);
        } else {
            break;
        }
        factor = factor < (1L << 30) ? factor * factor : factor;
    }
    if (lo && hi) {
        x = middle(sqrt(*lo * *hi));
    }
    Ball step(0, bits);
    const long wanted = search.nested && !search.prove ? bits / 2 : bits - 12;
    const Ball tiny(Rational(Integer(1), Integer(Integer(1) << static_cast<unsigned>(wanted))),
                    bits);
    const Ball noise(
        Rational(Integer(1), Integer(Integer(1) << static_cast<unsigned>(bits / 8 * 3))), bits);
    int stalls = 0;
    std::optional<Ball> previous;
    for (int k = 0; k < 400; ++k) {
        const Ball value = middle(f(x));
        if (certainly_positive(value)) {
            lo = x;
        } else if (certainly_negative(value)) {
            hi = x;
        }
        step = middle(value / rate(x));
        // No step where the rate may be zero (an edge on the end of a flat): halve instead. So too
        // where steps do not shrink: beside a corner f goes like a root, and Newton's method to and
        // fro.
        Ball next = step.is_finite() ? middle(x - step) : x;
        const bool inside = step.is_finite() && (!lo || certainly_less(*lo, next)) &&
                            (!hi || certainly_less(next, *hi)) && certainly_positive(next);
        if (inside && !certainly_less(tiny * abs(x), abs(step))) {
            x = next;
            break;
        }
        const bool slow = inside && previous && !certainly_less(abs(step) * 2, *previous);
        // Beside a knot f has half the bits, and fewer where it is itself solved for.
        stalls += (slow || !inside) && certainly_less(abs(step), noise * abs(x)) ? 1 : 0;
        if (stalls > search.most_stalls) {
            break;
        }
        if ((!inside || slow) && lo && hi) {
            next = middle(sqrt(*lo * *hi));
            previous = std::nullopt;
        } else if (!inside) {
            break;
        } else {
            previous = abs(step);
        }
        x = next;
    }
    if (!search.prove) {
        return x;
    }
    // The proof.
    Ball radius = abs(x) * tiny;
    if (step.is_finite()) {
        radius += abs(step) * 4;
    }
    for (long k = 0; 5 * k < bits; ++k) {
        const Ball candidate = Ball::around(x.midpoint(), radius.upper(), bits);
        const Ball image = x - f(x) / rate(candidate);
        if (image.is_finite() && certainly_positive(image) && contains(candidate, image)) {
            return image;
        }
        radius = middle(radius * 32);
    }
    throw BudgetError(std::string("ball arithmetic at ") + std::to_string(bits) +
                      " bits does not isolate " + what);
}

} // namespace

bool BallContact::has_closed_form(const Profile& profile) {
    return profile.piecewise_linear() || profile.kind() == Profile::Kind::power_law;
}

Ball BallContact::constant(const formula::Expr& e) const { return enclosed_constant(e, bits_); }

BallContact::BallContact(const Profile& profile, const formula::Exact& contact_modulus,
                         const Load& load, long bits)
    : BallContact(profile, enclosed_constant(contact_modulus, bits), bits) {
    if (load.kind == Load::Kind::right_edge) {
        known_a_ = load.value;
        find_knots_on_edges();
    }
    solve(contact_modulus, load);
}

BallContact::BallContact(const Profile& profile, const formula::Exact& contact_modulus,
                         const ExactEdges& edges, long bits)
    : BallContact(profile, enclosed_constant(contact_modulus, bits), bits) {
    lie_at(edges);
    fix();
}

void BallContact::lie_at(const ExactEdges& edges) {
    known_a_ = edges.a;
    known_b_ = edges.b;
    a_ = constant(edges.a.expr());
    b_ = constant(edges.b.expr());
    find_knots_on_edges();
}

BallContact::BallContact(const Profile& near, const Ball& alpha,
                         const formula::Exact& contact_modulus, const Load& load, long bits)
    : BallContact(near, enclosed_constant(contact_modulus, bits), bits) {
    tilt_by(alpha);
    const Ball given = constant(load.value.expr());
    a_ = load.kind == Load::Kind::right_edge ? given : solve_right_edge_for_force(given);
    b_ = solve_left_edge(a_);
    fix();
}

void BallContact::solve(const formula::Exact& contact_modulus, const Load& load) {
    const Ball given = constant(load.value.expr());
    bool isolated = true;
    try {
        a_ = known_a_ ? given : solve_right_edge_for_force(given);
        b_ = solve_left_edge(a_);
    } catch (const BudgetError&) {
        isolated = false; // too few bits; or an edge on a corner, where no number of them will do
    }
    if (!isolated || edge_may_be_on_knot()) {
        if (!isolated) {
            a_ = known_a_ ? given : solve_right_edge_for_force(given, false);
            b_ = solve_left_edge(a_, false);
        }
        if (const auto exact = exact_edges(profile_, contact_modulus, load, a_, b_)) {
            lie_at(*exact);
        } else if (!isolated) {
            throw BudgetError("ball arithmetic at " + std::to_string(bits_) +
                              " bits does not isolate the edges");
        }
    }
    fix();
}

/// Of the edges that are solved for.
bool BallContact::edge_may_be_on_knot() const {
    for (std::size_t i = 0; i < knots_.size(); ++i) {
        if (!bends(i) || power_law_) {
            continue;
        }
        if ((!known_a_ && overlaps(knots_[i], a_)) ||
            (!known(Edge::left) && overlaps(-knots_[i], b_))) {
            return true;
        }
    }
    return false;
}

/// The knot at which a flat that the minimum is ends.
std::optional<std::size_t> BallContact::flat_end(Edge edge) const {
    const bool right = edge == Edge::right;
    std::optional<std::size_t> end;
    std::size_t knot = profile_.origin();
    for (;;) {
        const auto& slope = profile_.pieces()[right ? knot + 1 : knot].linear;
        const Rational* at_origin = slope->at_origin.rational();
        const Rational* rate = slope->rate.rational();
        if (at_origin == nullptr || rate == nullptr || *at_origin != 0 || *rate != 0 ||
            knot == (right ? knots_.size() - 1 : 0)) {
            return end;
        }
        knot = right ? knot + 1 : knot - 1;
        end = knot;
    }
}

/// g' of Profile::tilted_wedge and Profile::tilted_flat_and_rounded, alpha > 0 in the latter.
void BallContact::tilt_by(const Ball& alpha) {
    const auto given = [&](const char* name) {
        return constant(profile_.parameters().at(name).expr());
    };
    if (profile_.kind() == Profile::Kind::tilted_wedge) {
        pieces_[0].at_origin = -(given("phi") + alpha);
        pieces_[1].at_origin = given("phi") - alpha;
    } else if (profile_.kind() == Profile::Kind::tilted_flat_and_rounded && knots_.size() == 3) {
        const Ball flat_end = -(alpha * given("R"));
        knots_[0] = flat_end - given("t") * 2;
        knots_[1] = flat_end;
        pieces_[1].at_origin = -alpha;
    } else {
        throw DomainError("only a tilted wedge or a tilted flat has a tilt");
    }
    find_jumps();
}

BallContact::BallContact(const Profile& profile, const Ball& modulus, long bits)
    : profile_(profile), bits_(bits), modulus_(modulus) {
    if (!has_closed_form(profile)) {
        throw DomainError("only a piecewise linear slope or a power law has a closed form");
    }
    read_profile();
}

bool certainly_zero(const formula::Expr& e) { return decided_sign(e) == 0; }

bool BallContact::bends(std::size_t knot) const {
    const auto& before = profile_.pieces()[knot].linear;
    const auto& after = profile_.pieces()[knot + 1].linear;
    return power_law_ || !(before->rate == after->rate) || !(before->at_origin == after->at_origin);
}

void BallContact::find_knots_on_edges() {
    for (std::size_t i = 0; i < knots_.size(); ++i) {
        const formula::Expr knot = profile_.knots()[i].expr();
        if (known_a_ && overlaps(knots_[i], constant(known_a_->expr())) &&
            certainly_zero(known_a_->expr() - knot)) {
            on_edge_[i] = Edge::right;
        } else if (const auto& b = known(Edge::left); b &&
                                                      overlaps(-knots_[i], constant(b->expr())) &&
                                                      certainly_zero(b->expr() + knot)) {
            on_edge_[i] = Edge::left;
        }
    }
}

BallMark BallContact::mark(const Ball& a, const Ball& b, std::size_t knot) const {
    if (on_edge_[knot]) {
        return *on_edge_[knot] == Edge::right ? BallMark::right_end(a, b)
                                              : BallMark::left_end(a, b);
    }
    return BallMark::at(a, b, knots_[knot]);
}

BallContact BallContact::with_right_edge(const Ball& a) const {
    BallContact other(*this);
    other.known_a_.reset();
    other.known_b_.reset();
    std::fill(other.on_edge_.begin(), other.on_edge_.end(), std::nullopt);
    other.a_ = a;
    other.b_ = other.solve_left_edge(a);
    other.fix();
    return other;
}

BallContact BallContact::mirrored() const {
    BallContact m(profile_.reflected(), modulus_, bits_);
    m.a_ = b_;
    m.b_ = a_;
    m.known_a_ = known(Edge::left);
    m.known_b_ = known_a_;
    // A tilt that is known by a ball is in these, and not in the profile.
    for (std::size_t i = 0; i < knots_.size(); ++i) {
        m.knots_[i] = -knots_[knots_.size() - 1 - i];
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const Piece& p = pieces_[pieces_.size() - 1 - i];
        m.pieces_[i] = {-p.at_origin, p.rate};
    }
    if (!power_law_) {
        m.find_jumps();
    }
    for (std::size_t i = 0; i < on_edge_.size(); ++i) {
        if (on_edge_[i]) {
            m.on_edge_[on_edge_.size() - 1 - i] = opposite(*on_edge_[i]);
        }
    }
    m.fix();
    return m;
}

void BallContact::read_profile() {
    const Profile& profile = profile_;
    for (const formula::Exact& knot : profile.knots()) {
        knots_.push_back(constant(knot.expr()));
    }
    on_edge_.assign(knots_.size(), std::nullopt);
    power_law_ = !profile.piecewise_linear();
    if (power_law_) {
        const formula::Exact& m = profile.parameters().at("m");
        exponent_ = constant(m.expr());
        power_law_integral_.emplace(m, exponent_);
        const Ball C = constant(profile.parameters().at("C").expr());
        // moore-hills.tex, line 144: E* C (sqrt(pi)/2) Gamma(1 + m/2)/Gamma((3 + m)/2).
        power_factor_ = modulus_ * C * sqrt(Ball::pi(bits_)) / 2 * gamma(exponent_ / 2 + 1) /
                        gamma((exponent_ + 3) / 2);
    } else {
        for (const SlopePiece& piece : profile.pieces()) {
            pieces_.push_back({constant(piece.linear->at_origin), constant(piece.linear->rate)});
        }
        find_jumps();
    }
}

void BallContact::find_jumps() {
    jumps_.clear();
    for (std::size_t i = 0; i < knots_.size(); ++i) {
        const auto at = [&](const Piece& p) { return p.at_origin + p.rate * knots_[i]; };
        jumps_.push_back(profile_.has_corner(i) ? at(pieces_[i + 1]) - at(pieces_[i])
                                                : Ball(0, bits_));
    }
}

template <class AtKnot, class Between>
Ball BallContact::over_measure(const Ball& a, const Ball& b, const AtKnot& at_knot,
                               const Between& between) const {
    // Marks are clamped to the contact: a knot outside falls onto the edge, where the kernels
    // vanish, so that a ball of b that straddles a knot needs no case of its own.
    Ball sum(0, bits_);
    BallMark previous = BallMark::left_end(a, b);
    for (std::size_t i = 0; i <= knots_.size(); ++i) {
        const BallMark next = i < knots_.size() ? mark(a, b, i) : BallMark::right_end(a, b);
        sum += pieces_[i].rate * between(i, previous, next);
        if (i < knots_.size() && profile_.has_corner(i)) {
            sum += at_knot(i, next);
        }
        previous = next;
    }
    return sum;
}

Ball BallContact::imbalance(const Ball& a, const Ball& b) const {
    const std::size_t o = profile_.origin();
    const Ball pi = Ball::pi(bits_);
    return over_measure(
        a, b,
        [&](std::size_t i, const BallMark& m) {
            if (i != o) {
                return i > o ? jumps_[i] * m.h : -(jumps_[i] * (pi - m.h));
            }
            // g'(0+) weighs on the right, -g'(0-) on the left.
            return pieces_[i + 1].at_origin * m.h + pieces_[i].at_origin * (pi - m.h);
        },
        [&](std::size_t i, const BallMark& m, const BallMark& n) {
            if (i > o) {
                return n.y * n.h - m.y * m.h + m.w - n.w;
            }
            return -(n.y * (pi - n.h) - m.y * (pi - m.h) + n.w - m.w);
        });
}

Ball BallContact::force_of(const Ball& a, const Ball& b) const {
    const Ball d = (a + b) / 2;
    return modulus_ / 2 *
           over_measure(
               a, b, [&](std::size_t i, const BallMark& m) { return jumps_[i] * m.w; },
               [&](std::size_t, const BallMark& m, const BallMark& n) {
                   return (n.y * n.w - m.y * m.w + d * d * (m.h - n.h)) / 2;
               });
}

Ball BallContact::force_rate_of(const Ball& a, const Ball& b, Edge edge) const {
    const Ball d = (a + b) / 2;
    const bool right = edge == Edge::right;
    return modulus_ / 2 *
           over_measure(
               a, b,
               [&](std::size_t i, const BallMark& m) {
                   if (m.outside) {
                       return Ball(0, bits_);
                   }
                   return jumps_[i] * (right ? m.left / m.w : m.right / m.w);
               },
               [&](std::size_t, const BallMark& m, const BallMark& n) {
                   const Ball arc = d * (m.h - n.h);
                   return right ? m.w - n.w + arc : n.w - m.w + arc;
               });
}

Ball BallContact::solve_left_edge(const Ball& a, bool prove) const {
    if (profile_.symmetric()) {
        return a;
    }
    const Ball origin(0, bits_);
    const auto left_end = flat_end(Edge::left);
    if (left_end && known_a_ && prove) {
        try {
            return left_edge_from(origin, a, a, prove);
        } catch (const BudgetError&) {
            // As its distance from the end of the flat, below.
        }
    }
    const auto right_end = flat_end(Edge::right);
    const Ball inset = right_end ? a - knots_[*right_end] : a;
    return left_edge_from(left_end ? -knots_[*left_end] : origin,
                          certainly_positive(inset) ? inset : a, a, prove);
}

// Where the minimum is a flat, an edge is solved for as its distance from the end of the flat: on
// the flat itself nothing tells where it would be.
Ball BallContact::left_edge_from(const Ball& end, const Ball& start, const Ball& a,
                                 bool prove) const {
    return end + isolate_zero(
                     [&](const Ball& y) { return imbalance(a, end + y); },
                     [&](const Ball& y) {
                         const Ball b = end + y;
                         return -(force_rate_of(a, b, Edge::left) / modulus_ * 2 / (a + b));
                     },
                     start, "the left edge", {.prove = prove, .most_stalls = known_a_ ? 400 : 40});
}

Ball BallContact::solve_right_edge_for_force(const Ball& P, bool prove) const {
    if (power_law_) {
        return pow(P / power_factor_, 1 / (exponent_ + 1));
    }
    const auto end = flat_end(Edge::right);
    const Ball L = end ? knots_[*end] : Ball(0, bits_);
    // Any start will do: the length that the force would indent.
    return L + isolate_zero(
                   [&](const Ball& z) {
                       const Ball a = L + z;
                       return P - force_of(a, solve_left_edge(a, prove));
                   },
                   [&](const Ball& z) {
                       const Ball a = L + z;
                       return -force_rate_of(a, solve_left_edge(a, prove), Edge::right);
                   },
                   P / modulus_, "the right edge",
                   {.prove = prove, .nested = true, .most_stalls = 40});
}

Ball BallContact::force() const {
    return power_law_ ? power_factor_ * pow(a_, exponent_ + 1) : force_of(a_, b_);
}

Ball BallContact::force_rate() const {
    return power_law_ ? power_factor_ * (exponent_ + 1) * pow(a_, exponent_)
                      : force_rate_of(a_, b_, Edge::right);
}

Ball BallContact::left_force_rate() const {
    return profile_.symmetric() ? force_rate() : force_rate_of(a_, b_, Edge::left);
}

Ball BallContact::moment() const {
    if (profile_.symmetric()) {
        return {0, bits_};
    }
    const Ball d = (a_ + b_) / 2;
    const Ball offset = a_ - b_;
    return modulus_ / 4 *
           over_measure(
               a_, b_,
               [&](std::size_t i, const BallMark& m) { return jumps_[i] * m.w * (m.y + offset); },
               [&](std::size_t, const BallMark& m, const BallMark& n) {
                   return (m.w * m.w * m.w - n.w * n.w * n.w) / 3 +
                          offset * (n.y * n.w - m.y * m.w + d * d * (m.h - n.h)) / 2;
               });
}

} // namespace edgeproof::contact
