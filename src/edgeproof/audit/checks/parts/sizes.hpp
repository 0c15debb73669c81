// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/family.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/contact/law/contact_law.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/contact/routes/pressure_routes.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/arithmetic.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::audit {

/// An interval of contact sizes a, for claims whose source gives no size. Sizes are searched in
/// binary128, independently of the digits of the audit: ends are right to about 14 digits and are
/// the same on every machine.
struct SizeInterval {
    Float128 from;
    Float128 to;
    bool open_below = false; ///< it begins where the search began
    bool open_above = false; ///< it ends where the search ended
};

/// Returns the scene with another right edge a and the same other parameters.
[[nodiscard]] SceneSpec with_size(SceneSpec scene, const Float128& a);

/// Disjoint intervals in ascending order.
using SizeSet = std::vector<SizeInterval>;

[[nodiscard]] SizeSet intersection(const SizeSet& x, const SizeSet& y);
/// Returns "1.23456789012 ... 2.5; 7.5 ... end of the search", each end with `digits` digits.
[[nodiscard]] std::string to_text(const SizeSet& set, unsigned digits = 12);
[[nodiscard]] std::string to_text(const Float128& a, unsigned digits = 12);
/// True for a single interval from one end of the search to the other.
[[nodiscard]] bool is_everything(const SizeSet& set);

/// The sizes between two given ones, split where an edge meets a knot of the profile: functions of
/// the size are not smooth there, and the search approaches it from both sides.
class SizeScan {
public:
    /// Throws InputError unless 0 < from < to.
    SizeScan(const contact::Profile& profile, const Exact& from, const Exact& to,
             int per_decade = 8);

    using Function = std::function<Float128(const Float128& a)>;
    using Test = std::function<bool(const Float128& a)>;

    /// The first sizes tried: ascending, with the ends of the range, without sizes at a knot.
    [[nodiscard]] const std::vector<Float128>& sizes() const noexcept { return sizes_; }
    /// The sizes at which an edge is on a knot.
    [[nodiscard]] const std::vector<Float128>& breaks() const noexcept { return breaks_; }
    /// Adds the range (as the texts of a claim's `sizes`), the number of sizes and the breaks.
    void describe(const std::vector<std::string>& range, Evidence& evidence) const;
    /// Returns the set where lower <= f(a) < upper. `at_sizes`: f at sizes(). Between neighbouring
    /// sizes, f is assumed to cross each bound at most once, except near extrema indicated by three
    /// successive sizes: sampled, not proved. A jump of f counts as a crossing.
    [[nodiscard]] SizeSet between(const Function& f, const std::vector<Float128>& at_sizes,
                                  const Float128& lower, const Float128& upper) const;
    /// Returns the set where a test holds, in the same way.
    [[nodiscard]] SizeSet where(const Test& test) const;

private:
    [[nodiscard]] SizeSet joined(bool inside, std::vector<Float128> ends) const;
    std::vector<Float128> sizes_;
    std::vector<Float128> breaks_;
};

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
    Edge edge = Edge::right;
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
        [[nodiscard]] const std::vector<Float128>& coefficients(Edge edge, std::size_t count) {
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
            const std::vector<T>& coefficients(Edge edge, std::size_t count) {
                std::vector<T>& c = c_.at(index_of(edge));
                if (c.size() < count) {
                    c = edge_expansion(law_, extent(), edge, count);
                }
                return c;
            }
            T pressure(Edge edge, const T& u) {
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
        [[nodiscard]] const std::vector<Node>& pressures(Edge edge);
        [[nodiscard]] std::vector<long double> places(Edge edge);
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
