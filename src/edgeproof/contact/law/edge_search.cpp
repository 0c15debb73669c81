// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/law/contact_law.hpp"

#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/error.hpp"

#include <cmath>

namespace edgeproof::contact {

/// The imbalance grows with a and falls with b (docs/mechanics.md), so that a bracket exists
/// wherever a solution does. Newton's method runs inside the bracket; where it fails, the bracket
/// is halved in the logarithm, since the edges may differ by thirty decades.
template <Arithmetic T>
T search_edge(const T& start, const std::function<T(const T&)>& imbalance,
              const std::function<EdgeStep<T>(const T&)>& newton) {
    using std::abs;
    using std::isfinite;
    using std::sqrt;
    // A positive value means that the unknown edge lies further out. An edge where the imbalance
    // has no value (an exponential beyond the range of T, a quadrature that does not converge) is
    // too far out.
    std::exception_ptr failure;
    const auto want_more = [&](const T& unknown) {
        try {
            const T f = imbalance(unknown);
            if (f == f) {
                return f;
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
            return newton(unknown);
        } catch (const DomainError&) {
        } catch (const BudgetError&) {
        }
        return EdgeStep<T>{T(-1), T(-hi)}; // too far out, as above
    };
    for (int k = 0; k < 20000; ++k) {
        const EdgeStep<T> s = step_at(x);
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
    throw BudgetError("the search for a contact edge did not converge");
}

/// P(a) grows from 0 for every profile, and without bound if the slope continues: the bracket is
/// found by doubling, then Newton's method runs inside it.
template <Arithmetic T>
T search_right_edge(const T& P, const T& least, const T& first, const ForceOf<T>& force_at) {
    using std::abs;
    constexpr int most_doublings = 4000;
    constexpr int most_failures = 80;
    std::exception_ptr failure;
    int failures = 0;
    // A place x where no contact ends counts as one with a greater force.
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
    T hi = lo > T(0) ? T(lo * T(2)) : first;
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
    bool carried = false; // true if some contact carries P or more
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
    throw BudgetError("Newton's iteration for the contact width did not converge in 500 steps");
}

#define EDGEPROOF_INSTANTIATE(T)                                                                   \
    template T search_edge(const T&, const std::function<T(const T&)>&,                            \
                           const std::function<EdgeStep<T>(const T&)>&);                           \
    template T search_right_edge(const T&, const T&, const T&, const ForceOf<T>&);
EDGEPROOF_FOR_EACH_ARITHMETIC(EDGEPROOF_INSTANTIATE)
#undef EDGEPROOF_INSTANTIATE

} // namespace edgeproof::contact
