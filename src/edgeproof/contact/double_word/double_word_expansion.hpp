// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/double_word/double_word_pressure.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// The sum of the first n terms of p at an edge, p_n = c_0 u^(1/2) + c_1 u^(3/2) + ..., correctly
/// rounded to binary64, in double words as the pressure is. Immutable: many threads may use one
/// object.
class DoubleWordSum {
public:
    /// n >= 1. All is undecided where the contact's bits do not enclose the expansion (an edge that
    /// may be on a knot).
    DoubleWordSum(const BallContact& contact, Edge edge, std::size_t n);

    /// At the distance u from the edge, inside the contact.
    [[nodiscard]] DoubleWord at(const DoubleWord& u) const {
        return in_range_ && in_double_words(u) ? kernel_(*this, edge_, u) : double_word::unknown();
    }
    [[nodiscard]] std::optional<double> nearest(double u) const {
        return nearest_binary64(at({u, 0, 0}));
    }
    /// `at` without its checks.
    [[nodiscard]] DoubleWord formula(Edge edge, const DoubleWord& u) const {
        const DoubleWordPlace x(length_, edge, u);
        return x.inside() && x.known() ? sqrt(u) * polynomial(c_, scaled(u, per_unit_))
                                       : double_word::unknown();
    }
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
    double unit_; ///< of u, a power of two about the expansion's reach
    double per_unit_;
    std::vector<DoubleWord> c_; ///< c_k unit^k
    bool in_range_ = true;
    DoubleWordKernel<DoubleWordSum>::Function kernel_;
};

/// |1 - p_n/p|, in the same way; 1 on a corner, where p is infinite. Near the edge, where p - p_n
/// cancels, it is the sum of the terms that follow, and the rest of them is bounded by the
/// expansion's majorant.
class DoubleWordRelativeError {
public:
    /// Of a contact that DoubleWordPressure takes.
    DoubleWordRelativeError(const Profile& profile, const BallContact& contact, Edge edge,
                            std::size_t n);

    [[nodiscard]] DoubleWord at(const DoubleWord& u) const {
        return in_range_ && in_double_words(u) ? kernel_(*this, sum_.edge_, u)
                                               : double_word::unknown();
    }
    [[nodiscard]] std::optional<double> nearest(double u) const {
        return nearest_binary64(at({u, 0, 0}));
    }
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
        // u^n (c_n + c_(n+1) u + ... + rest)/(p/sqrt(u)), u in units of its own.
        const DoubleWord z = scaled(u, sum_.per_unit_);
        DoubleWord rest = DoubleWordSum::polynomial(next_, z);
        rest.radius += cut_off_;
        for (std::size_t k = 0; k < sum_.c_.size(); ++k) {
            rest = rest * z;
        }
        // Smaller ones underflow in their low words.
        return std::fabs(rest.high) > 0x1p-700 ? abs(rest * (sqrt(u) / p)) : double_word::unknown();
    }

private:
    DoubleWordSum sum_;
    DoubleWordPressure pressure_;
    std::vector<DoubleWord> next_; ///< c_n unit^n, c_(n+1) unit^(n+1), ...
    double near_ = 0;              ///< up to here by these
    double cut_off_ = 0;           ///< what their sum leaves out is less
    bool in_range_;
    DoubleWordKernel<DoubleWordRelativeError>::Function kernel_;
};

} // namespace edgeproof::contact
