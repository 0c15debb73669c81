// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/law/contact_law.hpp"

#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/precision/ball/special.hpp"
#include "edgeproof/precision/error.hpp"

#include <cmath>
#include <exception>

namespace edgeproof::contact {
namespace {

/// Up to this precision, Newton's steps start from the edge in binary64.
constexpr unsigned digits_from_binary64 = 60;

} // namespace

template <Arithmetic T>
ContactLaw<T>::ContactLaw(const Profile& profile, T contact_modulus, unsigned target_digits)
    : slope_(profile), modulus_(std::move(contact_modulus)), symmetric_(profile.symmetric()),
      target_digits_(target_digits) {
    if (!(modulus_ > T(0))) {
        throw DomainError("the contact modulus is not positive");
    }
    if (profile.kind() == Profile::Kind::power_law && !profile.piecewise_linear()) {
        const T m = profile.parameters().at("m").template to<T>();
        const T C = profile.parameters().at("C").template to<T>();
        // moore-hills EQ11; the factor is E* C times the integral of sin^(m+1) from 0 to pi/2
        power_ = PowerLaw<T>{m, T(modulus_ * C * sine_power_integral<T>(T(m + T(1))))};
    }
    if constexpr (!std::same_as<T, double>) {
        if (!symmetric_ || (!power_ && !profile.piecewise_linear())) {
            guess_ = std::make_shared<const ContactLaw<double>>(profile, 1.0);
        }
    }
    if constexpr (std::same_as<T, Real>) {
        // Two thirds of the digits and 12 more, so that one further step of Newton's method is
        // enough.
        const unsigned digits = working_digits() / 3 * 2 + 12;
        if (!symmetric_ && working_digits() > digits_from_binary64) {
            const PrecisionScope scope(digits);
            coarser_ =
                std::make_shared<const ContactLaw>(profile, T(1), std::min(target_digits, digits));
            coarser_digits_ = digits;
        }
    }
}

template <Arithmetic T> T ContactLaw<T>::force(const Extent<T>& e) const {
    if (power_) {
        return power_->force(e.a);
    }
    // moore-hills EQ22, by docs/mechanics.md, "One measure, six kernels"
    return T(modulus_ / T(2) * over_measure<ForceKernel>(e));
}

template <Arithmetic T> T ContactLaw<T>::moment(const Extent<T>& e) const {
    if (symmetric_) {
        return T(0);
    }
    return T(modulus_ / T(4) * over_measure<MomentKernel>(e));
}

template <Arithmetic T> T ContactLaw<T>::force_rate(const Extent<T>& e) const {
    if (power_) {
        return power_->force_rate(e.a);
    }
    return T(modulus_ / T(2) * over_measure<RightRateKernel>(e));
}

template <Arithmetic T> T ContactLaw<T>::left_force_rate(const Extent<T>& e) const {
    if (symmetric_) {
        return force_rate(e);
    }
    return T(modulus_ / T(2) * over_measure<LeftRateKernel>(e));
}

template <Arithmetic T> T ContactLaw<T>::imbalance(const Extent<T>& e) const {
    Marks<T, T> marks(e, slope_.knots());
    const T right = over_measure<RightBalanceKernel>(marks, Part::right_of_origin);
    const T left = over_measure<LeftBalanceKernel>(marks, Part::left_of_origin);
    const T sum = right + left;
    // moore-hills EQ20
    return sum > T(0) ? T((right - left) / sum) : T(0);
}

template <Arithmetic T>
Extent<T> ContactLaw<T>::extent_with(const T& known, const T& unknown, bool solve_left) const {
    return solve_left ? Extent<T>{known, unknown} : Extent<T>{unknown, known};
}

template <Arithmetic T> T ContactLaw<T>::left_edge(const T& a) const { return solve_edge(a, true); }
template <Arithmetic T> T ContactLaw<T>::right_edge(const T& b) const {
    return solve_edge(b, false);
}

template <Arithmetic T>
EdgeStep<T> ContactLaw<T>::edge_step(const T& known, const T& unknown, bool solve_left) const {
    const Extent<T> e = extent_with(known, unknown, solve_left);
    Marks<T, T> marks(e, slope_.knots());
    const T right = over_measure<RightBalanceKernel>(marks, Part::right_of_origin);
    const T left = over_measure<LeftBalanceKernel>(marks, Part::left_of_origin);
    // d(right - left)/db = -(integral of sqrt((a-v)/(v+b)) dg')/(a+b), and the like for a
    // (docs/mechanics.md).
    const T rate =
        (solve_left ? over_measure<LeftRateKernel>(marks) : over_measure<RightRateKernel>(marks)) /
        e.length();
    const T value = solve_left ? T(right - left) : T(left - right);
    return {value, T(value / rate)};
}

template <Arithmetic T>
std::optional<T> ContactLaw<T>::guessed_edge(const T& known, bool solve_left) const {
    try {
        if constexpr (std::same_as<T, Real>) {
            if (coarser_) {
                const auto coarse = [&] {
                    const PrecisionScope scope(coarser_digits_);
                    return coarser_->solve_edge(at_working_precision(known), solve_left);
                };
                return at_working_precision(coarse());
            }
        }
        const double k = static_cast<double>(known);
        if (guess_ && k > 1e-150 && k < 1e150) {
            return T(solve_left ? guess_->left_edge(k) : guess_->right_edge(k));
        }
    } catch (const Error&) {
        // Too few digits for a decision: the search uses all of them.
    }
    return std::nullopt;
}

/// The edge that is in balance with a given one. Newton's iteration from the binary64 edge nearly
/// always finds it; otherwise the search with a bracket does.
template <Arithmetic T> T ContactLaw<T>::solve_edge(const T& known, bool solve_left) const {
    using std::abs;
    using std::cbrt;
    using std::isfinite;
    if (!(known > T(0)) || !isfinite(known)) {
        throw DomainError("a contact edge is not at a positive, finite distance from the origin");
    }
    if (symmetric_) {
        return known;
    }
    const T start = guessed_edge(known, solve_left).value_or(known);
    if (guess_) {
        // The error after a step is of the order of the step's power 3/2 if the edge approaches a
        // knot, and of its square elsewhere. So it is below roundoff once the step is below
        // roundoff^(2/3).
        const T enough = cbrt(unit_roundoff<T>() * unit_roundoff<T>()) / T(1 << 10);
        T x = start;
        try {
            for (int k2 = 0; k2 < 40; ++k2) {
                const T step = edge_step(known, x, solve_left).step;
                if (!(abs(step) < x / T(2))) {
                    break;
                }
                x += step;
                if (abs(step) <= enough * x) {
                    return x;
                }
            }
        } catch (const BudgetError&) {
            // A step led to a place without a value: the search continues within its bracket.
        }
    }
    return search_edge(known, start, solve_left);
}

template <Arithmetic T>
T ContactLaw<T>::search_edge(const T& known, const T& start, bool solve_left) const {
    return contact::search_edge<T>(
        start,
        [&](const T& unknown) {
            const T f = imbalance(extent_with(known, unknown, solve_left));
            return solve_left ? f : T(-f);
        },
        [&](const T& unknown) { return edge_step(known, unknown, solve_left); });
}

template <Arithmetic T> T ContactLaw<T>::right_edge_for_force(const T& P) const {
    using std::abs;
    using std::isfinite;
    if (!(P > T(0)) || !isfinite(P)) {
        throw DomainError("the normal force is not positive and finite");
    }
    if (power_) {
        return power_->half_width(P);
    }
    // A flat at the origin carries no force before the contact extends beyond it.
    T lo(0);
    for (std::size_t i = slope_.origin() + 1; i < slope_.knots().size(); ++i) {
        const Extent<T> e{slope_.knots()[i], slope_.knots()[i]};
        if (symmetric_ && force(e) < P) {
            lo = slope_.knots()[i];
        }
    }
    if (const auto x = refined_from_guess(P)) {
        return *x;
    }
    return search_right_edge<T>(
        P, lo, T(P / modulus_),
        [&](const T& a, std::exception_ptr& failure) { return force_at(a, failure); });
}

/// Newton's steps from the answer in binary64; nothing if the steps do not shrink.
template <Arithmetic T> std::optional<T> ContactLaw<T>::refined_from_guess(const T& P) const {
    using std::abs;
    using std::cbrt;
    if (!guess_) {
        return std::nullopt;
    }
    const T start = P / modulus_;
    const double load = static_cast<double>(start);
    if (!(load > 1e-150 && load < 1e150)) {
        return std::nullopt;
    }
    try {
        T x(guess_->right_edge_for_force(load));
        const T eps = unit_roundoff<T>();
        std::optional<T> previous;
        const T enough = cbrt(unit_roundoff<T>() * unit_roundoff<T>()) / T(1 << 10);
        for (int k = 0; k < 40; ++k) {
            const Extent<T> e = extent(x);
            const T step = (P - force(e)) / force_rate(e);
            if (!(abs(step) < x / T(2))) {
                return std::nullopt;
            }
            x += step;
            // The steps end where they no longer shrink: an edge just beyond a corner is found only
            // to about its distance from the corner.
            if (abs(step) <= T(4) * eps * x ||
                (previous && abs(step) <= enough * x && !(abs(step) < *previous / T(2)))) {
                return x;
            }
            previous = abs(step);
        }
    } catch (const DomainError&) {
        // The search finds the edge, or throws the reason.
    } catch (const BudgetError&) {
    }
    return std::nullopt;
}

/// The force at the right edge a, and its rate. Nothing if no contact ends there: its other edge
/// may need the slope beyond the place where the slope ends, so that a is too large.
template <Arithmetic T>
std::optional<ForceAt<T>> ContactLaw<T>::force_at(const T& a, std::exception_ptr& failure) const {
    using std::isfinite;
    if (!symmetric_ && !(slope_.value(slope_.piece_at(a), a) > T(0))) {
        return ForceAt<T>{T(0), T(0)}; // the right side is flat and needs no other edge
    }
    try {
        const Extent<T> e = extent(a);
        const ForceAt<T> found{force(e), force_rate(e)};
        if (isfinite(found.force)) {
            return found;
        }
    } catch (const DomainError&) {
        failure = std::current_exception();
    } catch (const BudgetError&) {
        failure = std::current_exception();
    }
    return std::nullopt;
}

template <Arithmetic T>
LawSeries<T> ContactLaw<T>::series(const Extent<T>& e, std::size_t order) const {
    using S = series::Series<T>;
    const S a = S::variable(e.a, order);
    if (power_) {
        return {power_->force_rate_series(a), a};
    }
    S b = a;
    if (!symmetric_) {
        b = left_edge_by_newton(
            a, e.b,
            [&](const Extent<S>& moving) {
                Marks<T, S> marks(moving, slope_.knots());
                return S(over_measure<RightBalanceKernel>(marks, Part::right_of_origin) -
                         over_measure<LeftBalanceKernel>(marks, Part::left_of_origin));
            },
            [&](const Extent<S>& moving) { return over_measure<LeftRateKernel>(moving); });
    }
    const Extent<S> moving{a, b};
    return {over_measure<RightRateKernel>(moving) * T(modulus_ / T(2)), b};
}

template <Arithmetic T> bool ContactLaw<T>::right_edge_on_knot(const Extent<T>& e) const {
    for (const T& knot : slope_.knots()) {
        if (knot == e.a) {
            return true;
        }
    }
    return false;
}
template <Arithmetic T> bool ContactLaw<T>::left_edge_on_knot(const Extent<T>& e) const {
    for (const T& knot : slope_.knots()) {
        if (-knot == e.b) {
            return true;
        }
    }
    return false;
}

#define EDGEPROOF_CONTACT_LAW(T) template class ContactLaw<T>;
EDGEPROOF_FOR_EACH_ARITHMETIC(EDGEPROOF_CONTACT_LAW)
#undef EDGEPROOF_CONTACT_LAW

} // namespace edgeproof::contact
