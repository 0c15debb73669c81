// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/double_word/double_word_pressure.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// The sum of the first n terms of p at an edge, p_n = c_0 u^(1/2) + c_1 u^(3/2) + ...
/// (eqn:LocalPressureI), correctly rounded to binary64, in double words like the pressure. The
/// object is immutable: many threads may use it.
class DoubleWordSum {
public:
    /// Every value is undecided if the bits of the contact do not enclose the expansion (an edge
    /// that may lie on a knot).
    /// @param contact the contact in balls
    /// @param edge edge of the expansion
    /// @param n number of terms, n >= 1
    DoubleWordSum(const BallContact& contact, Edge edge, std::size_t n);

    /// Returns p_n (stress) at the distance `u` from the edge (length), inside the contact.
    [[nodiscard]] DoubleWord at(const DoubleWord& u) const {
        return in_range_ && in_double_words(u) ? kernel_(*this, edge_, u) : double_word::unknown();
    }
    /// Returns the binary64 nearest to p_n at `u`; nothing where that is undecided.
    [[nodiscard]] std::optional<double> nearest(double u) const {
        return nearest_binary64(at({u, 0, 0}));
    }
    /// `at` without its checks.
    [[nodiscard]] DoubleWord formula(Edge edge, const DoubleWord& u) const {
        const DoubleWordPlace x(length_, edge, u);
        return x.inside() && x.known() ? sqrt(u) * polynomial(c_, scaled(u, per_unit_))
                                       : double_word::unknown();
    }
    /// Returns c_0 + c_1 z + ... by Horner's rule.
    [[nodiscard]] static DoubleWord polynomial(const std::vector<DoubleWord>& c,
                                               const DoubleWord& z) {
        DoubleWord sum = c.back();
        for (std::size_t k = c.size() - 1; k-- > 0;) {
            sum = sum * z + c[k];
        }
        return sum;
    }

private:
    friend class DoubleWordRelativeError;
    Edge edge_;
    PreciseWord length_;
    double unit_; ///< unit of u, a power of two near the reach of the expansion
    double per_unit_;
    std::vector<DoubleWord> c_; ///< c_k unit^k
    bool in_range_ = true;
    DoubleWordKernel<DoubleWordSum>::Function kernel_;
};

/// The relative error |1 - p_n/p| (row EQ15 of moore-hills) in the same way; 1 on a corner, where p
/// is infinite. Near the edge, where p - p_n cancels, it is computed from the terms that follow;
/// the majorant of the expansion bounds the remainder (docs/double-words.md, lemma 8).
class DoubleWordRelativeError {
public:
    /// For a contact that DoubleWordPressure supports.
    /// @param profile g'(x)
    /// @param contact the contact in balls
    /// @param edge edge of the expansion
    /// @param n number of terms, n >= 1
    DoubleWordRelativeError(const Profile& profile, const BallContact& contact, Edge edge,
                            std::size_t n);

    /// Returns |1 - p_n/p| at the distance `u` from the edge (length), inside the contact.
    [[nodiscard]] DoubleWord at(const DoubleWord& u) const {
        return in_range_ && in_double_words(u) ? kernel_(*this, sum_.edge_, u)
                                               : double_word::unknown();
    }
    /// Returns the binary64 nearest to |1 - p_n/p| at `u`; nothing where that is undecided.
    [[nodiscard]] std::optional<double> nearest(double u) const {
        return nearest_binary64(at({u, 0, 0}));
    }
    /// `at` without its checks.
    [[nodiscard]] DoubleWord formula(Edge edge, const DoubleWord& u) const {
        const DoubleWord p = pressure_.formula(edge, u);
        if (std::isinf(p.high)) { // exactly on a corner
            return {1, 0, 0};
        }
        if (!double_word::well_known(p)) {
            return double_word::unknown();
        }
        if (!(u.high < near_ && u.radius < 0x1p-60 * u.high)) {
            return abs((p - sum_.formula(edge, u)) / p);
        }
        // u^n (c_n + c_(n+1) u + ... + rest)/(p/sqrt(u)), with u in units of `unit_`.
        const DoubleWord z = scaled(u, sum_.per_unit_);
        DoubleWord rest = DoubleWordSum::polynomial(next_, z);
        rest.radius += cut_off_;
        for (std::size_t k = 0; k < sum_.c_.size(); ++k) {
            rest = rest * z;
        }
        // The low words of smaller values underflow.
        return std::fabs(rest.high) > 0x1p-700 ? abs(rest * (sqrt(u) / p)) : double_word::unknown();
    }

private:
    DoubleWordSum sum_;
    DoubleWordPressure pressure_;
    std::vector<DoubleWord> next_; ///< c_n unit^n, c_(n+1) unit^(n+1), ...
    double near_ = 0;              ///< up to this u these terms are used
    double cut_off_ = 0;           ///< a bound of the remainder after these terms
    bool in_range_;
    DoubleWordKernel<DoubleWordRelativeError>::Function kernel_;
};

} // namespace edgeproof::contact
