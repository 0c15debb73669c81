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

/// Answers held against the references, to be reported.
struct Conformance {
    conformance::Answers answers;
    conformance::Target target;
    conformance::Agreements agreements;
    std::vector<conformance::Convention> conventions;

    /// No fault, nothing missing, no convention but ours, and every answer within the target.
    [[nodiscard]] bool pass() const;
    [[nodiscard]] bool failed(std::size_t i) const; ///< that answer
};

/// What is reported of answers that are held against references block by block: of a block nothing
/// is kept but counts, the worst case of each regime, and the complaints that are shown.
class ConformanceSummary {
public:
    /// `errors`: the complaints shown at most.
    ConformanceSummary(const conformance::Target& target, std::size_t errors)
        : target_(target), errors_(errors) {}

    /// The next answers; their target is that of the summary. Those of all blocks count as one.
    void add(const conformance::Answers& answers, const conformance::Agreements& agreements);
    /// `unexplained`: quantities that none of them explains.
    void add(const std::vector<conformance::Convention>& conventions,
             const std::vector<std::string>& unexplained);
    /// A line above the outcome.
    void note(std::string line) { notes_.push_back(std::move(line)); }

    [[nodiscard]] bool pass() const;
    /// For people: failing cases, faults, the table by regime with its worst cases, the
    /// conventions, and the outcome in the last line.
    [[nodiscard]] std::string text() const;

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
        std::size_t explained =
            0; ///< short of the target's digits, by what the conditioning explains
        std::optional<Worst> worst; ///< of the answers that are numbers
        /// How many of those have so many tenths of a digit, which is how they are shown.
        std::map<long, std::size_t> tenths;
    };
    /// Every question is in one of the first four; the faults are of the rows as a whole.
    struct Counts {
        std::size_t failures = 0; ///< answers that are not within the target
        std::size_t missing = 0;
        std::size_t ended = 0; ///< questions that ended the program
        std::size_t nothing_to_compare_with = 0;
        std::size_t answers = 0; ///< rows to questions, whatever stands in them
    };
    void complain(Complaints& to, const std::string& line) const;
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

/// The summary of all at once.
[[nodiscard]] std::string conformance_text(const Conformance& c, std::size_t errors);

/// JUnit XML: a test case an answer, and one for the faults.
[[nodiscard]] std::string conformance_junit(const Conformance& c);

} // namespace edgeproof::report
