// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// The places where the n-term approximation at an edge is within a tolerance of the pressure:
/// |1 - p_local(u)/p(u)| < tolerance (moore-hills EQ15; docs/expansions.md, "Extents"). All
/// distances are u from this edge, in the unit of length.
///
/// Each crossing is refined to the digits of the contact, with the relative error `estimate`. That
/// there are no others is *sampled*, not proved: at several hundred points, geometric towards both
/// edges and both sides of every knot, with a search for the extrema between them. At a corner of
/// the profile p is infinite, so that the approximation is outside every tolerance below 1 there.
struct Extents {
    Real first_exit; ///< the first u of the range at which the tolerance is reached
    Real measure;    ///< total length within the tolerance, over the whole range
    std::vector<Real> crossings;
    bool leaves = true; ///< false: all within the tolerance; first_exit is the range's end
    Real length;        ///< a + b
    Real range_from;
    Real range_to;
    Real estimate;             ///< estimated relative error of the least accurate crossing
    std::size_t samples = 0;   ///< number of points of the scan
    std::size_t pressures = 0; ///< number of pressures computed by the scan and the refinement
};

/// `tolerance` is relative (dimensionless), `range` in fractions of the contact's length. Throws
/// InputError for a tolerance <= 0, n = 0, or a range that is not 0 <= from < to <= 1.
[[nodiscard]] Extents within_tolerance(const NormalContact& contact, Edge edge, std::size_t n,
                                       const Exact& tolerance, const ExtentRange& range = {});

[[nodiscard]] Real power_of_ten(int k);

/// f = p_local/p - 1 for the sum p_local of n terms at an edge, at one precision
/// (docs/expansions.md).
class SignedError {
public:
    SignedError(const NormalContact& contact, unsigned digits, Edge edge, std::size_t n);

    /// f at the distance u from the edge.
    [[nodiscard]] Real operator()(const Real& u) const;
    /// p_local at the distance u from the edge.
    [[nodiscard]] Real approximation(const Real& u) const;
    /// Up to this u the omitted terms together are estimated to be within a third of the tolerance.
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

/// A knot or an end of the contact, by its distance from the edge.
struct Landmark {
    Real u;
    bool singular; ///< true if p is infinite there (a corner) or zero (the far edge)
};

/// The knots and both ends of the contact in ascending order.
[[nodiscard]] std::vector<Landmark> landmarks(const NormalContact& contact, Edge edge);

/// A sample of f. side: 0 within the tolerance, +1 at or above it, -1 at or below minus it.
struct ErrorSample {
    Real u;
    Real f;
    int side;
    std::optional<std::size_t> pole = {}; ///< the landmark at u, if f is a limit there
};

/// The error at several hundred points of a range, and at extrema between them that may reach the
/// tolerance. Keeps references to the errors.
class ErrorScan {
public:
    /// `error` has fewer digits than `fine`, which decides where `error` does not separate an
    /// extremum from the tolerance.
    ErrorScan(const SignedError& error, const SignedError& fine, const std::vector<Landmark>& marks,
              const Exact& tolerance, Real from, Real to);
    [[nodiscard]] const std::vector<ErrorSample>& samples() const { return samples_; }

private:
    [[nodiscard]] int side(const Real& f) const {
        return f >= tolerance_ ? 1 : f <= -tolerance_ ? -1 : 0;
    }
    void place(const std::vector<Landmark>& marks);
    void add(const Real& u);
    void in_order();
    /// Adds extrema between the samples that may cross the tolerance.
    void seek_extrema();
    /// The extremum between lo and hi, or a place where f is already beyond the threshold.
    [[nodiscard]] ErrorSample extremum(const Real& lo, const Real& hi, bool top,
                                       const Real& threshold) const;
    static Real least(const SignedError& error, const Real& lo, const Real& hi, bool top,
                      const Real& threshold, int steps);

    const SignedError& error_;
    const SignedError& fine_;
    Exact exact_tolerance_;
    Real tolerance_;
    Real from_;
    Real to_;
    std::vector<ErrorSample> samples_;
};

} // namespace edgeproof::contact
