// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/contact/enclosure/proved_contact.hpp"
#include "edgeproof/contact/profile/edge.hpp"

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace edgeproof::contact {

/// Where the sum of n terms is within a tolerance of the pressure (extent.hpp), proved: every u of
/// the range is shown to be on one side of the tolerance, or lies in the ball of a crossing. All
/// balls are lengths.
struct EnclosedExtents {
    /// The least u of the range at which the tolerance is reached; the range's end if there is
    /// none.
    Ball first_exit;
    Ball measure;                ///< the total length within the tolerance
    std::vector<Ball> crossings; ///< ascending; near a corner an entry may contain 1, 3, ...
    bool leaves = true;
    bool starts_within = true; ///< true if the range begins within the tolerance
    /// For each crossing, true if its ball holds exactly one root; the error is then monotone
    /// there.
    std::vector<bool> single;
    Ball length; ///< a + b
};

/// The search of docs/expansions.md. Next to the edge the omitted terms are bounded by a majorant
/// of the expansion. In the rest of the range p and its Taylor remainder are enclosed over
/// intervals. These are halved until f = p_local/p - 1 is certainly within the tolerance, certainly
/// beyond it, or certainly monotone. In the last case the signs at the ends give the number of
/// crossings.
class BallExtentSearch {
public:
    /// Returns a contact at a number of bits; throws BudgetError if they are too few.
    using Contact = std::function<const ProvedContact&(long bits)>;

    /// Throws InputError for a tolerance <= 0, n = 0, or a range that is not 0 <= from < to <= 1.
    /// `contact` must outlive the object.
    BallExtentSearch(Contact contact, Edge edge, std::size_t n, Exact tolerance, ExtentRange range)
        : contact_(std::move(contact)), edge_(edge), n_(n), tolerance_(std::move(tolerance)),
          range_(std::move(range)) {}

    /// Throws a BudgetError with the reason if these bits, or `most_evaluations`, are not enough
    /// for a decision. This happens where an error touches the tolerance, or a crossing lies on an
    /// end of the range.
    [[nodiscard]] EnclosedExtents at(long bits);
    /// The number of evaluations of f over intervals and at points so far, each times its cost
    /// (proved_contact.hpp).
    [[nodiscard]] std::size_t evaluations() const { return evaluations_; }

    static constexpr std::size_t most_evaluations = 60'000;

private:
    struct Counted;
    [[nodiscard]] RelativeError error(long bits);
    void count(const RelativeError& f);
    void scan();
    /// Joins undecided pieces that are adjacent.
    static void merge_unknown(std::vector<SidePiece>& pieces);

    Contact contact_;
    Edge edge_;
    std::size_t n_;
    Exact tolerance_;
    ExtentRange range_;
    std::size_t evaluations_ = 0;
    int most_doublings_ = 5;        ///< of the bits of the scan, before it gives up
    std::vector<SidePiece> pieces_; ///< of the scan; adjacent undecided pieces are joined
};

} // namespace edgeproof::contact
