// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/witness/edge_equations.hpp"

#include "edgeproof/precision/error.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cstdint>
#include <exception>

namespace edgeproof::contact::witness {
namespace {

constexpr unsigned rough_digits = 20; ///< of the search from which Newton's steps start
const char* const rough_accuracy = "1e-5";
constexpr int most_steps = 40;
constexpr int most_doublings = 12;   ///< of the exponent of the factor in a search
constexpr unsigned spare_digits = 6; ///< by which a quadrature stops before roundoff

/// The place x > 0, to `relative`, at which a falling f changes its sign; the search begins at
/// `start`. A place where f has no value counts as too far out.
template <class F> Real zero_of_falling(const F& f, const Real& start, const Real& relative) {
    std::exception_ptr failure;
    const auto value = [&](const Real& x) {
        try {
            const Real y = f(x);
            return isfinite(y) ? y : Real(-1);
        } catch (const DomainError&) {
            failure = std::current_exception();
        } catch (const BudgetError&) {
            failure = std::current_exception();
        }
        return Real(-1);
    };
    Real lo = start;
    Real hi = start;
    Real f_lo = value(start);
    Real f_hi = f_lo;
    Real factor(2);
    for (int k = 0; k < most_doublings && (f_lo > 0) == (f_hi > 0); ++k, factor *= factor) {
        if (f_hi > 0) {
            lo = hi;
            f_lo = f_hi;
            hi = lo * factor;
            f_hi = value(hi);
        } else {
            hi = lo;
            f_hi = f_lo;
            lo = hi / factor;
            f_lo = value(lo);
        }
    }
    if ((f_lo > 0) == (f_hi > 0)) {
        if (failure) {
            std::rethrow_exception(failure);
        }
        throw DomainError("no position of the other edge closes this contact: the profile does not "
                          "rise on that side");
    }
    while (hi > 4 * lo) {
        const Real middle = sqrt(lo) * sqrt(hi);
        const Real f_middle = value(middle);
        (f_middle > 0 ? lo : hi) = middle;
        (f_middle > 0 ? f_lo : f_hi) = f_middle;
    }
    const auto narrow = [&](const Real& x, const Real& y) {
        return abs(Real(y - x)) <= relative * abs(x);
    };
    std::uintmax_t evaluations = 400; // at most (TOMS algorithm 748)
    return boost::math::tools::toms748_solve(value, lo, hi, f_lo, f_hi, narrow, evaluations).first;
}

/// The value of an integral on which an edge depends.
const Real& converged(const Integral& found) {
    if (!found.converged) {
        throw BudgetError("the quadrature over a piece of g' did not converge");
    }
    return found.value;
}

/// The integral of y^k/w between two places, y = s - c with the middle c of the contact.
Real power_over_w(const Place& l, const Place& r, const Real& between, const Ends& e, int k) {
    if (k == 0) {
        return 2 * atan2(Real(between * e.length()),
                         Real((sqrt(Real(l.right * r.left)) + sqrt(Real(r.right * l.left))) *
                              (sqrt(Real(l.left * r.left)) + sqrt(Real(l.right * r.right)))));
    }
    const auto at = [&](const Place& p) { // y^(k-1) w
        return Real(pow(Real((p.left - p.right) / 2), k - 1) * sqrt(Real(p.right * p.left)));
    };
    const Real lower =
        k == 1
            ? Real(0)
            : Real((k - 1) * e.length() * e.length() / 4 * power_over_w(l, r, between, e, k - 2));
    return (at(l) - at(r) + lower) / k;
}

} // namespace

unsigned digits_lost(const Real& whole, const Real& part) {
    constexpr double digits_a_bit = 0.30103;
    const auto bits = mpfr_get_exp(whole.backend().data()) - mpfr_get_exp(part.backend().data());
    return bits > 0 && part != 0
               ? static_cast<unsigned>(digits_a_bit * static_cast<double>(bits)) + 1
               : 0;
}

EdgeEquations::EdgeEquations(Profile profile, Exact contact_modulus)
    : profile_(std::move(profile)), exact_modulus_(std::move(contact_modulus)), slope_(profile_),
      modulus_(exact_modulus_.to<Real>()), target_digits_(working_digits() - spare_digits) {}

Place EdgeEquations::end(const Ends& e, Edge edge) {
    return edge == Edge::right ? Place{Real(0), e.length(), e.a}
                               : Place{e.length(), Real(0), Real(-e.b)};
}

EdgeEquations::Stretches EdgeEquations::stretches(const Ends& e, const Place& at) const {
    std::vector<Cut> list{{end(e, Edge::left), 0}};
    for (const Real& knot : slope_.knots()) {
        if (!(-knot < e.b)) {
            ++list[0].piece;
        } else if (knot < e.a) {
            list.push_back({{Real(e.a - knot), Real(e.b + knot), knot}, list.back().piece + 1});
        }
    }
    list.push_back({end(e, Edge::right), 0});
    // Places are compared by the distance from the edge that is nearer to `at`.
    const bool by_right = at.right < at.left;
    std::size_t own = 0;
    while (by_right ? list[own].at.right > at.right : list[own].at.left < at.left) {
        ++own;
    }
    if (by_right ? list[own].at.right != at.right : list[own].at.left != at.left) {
        const std::size_t piece = list[own - 1].piece;
        list.insert(list.begin() + static_cast<std::ptrdiff_t>(own), {at, piece});
    }
    std::vector<Real> lengths;
    for (std::size_t i = 0; i + 1 < list.size(); ++i) {
        const Place& l = list[i].at;
        const Place& r = list[i + 1].at;
        // The difference of the distances from the nearer edge, which cancels less.
        lengths.push_back(l.left < r.right ? Real(r.left - l.left) : Real(l.right - r.right));
    }
    return {std::move(list), std::move(lengths), own};
}

template <class F>
Integral EdgeEquations::over(const Stretches& list, std::size_t i, unsigned digits, const F& f) {
    const Place& l = list.cuts[i].at;
    const Place& r = list.cuts[i + 1].at;
    const auto integrand = [&](const Real& lo, const Real& hi) {
        // s from the nearer cut: near the origin, where |s|^m is steep, s is that distance.
        const Real s = lo < hi ? Real(l.x + lo) : Real(r.x - hi);
        return Real(f(s, lo, hi) / sqrt(Real((r.right + hi) * (l.left + lo))));
    };
    // The neighbouring cuts are singularities beyond the ends.
    return quadrature::integrate_near(
        integrand, list.lengths[i], i > 0 ? list.lengths[i - 1] : Real(0),
        i + 1 < list.lengths.size() ? list.lengths[i + 1] : Real(0), {.target_digits = digits});
}

Real EdgeEquations::slope_integral(const Ends& e, int k) const {
    const Stretches list = stretches(e, end(e, Edge::right));
    const Real c = (e.a - e.b) / 2;
    Real sum(0);
    for (std::size_t i = 0; i < list.lengths.size(); ++i) {
        const Cut& l = list.cuts[i];
        const auto& piece = slope_.pieces()[l.piece];
        if (piece.linear) {
            const auto by_hand = [&](int power) {
                return power_over_w(l.at, list.cuts[i + 1].at, list.lengths[i], e, power);
            };
            sum += (piece.at_origin + piece.rate * c) * by_hand(k) + piece.rate * by_hand(k + 1);
            continue;
        }
        sum +=
            converged(over(list, i, target_digits_, [&](const Real& s, const Real&, const Real&) {
                return Real(slope_.value(l.piece, s) * pow(Real(s - c), k));
            }));
    }
    return sum;
}

// moore-hills EQ22, with EQ20
Real EdgeEquations::force(const Ends& e) const { return modulus_ / 2 * slope_integral(e, 1); }
Real EdgeEquations::moment(const Ends& e) const {
    return profile_.symmetric()
               ? Real(0)
               : Real(modulus_ / 2 *
                      (slope_integral(e, 2) + (e.a - e.b) / 2 * slope_integral(e, 1)));
}

Real EdgeEquations::quotient(std::size_t piece, const Real& x, const Real& delta,
                             const Real& length) const {
    if (slope_.pieces()[piece].linear) {
        return slope_.pieces()[piece].rate;
    }
    // More digits for those that cancel.
    const PrecisionScope scope(working_digits() + digits_lost(length, delta));
    const Real from = at_working_precision(x);
    return Real((slope_.value(piece, Real(from + delta)) - slope_.value(piece, from)) / delta);
}

Integral EdgeEquations::difference_over(const Stretches& list, std::size_t i, const Ends& e,
                                        unsigned digits) const {
    const Real& x = list.cuts[list.own].at.x;
    const Real at_x = slope_.value(list.cuts[list.own > 0 ? list.own - 1 : 0].piece, x);
    const std::size_t piece = list.cuts[i].piece;
    const bool after = i >= list.own;
    const bool touches = i == list.own || i + 1 == list.own;
    // s - x as a sum of lengths. Their roundoff is the same at every node, so that the integrand is
    // smooth.
    Real gap(0);
    for (std::size_t k = after ? list.own : i + 1; k < (after ? i : list.own); ++k) {
        gap += list.lengths[k];
    }
    // Near a knot s is its distance from there: x + delta may round to a place beyond the knot.
    const std::size_t other = after ? i + 1 : i;
    const bool at_knot = other > 0 && other < list.lengths.size();
    return over(list, i, digits, [&](const Real& s, const Real& lo, const Real& hi) {
        const Real delta = after ? Real(gap + lo) : Real(-(gap + hi));
        return touches && !(at_knot && after == (hi < lo))
                   ? quotient(piece, x, delta, e.length())
                   : Real((slope_.value(piece, s) - at_x) / delta);
    });
}

Integral EdgeEquations::difference_integral(const Ends& e, const Place& at, unsigned digits) const {
    const Stretches list = stretches(e, at);
    Integral sum{Real(0), Real(0), 0, true};
    for (std::size_t i = 0; i < list.lengths.size(); ++i) {
        sum.add(difference_over(list, i, e, digits));
    }
    return sum;
}

// c_0 is the limit of p/sqrt(u) at the edge in moore-hills EQ01, and P' = (pi/2) c_0 sqrt(a + b)
// (moore-hills EQ03, EQ21).
Real EdgeEquations::rate(const Ends& e, Edge edge) const {
    const bool power = profile_.kind() == Profile::Kind::power_law;
    if (power && rate_of_power_) { // P' is homogeneous
        return rate_of_power_->second *
               pow(Real(e.a / rate_of_power_->first), profile_.parameters().at("m").to<Real>());
    }
    const Stretches list = stretches(e, end(e, edge));
    const Real& x = list.cuts[list.own].at.x;
    const Real at_x = slope_.value(list.cuts[list.own > 0 ? list.own - 1 : 0].piece, x);
    Real sum(0);
    for (std::size_t i = 0; i < list.lengths.size(); ++i) {
        const Place& l = list.cuts[i].at;
        const Place& r = list.cuts[i + 1].at;
        const auto& piece = slope_.pieces()[list.cuts[i].piece];
        if (!piece.linear) {
            sum += converged(difference_over(list, i, e, target_digits_));
            continue;
        }
        sum += piece.rate * power_over_w(l, r, list.lengths[i], e, 0);
        if (i != list.own && i + 1 != list.own) {
            // The integral of 1/((s - x) w)
            const Real pole =
                edge == Edge::right
                    ? Real(sqrt(Real(l.left / l.right)) - sqrt(Real(r.left / r.right)))
                    : Real(sqrt(Real(l.right / l.left)) - sqrt(Real(r.right / r.left)));
            sum += (piece.at_origin + piece.rate * x - at_x) * 2 / e.length() * pole;
        }
    }
    const Real found = modulus_ * e.length() / 4 * sum;
    if (power) {
        rate_of_power_.emplace(e.a, found);
    }
    return found;
}

std::optional<Ends> EdgeEquations::refined(Ends e, const Real* P) const {
    const Real eps = unit_roundoff<Real>();
    const Real enough = sqrt(eps);
    std::optional<Real> previous;
    try {
        for (int k = 0; k < most_steps; ++k) {
            const bool symmetric = profile_.symmetric();
            const Real C =
                symmetric ? Real(0) : Real(modulus_ * e.length() / 4 * slope_integral(e, 0));
            Real da(0);
            Real db(0);
            if (P != nullptr) {
                const Real missing = *P - force(e);
                da = (missing - C) / rate(e, Edge::right);
                db = symmetric ? da : Real((missing + C) / rate(e, Edge::left));
            } else {
                db = 2 * C / rate(e, Edge::left);
            }
            if (!(abs(da) < e.a / 2) || !(abs(db) < e.b / 2)) {
                return {};
            }
            e.a += da;
            e.b += db;
            const Real step = std::max(Real(abs(da) / e.a), Real(abs(db) / e.b));
            // The steps end where they no longer shrink.
            if (step <= 4 * eps || (previous && step <= enough && !(step < *previous / 2))) {
                return e;
            }
            previous = step;
        }
    } catch (const DomainError&) {
    } catch (const BudgetError&) {
    }
    return {};
}

// The integral of g'/w falls as the left edge moves outwards, and P grows with a along the contacts
// (docs/mechanics.md). The unknowns are the distances from the ends of a flat minimum.
Ends EdgeEquations::searched(const Real& value, bool by_force, const Real& relative) const {
    const auto flat_end = [&](Edge edge) {
        const auto knot = profile_.flat_end(edge);
        return knot ? Real(abs(slope_.knots()[*knot])) : Real(0);
    };
    const Real right = flat_end(Edge::right);
    const Real left = flat_end(Edge::left);
    Real start = by_force ? Real(value / modulus_) : Real(value - right);
    const auto with_left_edge = [&](const Real& a) {
        if (profile_.symmetric()) {
            return Ends{a, a};
        }
        if (a == right && right > 0) { // only the flat touches
            return Ends{a, left};
        }
        start = zero_of_falling(
            [&](const Real& y) {
                return slope_integral({a, Real(left + y)}, 0);
            },
            start > 0 ? start : a, relative);
        return Ends{a, Real(left + start)};
    };
    if (!by_force) {
        return with_left_edge(value);
    }
    return with_left_edge(
        right + zero_of_falling(
                    [&](const Real& z) { return Real(value - force(with_left_edge(right + z))); },
                    Real(start), relative));
}

Ends EdgeEquations::ends(const Load& load) const {
    const bool by_force = load.kind == Load::Kind::force;
    const Real value = load.value.to<Real>();
    if (!by_force && profile_.symmetric()) {
        return {value, value};
    }
    const Real* const P = by_force ? &value : nullptr;
    try {
        const Ends rough = [&] {
            const PrecisionScope scope(rough_digits);
            return EdgeEquations(profile_, exact_modulus_)
                .searched(load.value.to<Real>(), by_force, Real(rough_accuracy));
        }();
        const Ends start{by_force ? at_working_precision(rough.a) : value,
                         at_working_precision(rough.b)};
        if (auto e = refined(start, P)) {
            return *(last_ = std::move(e));
        }
    } catch (const DomainError&) {
        // More digits may find the edges, or show the reason.
    } catch (const BudgetError&) {
    }
    return *(last_ = searched(value, by_force, 1000 * unit_roundoff<Real>()));
}

Ends EdgeEquations::ends_at(const Real& a) const {
    if (profile_.symmetric()) {
        return {a, a};
    }
    const Ends start{a, last_ ? Real(last_->b * (a / last_->a)) : a};
    auto e = refined(start, nullptr);
    return *(last_ = e ? std::move(*e) : searched(a, false, 1000 * unit_roundoff<Real>()));
}

} // namespace edgeproof::contact::witness
