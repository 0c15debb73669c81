// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/linear_contact.hpp"

#include "edgeproof/contact/enclosure/zone_equations.hpp"

namespace edgeproof::contact {
namespace {

/// The mark of a knot that is not certainly outside. If it is inside for some parameters of the box
/// and outside for others, every member is continuous there, since a knot outside has the mark of
/// the edge, at the distances 0 and a + b from the edges. Derivatives are not continuous: a series
/// is then not finite.
Mark<Ball> mark_inside(const Ball& length, Ball right, Ball left) {
    if (!certainly_positive(right) || !certainly_positive(left)) {
        Ball& far = contains_zero(left) ? right : left;
        far = Ball::hull(far, length);
    }
    return mark_between(right, left);
}
Mark<BallSeries> mark_inside(const BallSeries& /*length*/, const BallSeries& right,
                             const BallSeries& left) {
    return mark_between(right, left);
}

} // namespace

template <class T> std::vector<Mark<T>> LinearContact<T>::marks(const Extent<T>& e) const {
    std::vector<Mark<T>> all;
    for (const T& knot : slope.knots) {
        const T right = e.a - knot;
        const T left = e.b + knot;
        if (certainly_negative(value_in(right))) {
            all.push_back(right_end(e));
        } else if (certainly_negative(value_in(left))) {
            all.push_back(left_end(e));
        } else {
            all.push_back(mark_inside(e.length(), right, left));
        }
    }
    return all;
}

template <class T> T LinearContact<T>::imbalance(const Extent<T>& e) const {
    return linear_imbalance(slope, e, marks(e));
}

template <class T> T LinearContact<T>::imbalance_rate(const Extent<T>& e) const {
    return -(over_linear_measure<LeftRateKernel>(slope, e, marks(e)) / e.length());
}

template <class T> T LinearContact<T>::force(const Extent<T>& e) const {
    return Field<T>::over(modulus, 2) * over_linear_measure<ForceKernel>(slope, e, marks(e));
}

template <class T> T LinearContact<T>::force_rate(const Extent<T>& e) const {
    return Field<T>::over(modulus, 2) * over_linear_measure<RightRateKernel>(slope, e, marks(e));
}

template <class T>
LinearContact<T>::LinearContact(const ParametricSlope& of, const Expr& contact_modulus,
                                const ParameterValues<T>& value)
    : modulus(value(contact_modulus)) {
    for (const Expr& knot : of.knots) {
        slope.knots.push_back(value(knot));
    }
    for (const ParametricSlope::Piece& piece : of.pieces) {
        slope.pieces.push_back({value(piece.at_origin), value(piece.rate)});
    }
    slope.corners = of.corners;
    slope.origin = of.origin;
    slope.find_jumps();
}

template struct LinearContact<Ball>;
template struct LinearContact<BallSeries>;

Extent<Ball> solve_edges(const LinearContact<Ball>& contact, const LinearContact<Ball>& in_middle,
                         bool symmetric, const std::optional<Ball>& a,
                         const std::optional<Ball>& P) {
    constexpr long enough = 24; // bits, for Newton's method
    if (a && symmetric) {
        return {*a, *a};
    }
    const auto equations = [&](const LinearContact<Ball>& of) -> ZoneEquations {
        return {
            .values =
                [&of](const BallZone& zone) {
                    const Extent<Ball> e{zone.a, zone.b};
                    return ZoneValues{of.force(e), of.imbalance(e) / Ball::pi(of.modulus.bits())};
                },
            .rates =
                [&of](const BallZone& zone) {
                    const Extent<Ball> e{zone.a, zone.b};
                    return ZoneRates{of.force_rate(e),
                                     of.imbalance_rate(e) * e.length() * of.modulus / -2};
                },
            .modulus = of.modulus,
            .tilt = Ball(0, of.modulus.bits()),
            .force = P,
            .right_edge = a,
            .symmetric = symmetric};
    };
    ZoneEquations narrow = equations(in_middle);
    narrow.force = P ? std::optional(middle(*P)) : P;
    const Ball origin(0, in_middle.modulus.bits());
    const Ball first = middle(a ? *a : *P / in_middle.modulus);
    const BallZone found = narrow.search(narrow.from_afar({origin, origin, first}, enough));
    const BallZone zone = equations(contact).proved(found);
    return {zone.a, zone.b};
}

Extent<BallSeries> moving_edges(const LinearContact<BallSeries>& contact, const Extent<Ball>& edges,
                                bool symmetric, const std::optional<BallSeries>& a,
                                const std::optional<BallSeries>& P) {
    // Each step adds a term, since the rate is known to its first term.
    const auto implicit = [](const Ball& start, const auto& residual, const Ball& rate) {
        BallSeries x(start, jet_terms);
        for (std::size_t k = 1; k < jet_terms; ++k) {
            x.set(k, x[k] - residual(x)[k] / rate);
        }
        return x;
    };
    const Extent<BallSeries> constant{BallSeries(edges.a, jet_terms),
                                      BallSeries(edges.b, jet_terms)};
    const auto to_left = [&](const BallSeries& right) -> Extent<BallSeries> {
        if (symmetric) {
            return {right, right};
        }
        return {right, implicit(
                           edges.b,
                           [&](const BallSeries& b) {
                               return contact.imbalance({right, b});
                           },
                           contact.imbalance_rate(constant)[0])};
    };
    if (a) {
        return to_left(*a);
    }
    return to_left(implicit(
        edges.a, [&](const BallSeries& x) { return contact.force(to_left(x)) - *P; },
        contact.force_rate(constant)[0]));
}

/// The errors over a box in which no value can be enclosed.
static ErrorOverBox unknown_errors(long bits) {
    const Ball unknown = unknown_ball(bits);
    return {[unknown](const Ball&) { return unknown; },
            [bits](const Ball&, Along) { return unknown_series(jet_terms, bits); }, unknown};
}

namespace {

/// The closed form of LinearError (docs/pressure.md) for values of either type.
struct LinearForm {
    const ParametricSlope& slope;
    const ParametricLoad& load;
    const ErrorQuestion& question;
    Extent<Ball> edges;

    [[nodiscard]] LinearError<Ball> operator()(const ParameterValues<Ball>& value) const {
        return {LinearContact<Ball>(slope, load.contact_modulus, value), edges, question};
    }
    [[nodiscard]] LinearError<BallSeries>
    operator()(const ParameterValues<BallSeries>& value) const {
        const LinearContact<BallSeries> contact(slope, load.contact_modulus, value);
        return {contact,
                moving_edges(contact, edges, slope.symmetric, value(load.a), value(load.P)),
                question};
    }
};

} // namespace

std::unique_ptr<ErrorFamily> linear_slope_errors(const ParametricSlope& slope,
                                                 const ParametricLoad& load,
                                                 const ErrorQuestion& question) {
    const auto n = static_cast<double>(question.terms);
    const auto over = [=](const Ball& parameter) {
        const ParameterValues<Ball> value{parameter};
        const ParameterValues<Ball> in_middle{middle(parameter)};
        try {
            const Extent<Ball> edges =
                solve_edges(LinearContact<Ball>(slope, load.contact_modulus, value),
                            LinearContact<Ball>(slope, load.contact_modulus, in_middle),
                            slope.symmetric, value(load.a), value(load.P));
            const bool fraction = question.unit == ReachUnit::fraction;
            return closed_form_error(parameter, LinearForm{slope, load, question, edges},
                                     fraction ? Ball(1, parameter.bits()) : edges.length());
        } catch (const BudgetError&) {
        } catch (const DomainError&) {
        }
        return unknown_errors(parameter.bits());
    };
    return std::make_unique<ErrorFamily>(
        ErrorFamily{{(load.P ? 800 : 130) + n * n * n, 10, 60}, over});
}

} // namespace edgeproof::contact
