// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/certificate/theory/theory.hpp"
#include "edgeproof/contact/profile/profile.hpp"

#include <string>
#include <vector>

namespace edgeproof::certificate {

/// A decimal number in Coq ("1234 / 10 ^ 3", "12 * 10 ^ 5") and its value.
struct CoqDecimal {
    std::string text;
    double value = 0;
    long last = 0; ///< the exponent of ten of the last digit as written
};
/// Converts a number such as "-1.23e-5". Throws NotStated if the text is not a decimal number.
[[nodiscard]] CoqDecimal coq_decimal(const std::string& number);
/// Rounds a positive number to `digits` significant digits, downwards or upwards.
[[nodiscard]] CoqDecimal coq_decimal(double number, int digits, bool upwards);
/// Returns a number as a Coq factor or argument, in parentheses where they are needed.
[[nodiscard]] std::string in_coq(const Exact& number);

/// A contact of a given punch, seen from one of its edges.
struct StatedEdge {
    std::string slope;     ///< in Coq, of the punch with this edge on the right
    std::string edge;      ///< its distance from the origin, in Coq
    double distance = 0;   ///< the same as a number
    double innermost = 0;  ///< all knots are at this distance from the origin or nearer
    double steepness = 0;  ///< y^2/u for the arguments y of the pressure's logarithms at a small u
    double cancelling = 1; ///< size of the logarithmic terms, relative to the pressure
    Fact series;           ///< coefficients r0, r1, r2
    /// Proofs about `pressure_at` at places beyond all knots.
    struct Proofs {
        std::string pressure; ///< proves is_pressure
        std::string near;     ///< takes the root of u out of the pressure
    };
    /// Throws NotStated for a place at a knot, or between a knot and the origin.
    [[nodiscard]] Proofs at(double u, const std::string& what) const;
    /// Returns "is_the_pressure Es (slope punch) a (a - u) p0".
    [[nodiscard]] std::string pressure_at(const std::string& u, const std::string& p) const;

    bool wedge = false;
    bool mirrored = false;
    /// The place at which the slope rises, and the proof of it and of that it lies within the
    /// contact. From these Coq concludes that there are no other pressures and coefficients. Empty
    /// for a slope that is not convex part by part: then only `is_pressure` is stated.
    std::string rises_at;
    std::string rises;
    std::string inside;
    /// Returns the proof that a value is the only one, from the proof that it is one.
    [[nodiscard]] std::string unique(const std::string& lemma, const std::string& proof) const;
};

/// A punch for which the Coq files have a theory: symmetric and piecewise linear, or a tilted
/// wedge.
struct StatedContact {
    std::vector<std::string> imports;
    std::vector<Constant> constants;
    std::string lemma; ///< a lemma of the file, after its constants
    Fact load;         ///< P0
    StatedEdge right;
    StatedEdge left;

    [[nodiscard]] const StatedEdge& at(Edge edge) const {
        return edge == Edge::right ? right : left;
    }
    /// Returns the definitions and the lemma.
    [[nodiscard]] std::string definitions() const;
    /// Returns `comment`, then imports, definitions and lemma: the beginning of a file.
    [[nodiscard]] std::string head(const std::string& comment) const;
};

/// Throws NotStated for other profiles. `gam`: b/a of a tilted wedge, if its tilt is given by it;
/// otherwise a null pointer.
[[nodiscard]] StatedContact stated_contact(const contact::Profile& profile, const Exact& a,
                                           const Exact& contact_modulus,
                                           const Exact* gam = nullptr);

/// The statement that n terms stay within `tolerance` of the pressure for all u up to `within`, and
/// do not at `beyond`. `more` is a further conclusion about these numbers, or empty. extent_theorem
/// throws NotStated for more than three terms.
struct ExtentStatement {
    std::size_t terms = 1;
    Exact tolerance;
    CoqDecimal within;
    CoqDecimal beyond;
    std::string more;
};
/// Returns the sum of the first terms at u; throws NotStated for more than three.
[[nodiscard]] std::string sum_of_terms(std::size_t terms);
[[nodiscard]] std::string extent_theorem(const std::string& name, const StatedEdge& edge,
                                         const ExtentStatement& extent);

} // namespace edgeproof::certificate
