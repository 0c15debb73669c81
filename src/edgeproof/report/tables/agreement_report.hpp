// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/causes/convention.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::report {

/// The comparison of answers with the references, for a report.
struct Conformance {
    conformance::Answers answers;
    conformance::Target target;
    conformance::Agreements agreements;
    std::vector<conformance::Convention> conventions;

    /// True without faults, missing answers and foreign conventions, if every answer is within the
    /// target.
    [[nodiscard]] bool pass() const;
    [[nodiscard]] bool failed(std::size_t i) const; ///< True if answer i fails
};

/// The report of answers compared with references block by block. Only counts, the worst case of
/// each regime, and the complaints to be shown are kept of a block.
class ConformanceSummary {
public:
    /// `errors`: the most complaints shown.
    ConformanceSummary(const conformance::Target& target, std::size_t errors)
        : target_(target), errors_(errors) {}

    /// Adds answers, compared with the target of the summary. The answers of all blocks form one
    /// set.
    void add(const conformance::Answers& answers, const conformance::Agreements& agreements);
    /// `unexplained`: the quantities that no convention explains.
    void add(const std::vector<conformance::Convention>& conventions,
             const std::vector<std::string>& unexplained);
    void note(std::string line) { notes_.push_back(std::move(line)); }

    [[nodiscard]] bool pass() const;
    /// Returns the report as text: the outcome in the first line, the causes with that of most rows
    /// first, faults and failing cases, and the table by regime with its worst cases.
    [[nodiscard]] std::string text() const;
    /// Returns {"passes", "rows", "failures", "causes": [{"name", "factor", "rows",
    /// "equally_likely", "remainder", "of", "relation"}]}; the cause of most rows comes first.
    /// `remainder`: the relative error that nine of ten of those rows do not exceed after
    /// correction.
    [[nodiscard]] std::string json() const;

private:
    /// Lines of which only the first few are shown.
    struct Complaints {
        std::vector<std::string> shown;
        std::size_t count = 0;
    };
    struct Worst {
        conformance::CaseAgreement held;
        std::string id;
    };
    struct Tally {
        std::size_t rows = 0;
        std::size_t failed = 0;
        std::size_t explained = 0;  ///< below the target, but explained by the conditioning
        std::optional<Worst> worst; ///< of the answers that are numbers
        /// The distribution of their digits, in tenths as shown.
        std::map<long, std::size_t> tenths;
    };
    /// Every question is in one of the first four counts; faults concern whole rows.
    struct Counts {
        std::size_t failures = 0; ///< answers outside the target
        std::size_t missing = 0;
        std::size_t ended = 0; ///< questions that crashed the program
        std::size_t nothing_to_compare_with = 0;
        std::size_t answers = 0; ///< rows with an answer of any kind
    };
    void complain(Complaints& to, const std::string& line) const;
    [[nodiscard]] std::vector<const conformance::Convention*> most_likely_first() const;
    [[nodiscard]] std::string regimes_text() const;
    [[nodiscard]] std::string outcome_text() const;

    conformance::Target target_;
    std::size_t errors_;
    unsigned digits_ = 0;
    Complaints faults_;
    Complaints failures_;
    std::map<conformance::Regime, Tally> tallies_;
    Counts counts_;
    std::size_t cases_ = 0;
    std::size_t estimates_ = 0;
    std::size_t out_of_order_ = 0;
    std::vector<conformance::Convention> conventions_;
    std::vector<std::string> notes_;
};

/// Returns the report of all answers at once.
[[nodiscard]] ConformanceSummary summary_of(const Conformance& c, std::size_t errors);
[[nodiscard]] std::string conformance_text(const Conformance& c, std::size_t errors);

/// Returns JUnit XML: a test case per answer, and one for the faults.
[[nodiscard]] std::string conformance_junit(const Conformance& c);

} // namespace edgeproof::report
