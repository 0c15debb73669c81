// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/law/contact_law.hpp"

#include "edgeproof/contact/law/law_series.hpp"
#include "edgeproof/precision/ball/special.hpp"
#include "edgeproof/precision/error.hpp"

#include <cmath>
#include <exception>

namespace edgeproof::contact {
namespace {

/// Up to here Newton's steps from the binary64 edge are as cheap as any.
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
        power_ = PowerLaw<T>{m, T(modulus_ * C * sine_power_integral<T>(T(m + T(1))))};
    }
    if constexpr (!std::same_as<T, double>) {
        if (!symmetric_ || (!power_ && !profile.piecewise_linear())) {
            guess_ = std::make_shared<const ContactLaw<double>>(profile, 1.0);
        }
    }
    if constexpr (std::same_as<T, Real>) {
        // Two thirds of the digits and a few, so that one step of Newton's from there is enough.
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
    // d(right - left)/db = -(integral of sqrt((a-v)/(v+b)) dg')/(a+b), and likewise for a.
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
        // Too few digits to decide; the search with all of them can.
    }
    return std::nullopt;
}

/// The edge that balances a given one. Newton from the binary64 answer finds it nearly always;
/// what it does not find, the search with a bracket does.
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
        // What a step leaves is of the order of its power 3/2, where the edge comes to a knot, and
        // of its square elsewhere: below roundoff once the step is below the power 2/3 of that.
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
            // A step led to where there is no value; the search looks on the other side.
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
    // A flat at the origin carries no force until the contact leaves it.
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

/// Newton's steps from the answer in binary64; nothing where they do not shrink.
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
            // As far as the steps shrink: an edge just beyond a corner is as near to its answer as
            // it is to the corner, and no nearer.
            if (abs(step) <= T(4) * eps * x ||
                (previous && abs(step) <= enough * x && !(abs(step) < *previous / T(2)))) {
                return x;
            }
            previous = abs(step);
        }
    } catch (const DomainError&) {
        // The search tells why, or does better.
    } catch (const BudgetError&) {
    }
    return std::nullopt;
}

/// The force at the right edge a, and its rate; nothing where no contact ends there: its balance
/// may ask for more of the slope on the other side than there is, so that a is too large.
template <Arithmetic T>
std::optional<ForceAt<T>> ContactLaw<T>::force_at(const T& a, std::exception_ptr& failure) const {
    using std::isfinite;
    if (!symmetric_ && !(slope_.value(slope_.piece_at(a), a) > T(0))) {
        return ForceAt<T>{T(0), T(0)}; // the right side of the contact is flat: nothing to balance
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

template class ContactLaw<double>;
template class ContactLaw<long double>;
template class ContactLaw<Float128>;
template class ContactLaw<Real>;

} // namespace edgeproof::contact
