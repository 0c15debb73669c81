// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/contact_law.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/contact/routes/pressure_routes.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace edgeproof::audit {

/// The possible readings of "within 1 % of the exact solution for 4 % of the contact": the first
/// place where the tolerance is exceeded, or the total length within it; as a fraction of the whole
/// contact, or of the side between the edge and the origin.
struct ExtentReading {
    std::string_view text;
    bool first_exit; ///< false: the total length
    bool of_side;    ///< false: of the whole contact
};
inline constexpr std::array<ExtentReading, 4> extent_readings{
    {{"first exit, of the side from the edge to the origin", true, true},
     {"all that is within, of the side from the edge to the origin", false, true},
     {"first exit, of the whole contact", true, false},
     {"all that is within, of the whole contact", false, false}}};

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
        At(const ContactsBySize& contacts, const Float128& a)
            : rough_(contacts.rough_, static_cast<long double>(a)), fine_(contacts.law_, a) {}
        At(const At&) = delete;
        At& operator=(const At&) = delete;
        /// Returns the fractions to about 22 digits; if not `refined`, to about 12 digits, several
        /// times faster.
        [[nodiscard]] Fractions fractions(const ExtentOf& of, bool refined = true);
        [[nodiscard]] const contact::Extent<Float128>& extent() { return fine_.extent(); }
        /// Returns at least c_0 ... c_{count-1}, to about 28 digits.
        [[nodiscard]] const std::vector<Float128>& coefficients(contact::Edge edge,
                                                                std::size_t count) {
            return fine_.coefficients(edge, count);
        }

    private:
        /// A value at the distance u from an edge: p, or p_local/p - 1.
        struct Node {
            long double u;
            long double f;
        };
        /// The contact in one arithmetic; everything is computed on first use.
        template <class T> class In {
        public:
            In(const contact::ContactLaw<T>& law, T a) : law_(law), a_(std::move(a)) {}
            [[nodiscard]] const T& right_edge() const { return a_; }
            const contact::Extent<T>& extent() {
                if (!extent_) {
                    extent_ = law_.extent(a_);
                }
                return *extent_;
            }
            const std::vector<T>& coefficients(contact::Edge edge, std::size_t count) {
                std::vector<T>& c = c_.at(index_of(edge));
                if (c.size() < count) {
                    c = edge_expansion(law_, extent(), edge, count);
                }
                return c;
            }
            T pressure(contact::Edge edge, const T& u) {
                if (!marks_) {
                    marks_.emplace(extent(), law_.slope().knots());
                }
                return logarithmic_closed_form(law_, *marks_, point_at(extent(), edge, u)).value;
            }
            /// Returns p_local at u.
            T approximation(const ExtentOf& of, std::size_t known, const T& u) {
                using std::sqrt;
                const std::vector<T>& c = coefficients(of.edge, known);
                T sum(0);
                for (std::size_t k = of.terms; k-- > 0;) {
                    sum = sum * u + c[k];
                }
                return sum * sqrt(u);
            }
            [[nodiscard]] const auto& knots() const { return law_.slope().knots(); }

        private:
            const contact::ContactLaw<T>& law_;
            T a_;
            std::optional<contact::Extent<T>> extent_;
            std::optional<contact::Marks<T, T>> marks_; ///< the landmarks of the extent
            std::array<std::vector<T>, 2> c_;
        };
        [[nodiscard]] const std::vector<Node>& pressures(contact::Edge edge);
        [[nodiscard]] std::vector<long double> places(contact::Edge edge);
        [[nodiscard]] long double rough_error(const ExtentOf& of, long double u) {
            return rough_.approximation(of, most_terms, u) / rough_.pressure(of.edge, u) - 1;
        }
        [[nodiscard]] std::vector<Node> errors(const ExtentOf& of);
        [[nodiscard]] Float128 crossing(const ExtentOf& of, const Node& l, const Node& r, int which,
                                        bool refined);

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
