// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/law/contact_law.hpp"

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
        power_ = PowerLaw{m, T(modulus_ * C * sine_power_integral<T>(T(m + T(1))))};
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
    using std::pow;
    if (power_) {
        return T(power_->force_factor * pow(e.a, T(power_->exponent + T(1))));
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
    using std::pow;
    if (power_) {
        return T(power_->force_factor * (power_->exponent + T(1)) * pow(e.a, power_->exponent));
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
typename ContactLaw<T>::EdgeStep ContactLaw<T>::edge_step(const T& known, const T& unknown,
                                                          bool solve_left) const {
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

/// The edge that balances a given one. Newton from the binary64 answer settles it nearly always;
/// what it does not settle, the search with a bracket does.
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

/// The imbalance grows with a and falls with b, so a bracket always exists where a solution does;
/// Newton runs inside it and falls back on halving (of the logarithm: edges may differ by thirty
/// decades).
template <Arithmetic T>
T ContactLaw<T>::search_edge(const T& known, const T& start, bool solve_left) const {
    using std::abs;
    using std::isfinite;
    using std::sqrt;
    // > 0: the unknown edge lies further out. Where there is no value (an exponential beyond the
    // numbers of T, a quadrature that does not converge) it is too far out.
    std::exception_ptr failure;
    const auto want_more = [&](const T& unknown) {
        try {
            const T f = imbalance(extent_with(known, unknown, solve_left));
            if (f == f) {
                return solve_left ? f : T(-f);
            }
        } catch (const DomainError&) {
            failure = std::current_exception();
        } catch (const BudgetError&) {
            failure = std::current_exception();
        }
        return T(-1);
    };
    T x = start;
    T lo(0);
    T hi(0);
    T f = want_more(x);
    T factor(4);
    for (int k = 0; k < 40; ++k) {
        if (f == T(0)) {
            return x;
        }
        const T next = f > T(0) ? T(x * factor) : T(x / factor);
        if (!isfinite(next) || next == T(0)) {
            break;
        }
        (f > T(0) ? lo : hi) = x;
        const T g = want_more(next);
        if ((g > T(0)) != (f > T(0))) {
            (f > T(0) ? hi : lo) = next;
            break;
        }
        x = next;
        f = g;
        factor = factor * factor;
    }
    if ((!(lo > T(0)) || !(hi > T(0))) && failure) {
        std::rethrow_exception(failure);
    }
    if (!(lo > T(0)) || !(hi > T(0))) {
        throw DomainError("no position of the other edge closes this contact: the profile does not "
                          "rise on that side");
    }
    x = T(sqrt(lo) * sqrt(hi));
    const T eps = unit_roundoff<T>();
    T last_step = hi - lo;
    const auto step_at = [&](const T& unknown) {
        try {
            return edge_step(known, unknown, solve_left);
        } catch (const DomainError&) {
        } catch (const BudgetError&) {
        }
        return EdgeStep{T(-1), T(-hi)}; // too far out, as above
    };
    for (int k = 0; k < 20000; ++k) {
        const EdgeStep s = step_at(x);
        if (s.value == T(0)) {
            return x;
        }
        (s.value > T(0) ? lo : hi) = x;
        T next = x + s.step;
        const bool inside = next > lo && next < hi;
        if (inside && abs(s.step) <= T(4) * eps * x) {
            return next;
        }
        if (!inside || (k > 3 && abs(s.step) > last_step / T(2))) {
            next = T(sqrt(lo) * sqrt(hi));
            if (!(next > lo) || !(next < hi)) {
                return x;
            }
        }
        last_step = abs(s.step);
        x = next;
    }
    throw BudgetError("the search for a contact edge did not settle");
}

template <Arithmetic T> T ContactLaw<T>::right_edge_for_force(const T& P) const {
    using std::abs;
    using std::isfinite;
    using std::pow;
    if (!(P > T(0)) || !isfinite(P)) {
        throw DomainError("the normal force is not positive and finite");
    }
    if (power_) {
        return T(pow(T(P / power_->force_factor), T(T(1) / (power_->exponent + T(1)))));
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
    return search_right_edge(P, lo);
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
std::optional<typename ContactLaw<T>::ForceAt>
ContactLaw<T>::force_at(const T& a, std::exception_ptr& failure) const {
    using std::isfinite;
    if (!symmetric_ && !(slope_.value(slope_.piece_at(a), a) > T(0))) {
        return ForceAt{T(0), T(0)}; // the right side of the contact is flat: nothing to balance
    }
    try {
        const Extent<T> e = extent(a);
        const ForceAt found{force(e), force_rate(e)};
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

/// P(a) grows from 0 for every convex profile, without bound where it goes on for ever: bracket by
/// doubling, then Newton inside the bracket.
template <Arithmetic T> T ContactLaw<T>::search_right_edge(const T& P, const T& least) const {
    using std::abs;
    constexpr int most_doublings = 4000;
    constexpr int most_failures = 80;
    std::exception_ptr failure;
    int failures = 0;
    // No contact at x counts as one that carries more.
    const auto at = [&](const T& x) {
        auto found = force_at(x, failure);
        if (!found && ++failures > most_failures && failure) {
            std::rethrow_exception(failure);
        }
        return found;
    };
    const auto below = [&](const T& x) {
        const auto found = at(x);
        return found && found->force < P;
    };
    T lo = least;
    T hi = lo > T(0) ? T(lo * T(2)) : T(P / modulus_);
    int doublings = 0;
    while (below(hi)) {
        lo = hi;
        hi = hi * T(2);
        if (++doublings > most_doublings) {
            throw BudgetError("no contact width carries this normal force");
        }
    }
    while (lo == T(0)) {
        const T half = hi / T(2);
        (below(half) ? lo : hi) = half;
        if (++doublings > most_doublings) {
            throw BudgetError("no contact width carries this normal force");
        }
    }
    T x = (lo + hi) / T(2);
    const T eps = unit_roundoff<T>();
    T last_step = hi - lo;
    bool carried = false; // some contact carries as much
    for (int k = 0; k < 500; ++k) {
        const auto found = at(x);
        const T value = found ? T(P - found->force) : T(-P);
        carried = carried || (found && !(value > T(0)));
        if (value == T(0)) {
            return x;
        }
        (value > T(0) ? lo : hi) = x;
        const bool sloped = found && found->rate > T(0);
        const T step = sloped ? T(value / found->rate) : T(hi - lo);
        T next = x + step;
        if (sloped && abs(step) <= T(4) * eps * x) {
            return next;
        }
        if (!(next > lo) || !(next < hi) || (k > 3 && abs(step) > last_step / T(2))) {
            next = (lo + hi) / T(2);
            if (!(next > lo) || !(next < hi)) {
                if (!carried && failure) {
                    std::rethrow_exception(failure);
                }
                return x;
            }
        }
        last_step = abs(step);
        x = next;
    }
    throw BudgetError("Newton's iteration for the contact width did not settle in 500 steps");
}

template <Arithmetic T>
LawSeries<T> ContactLaw<T>::series(const Extent<T>& e, std::size_t order) const {
    using S = series::Series<T>;
    const S a = S::variable(e.a, order);
    if (power_) {
        return {pow(a, power_->exponent) * T(power_->force_factor * (power_->exponent + T(1))), a};
    }
    S b = a;
    if (!symmetric_) {
        // b'(a) = (dP/da)/(dP/db); each step of Newton doubles the terms that are right.
        b = S(e.b, 1);
        for (std::size_t known = 1; known < order;) {
            known = std::min(2 * known, order);
            std::vector<T> padded = b.coefficients();
            padded.resize(known, T(0));
            const Extent<S> moving{a.truncated(known), S(std::move(padded))};
            Marks<T, S> marks(moving, slope_.knots());
            const S gap = over_measure<RightBalanceKernel>(marks, Part::right_of_origin) -
                          over_measure<LeftBalanceKernel>(marks, Part::left_of_origin);
            const S rate = over_measure<LeftRateKernel>(marks) / moving.length();
            b = moving.b + gap / rate;
            b[0] = e.b; // the edge is where it was put; its roundoff is not a correction
        }
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
