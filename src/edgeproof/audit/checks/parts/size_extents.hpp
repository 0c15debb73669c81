// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/contact_law.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/profile/profile.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace edgeproof::audit {

/// The possible readings of "within 1 % of the exact solution for 4 % of the contact": the first
/// place where the tolerance is exceeded, or the total length within it; as a fraction of the whole
/// contact, or of the side between the edge and the origin.
enum class ExtentReading { first_exit_of_side, measure_of_side, first_exit_of_all, measure_of_all };
inline constexpr std::array extent_readings{
    ExtentReading::first_exit_of_side, ExtentReading::measure_of_side,
    ExtentReading::first_exit_of_all, ExtentReading::measure_of_all};
[[nodiscard]] std::string_view text_of(ExtentReading reading);
[[nodiscard]] constexpr bool is_of_side(ExtentReading reading) {
    return reading == ExtentReading::first_exit_of_side ||
           reading == ExtentReading::measure_of_side;
}

/// The edge, the number of terms and the tolerance of an approximation.
struct ExtentOf {
    contact::Edge edge = contact::Edge::right;
    std::size_t terms = 1;
    Float128 tolerance;
};

/// The contacts of one profile for varying size, in binary128 (crossings are found in long double
/// and refined in binary128 to about 22 digits; the profile must have a closed form). extent.hpp
/// computes the same for one contact to any digits; this class is fast for thousands of contacts,
/// for up to four terms.
class ContactsBySize {
public:
    static constexpr std::size_t most_terms = 4;
    /// Throws DomainError for a profile that is not piecewise linear.
    explicit ContactsBySize(const contact::Profile& profile);

    /// One fraction for each reading.
    using Fractions = std::array<Float128, extent_readings.size()>;

    /// The contact with right edge a. Keeps a reference to the ContactsBySize.
    class At {
    public:
        At(const ContactsBySize& contacts, const Float128& a);
        At(const At&) = delete;
        At& operator=(const At&) = delete;
        /// Returns the fractions to about 22 digits.
        [[nodiscard]] Fractions fractions(const ExtentOf& of);
        /// Returns them to about 12 digits, several times faster.
        [[nodiscard]] Fractions rough_fractions(const ExtentOf& of);
        [[nodiscard]] const contact::Extent<Float128>& extent();
        /// Returns at least c_0 ... c_{count-1}, to about 28 digits.
        [[nodiscard]] const std::vector<Float128>& coefficients(contact::Edge edge,
                                                                std::size_t count);

    private:
        /// A value at the distance u from an edge: p, or p_local/p - 1.
        struct Node {
            long double u;
            long double f;
        };
        /// The contact in one arithmetic; computed on first use.
        template <class T> struct In {
            std::optional<contact::Extent<T>> extent;
            std::optional<contact::Marks<T, T>> marks; ///< the landmarks of the extent
            std::array<std::vector<T>, 2> c;
        };
        [[nodiscard]] const contact::Extent<long double>& rough_extent();
        [[nodiscard]] long double rough_pressure(contact::Edge edge, long double u);
        [[nodiscard]] const std::vector<long double>& rough_coefficients(contact::Edge edge);
        [[nodiscard]] const std::vector<Node>& pressures(contact::Edge edge);
        [[nodiscard]] std::vector<long double> places(contact::Edge edge);
        [[nodiscard]] Float128 error(const ExtentOf& of, const Float128& u);
        [[nodiscard]] long double rough_error(const ExtentOf& of, long double u);
        [[nodiscard]] std::vector<Node> errors(const ExtentOf& of);
        [[nodiscard]] Float128 crossing(const ExtentOf& of, const Node& l, const Node& r, int which,
                                        bool refine);
        [[nodiscard]] Fractions found(const ExtentOf& of, bool refine);

        const ContactsBySize& contacts_;
        Float128 a_;
        In<long double> rough_;
        In<Float128> fine_;
        std::array<std::vector<Node>, 2> pressures_;
    };
    [[nodiscard]] At at(const Float128& a) const { return {*this, a}; }

private:
    contact::ContactLaw<Float128> law_;
    contact::ContactLaw<long double> rough_;
};

} // namespace edgeproof::audit
