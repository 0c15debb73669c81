// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/ledger.hpp"

#include <span>
#include <string_view>

namespace edgeproof::certificate {

/// In place of a unit: the values grow without bound, and the places are to the right of x = 0.
inline constexpr std::string_view growing = "growing";

/// The content of a claim, in the syntax of ledgers: "gp" is the slope of a tilted punch. Two
/// formulas are equal if they are the same tree, with the definitions of the ledger put in.
struct Said {
    std::string_view of = ""; ///< of a series: the edge
    /// The limit, or the sense of a monotone claim; ">" and "<" as in signs_of_terms().
    std::string_view says = "";
    std::string_view along = ""; ///< a parameter of the family
    std::string_view unit = "";  ///< this parameter, divided by `unit`, ends at `end`
    double end = 0;
    std::string_view where = "";
    std::string_view also = ""; ///< the formula of a second reading
};

/// A claim for which the Coq files have a theorem: its kind, what it says, and the scenes that the
/// theorem is about.
struct Listed {
    std::string_view kind;
    Said said;
    bool (*about)(const audit::SceneSpec&);
    std::string_view parameters; ///< of the theorem: "phi a : R"
    std::string_view statement;
    std::string_view proof;
    std::string_view states;
    std::string_view leaves_out = "";
    bool whole = true;
};

/// Returns all of them. If several are about a claim, the first is stated.
[[nodiscard]] std::span<const Listed> listed_statements();

} // namespace edgeproof::certificate
