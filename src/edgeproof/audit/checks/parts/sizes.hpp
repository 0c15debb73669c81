// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/checks/parts/enclosed_reach.hpp"
#include "edgeproof/audit/ledger/family.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/precision/rational.hpp"

#include <functional>
#include <string>
#include <vector>

/// The sizes of a contact, for claims whose source gives no size.
namespace edgeproof::audit {

/// Returns the scene with another right edge a and the same other parameters.
[[nodiscard]] SceneSpec with_size(SceneSpec scene, const Rational& a);

/// An interval of contact sizes a. An end that is not an end of the search is isolated to
/// `size_digits`, and not proved to be the only one between two listed sizes.
struct SizeInterval {
    Rational from;
    Rational to;
    bool open_below = false; ///< it begins where the search began
    bool open_above = false; ///< it ends where the search ended
};
inline constexpr unsigned size_digits = 3;

/// Disjoint intervals in ascending order.
using SizeSet = std::vector<SizeInterval>;

[[nodiscard]] SizeSet intersection(const SizeSet& x, const SizeSet& y);
/// Returns "1.23 ... 2.50; 7.50 ... 100 (end of the search)".
[[nodiscard]] std::string to_text(const SizeSet& set);

/// A statement holds at a size if this is `within`; on the other sides it fails.
using contact::Side;

/// A list of sizes between two given ones, denser near sizes where an edge meets a knot of the
/// profile: functions of the size are not smooth there.
class SizeScan {
public:
    /// Throws InputError unless 0 < from < to, and Error for a slope without a closed form whose
    /// contacts are not symmetric.
    SizeScan(const SceneSpec& scene, const Exact& from, const Exact& to);

    /// Ascending, with the ends of the range, without sizes at a knot.
    [[nodiscard]] const std::vector<Rational>& sizes() const noexcept { return sizes_; }
    /// Adds the range (as the texts of a claim's `sizes`), the number of sizes, and the sizes at
    /// which an edge is on a knot.
    void describe(const std::vector<std::string>& range, Evidence& evidence) const;
    /// Returns the sizes where a statement holds. `at_sizes`: its sides at sizes(); between two
    /// that differ, a change is isolated by bisection.
    [[nodiscard]] SizeSet where(const std::vector<Side>& at_sizes,
                                const std::function<Side(const Rational& a)>& side) const;

private:
    std::vector<Rational> sizes_;
    std::vector<Real> breaks_;
};

/// The one scene of a claim, and the sizes of its key `sizes`. Throws InputError if they are not
/// so.
struct SizedScene {
    SceneSpec scene;
    SizeScan scan;
};
[[nodiscard]] SizedScene sized_scene(const Claim& claim, const AuditContext& context);

/// The side that a decision shows: `above` for a refutation.
[[nodiscard]] inline Side side_of(const Decision& found) {
    return confirms(found) ? Side::within : refutes(found) ? Side::above : Side::unknown;
}

/// The part of the contact within a tolerance: up to the first place where it is exceeded, or the
/// total length within it; as a fraction of the whole contact, or of the side between the edge and
/// the origin (then only places on this side count).
struct ExtentReading {
    std::string_view text;
    bool first_exit; ///< false: the total length
    bool of_side;    ///< false: of the whole contact
};

/// Returns the fraction, proved; nothing if a crossing may lie beyond the end of the side.
[[nodiscard]] std::optional<Ball> fraction_within(const contact::EnclosedExtents& extents,
                                                  const Ball& side, const ExtentReading& reading);

} // namespace edgeproof::audit
