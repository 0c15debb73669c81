// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/proved_pressure.hpp"
#include "edgeproof/contact/law/load.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace edgeproof::contact {

/// Where n terms are within a tolerance of the pressure (extent.hpp), proved: every u of the range
/// is shown to be on one side of the tolerance, or lies in a crossing.
struct EnclosedExtents {
    Ball first_exit; ///< no u of the range before it reaches the tolerance; the range's end if none
    Ball measure;
    std::vector<Ball> crossings; ///< in order; beside a corner a crossing may stand for 1, 3, ...
    bool leaves = true;
    bool starts_within = true; ///< within the tolerance where the range begins
    /// Whether each crossing's ball holds exactly one root, the error being monotone there.
    std::vector<bool> single;
    Ball length; ///< a + b
};

/// The search. Next to the edge the omitted terms are bounded by a majorant of the expansion; from
/// there on p and its Taylor remainder are enclosed over intervals, halved until f = p_local/p - 1
/// is certainly within the tolerance, certainly beyond it, or certainly monotone, when the signs at
/// the interval's ends tell how often the tolerance is crossed.
class BallExtentSearch {
public:
    /// A contact at a number of bits; throws BudgetError where they are too few.
    using Contact = std::function<const ProvedPressure&(long bits)>;

    /// Throws InputError as within_tolerance does. `contact` outlives the object.
    BallExtentSearch(Contact contact, Edge edge, std::size_t n, const formula::Exact& tolerance,
                     ExtentRange range);
    ~BallExtentSearch();
    BallExtentSearch(const BallExtentSearch&) = delete;
    BallExtentSearch& operator=(const BallExtentSearch&) = delete;

    /// Throws BudgetError, saying why, where so many bits, or `most_evaluations`, do not decide: an
    /// error that touches the tolerance, or a crossing on an end of the range.
    [[nodiscard]] EnclosedExtents at(long bits);
    /// Of f over intervals and at points, so far, each times its cost (proved_pressure.hpp).
    [[nodiscard]] std::size_t evaluations() const;

    static constexpr std::size_t most_evaluations = 60'000;

private:
    class Search;
    std::unique_ptr<Search> search_;
};

} // namespace edgeproof::contact
