// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/routes/normal_contact.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::contact {

[[nodiscard]] Real power_of_ten(int k);

/// p_local/p - 1 of n terms at an edge, at one precision.
class SignedError {
public:
    SignedError(const NormalContact& contact, unsigned digits, Edge edge, std::size_t n);

    [[nodiscard]] Real operator()(const Real& u) const;
    [[nodiscard]] Real approximation(const Real& u) const;
    /// Below this u the omitted terms together stay within a third of the tolerance.
    [[nodiscard]] Real safe_distance(const Real& tolerance) const;
    [[nodiscard]] const NormalContact& contact() const { return contact_; }
    [[nodiscard]] unsigned working() const { return working_; }
    [[nodiscard]] std::size_t pressures() const { return pressures_; }

private:
    NormalContact contact_;
    Edge edge_;
    std::vector<Real> c_;
    std::size_t terms_;
    unsigned working_;
    mutable std::size_t pressures_ = 0;
};

/// A knot or an end of the contact, as distance from the edge.
struct Landmark {
    Real u;
    bool singular; ///< p is infinite there (a corner) or zero (the far edge)
};

/// Ascending, both ends of the contact among them.
[[nodiscard]] std::vector<Landmark> landmarks(const NormalContact& contact, Edge edge);

/// A place of the scan: 0 within the tolerance, +1 at or above it, -1 at or below minus it.
struct ErrorSample {
    Real u;
    Real f;
    int side;
    std::optional<std::size_t> pole = {}; ///< the landmark that it stands on, where f is a limit
};

/// The error on several hundred points of a range, and at the extrema between them that may reach
/// the tolerance. Keeps references to the errors.
class ErrorScan {
public:
    /// `fine` decides where `error`, at fewer digits, cannot tell an extremum from the tolerance.
    ErrorScan(const SignedError& error, const SignedError& fine, const std::vector<Landmark>& marks,
              const formula::Exact& tolerance, Real from, Real to);
    [[nodiscard]] const std::vector<ErrorSample>& samples() const { return samples_; }

private:
    [[nodiscard]] int side(const Real& f) const {
        return f >= tolerance_ ? 1 : f <= -tolerance_ ? -1 : 0;
    }
    void place(const std::vector<Landmark>& marks);
    void add(const Real& u);
    void in_order();
    /// An extremum between the points may reach the tolerance, or dip below it, unseen.
    void seek_extrema();
    /// An extremum, or a place where f is beyond the threshold already.
    [[nodiscard]] ErrorSample extremum(const Real& lo, const Real& hi, bool top,
                                       const Real& threshold) const;
    static Real least(const SignedError& error, const Real& lo, const Real& hi, bool top,
                      const Real& threshold, int steps);

    const SignedError& error_;
    const SignedError& fine_;
    formula::Exact exact_tolerance_;
    Real tolerance_;
    Real from_;
    Real to_;
    std::vector<ErrorSample> samples_;
};

} // namespace edgeproof::contact
