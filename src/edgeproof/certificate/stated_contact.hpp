// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/certificate/theory/theory.hpp"
#include "edgeproof/contact/profile/profile.hpp"

#include <string>
#include <vector>

namespace edgeproof::certificate {

/// A decimal number in Coq: "1234 / 10 ^ 3", "12 * 10 ^ 5", with its value.
struct CoqDecimal {
    std::string text;
    double value = 0;
    long last = 0; ///< the power of ten of its last digit, as it was written
};
/// From "-1.23e-5". Throws NotStated for what is no decimal number.
[[nodiscard]] CoqDecimal coq_decimal(const std::string& number);
/// `digits` significant digits of a positive number, downwards or upwards.
[[nodiscard]] CoqDecimal coq_decimal(double number, int digits, bool upwards);
/// A number as a factor or argument.
[[nodiscard]] std::string in_coq(const formula::Exact& number);

/// A contact of a given punch, seen from one of its edges.
struct StatedEdge {
    std::string slope;     ///< in Coq, of the punch that has this edge on the right
    std::string edge;      ///< its distance from the origin, in Coq
    double distance = 0;   ///< the same
    double innermost = 0;  ///< the place beyond which all knots are nearer to the origin
    double steepness = 0;  ///< y^2/u of the logarithms of the pressure at a small distance u
    double cancelling = 1; ///< the logarithms' parts of the pressure there, beside the pressure
    Fact series;           ///< coefficients r0, r1, r2
    /// The proofs that begin with what is said of `pressure_at`, for places beyond all knots.
    struct Proofs {
        std::string pressure; ///< of is_pressure
        std::string near;     ///< takes the root of u out of it
    };
    /// Throws NotStated for a place on a knot or nearer to the origin than one.
    [[nodiscard]] Proofs at(double u, const std::string& what) const;
    /// "is_pressure Es (slope punch) a (a - u) p0".
    [[nodiscard]] std::string pressure_at(const std::string& u, const std::string& p) const;

    bool wedge = false;
    bool mirrored = false;
};

/// A punch that the Coq files have a theory of: symmetric and piecewise linear, or a tilted wedge.
struct StatedContact {
    std::vector<std::string> imports;
    std::vector<Constant> constants;
    std::string lemma; ///< of the file, after its constants
    Fact load;         ///< P0
    StatedEdge right;
    StatedEdge left;

    [[nodiscard]] const StatedEdge& at(contact::Edge edge) const {
        return edge == contact::Edge::right ? right : left;
    }
    /// Imports, definitions and lemma, behind the comment that a file begins with.
    [[nodiscard]] std::string head(const std::string& comment) const;
};

/// Throws NotStated for other profiles.
[[nodiscard]] StatedContact stated_contact(const contact::Profile& profile, const formula::Exact& a,
                                           const formula::Exact& contact_modulus);

/// n terms stay within `tolerance` of the pressure for all u up to `within`, and do not at
/// `beyond`; `more`: a further conclusion, or empty. Throws NotStated for more than three terms.
struct ExtentStatement {
    std::size_t terms = 1;
    formula::Exact tolerance;
    CoqDecimal within;
    CoqDecimal beyond;
    std::string more;
};
[[nodiscard]] std::string extent_theorem(const std::string& name, const StatedEdge& edge,
                                         const ExtentStatement& extent);

} // namespace edgeproof::certificate
