// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/escalate.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace edgeproof::audit {

/// The bits with which a question to a number of digits is looked at: from twice the bits of these
/// digits to four times as many, but not less than 4000.
[[nodiscard]] inline BitBudget bits_to_decide(unsigned digits) {
    const long first = 2 * formula::bits_for(digits);
    return {first, std::max(4 * first, 4000L)};
}

/// A sample in balls with increasing numbers of bits, until a question about it is decided.
class SampleInBalls {
public:
    /// Begins with twice the bits of `digits`.
    SampleInBalls(Sample sample, unsigned digits, unsigned integral_digits = 0)
        : sample_(std::move(sample)), digits_(digits),
          integral_digits_(integral_digits != 0 ? integral_digits : digits + 2) {}

    /// Moves the place, from the edge of the sample: a fraction of the length of the contact.
    void move_to(const Real& fraction) { fraction_ = fraction; }
    /// Calls look(EnclosedSample&), with twice the bits each time, until it returns true. Returns
    /// false if it does not do so at the maximum of bits, or if there is no enclosure; `problem`
    /// gives the reason.
    template <class Look> [[nodiscard]] bool until(const Look& look) {
        problem_ = look_closer([&](long bits) { return look(at(bits)); }, bits_to_decide(digits_));
        return problem_.empty();
    }
    /// The reason why the last question was not decided.
    [[nodiscard]] const std::string& problem() const { return problem_; }

private:
    [[nodiscard]] EnclosedSample& at(long bits) {
        auto it = levels_.find(bits);
        if (it == levels_.end()) {
            it = levels_.emplace(bits, EnclosedSample(sample_, bits, integral_digits_)).first;
        }
        if (fraction_) {
            it->second.set_place(sample_.edge, Ball(*fraction_, bits) * it->second.length());
        }
        return it->second;
    }
    Sample sample_;
    unsigned digits_;
    unsigned integral_digits_;
    std::optional<Real> fraction_;
    std::string problem_;
    std::map<long, EnclosedSample> levels_;
};

/// Returns the enclosure of a formula at a sample, right to `digits` digits if the bits are
/// sufficient; nothing if there is none.
[[nodiscard]] std::optional<Ball> enclosed(const Expr& e, const Sample& sample, unsigned digits);

/// Returns the scale of the errors of a formula at a sample: the sum of the sizes of its terms. An
/// integral counts as the sum of two parts, M has the scale P*L, and the coefficient c_k that of
/// c_0/L^k.
[[nodiscard]] Ball scale_of_terms(const Expr& e, const EnclosedSample& sample);

/// Whether the relation is =, <= or >=.
[[nodiscard]] bool allows_equality(const Relation& relation);

/// The enclosures of both sides; exactly 0 if they are the same formula with a value here. Then
/// enclosures decide relations whose sides are equal in symbols, too.
[[nodiscard]] std::pair<Ball, Ball> sides_of(const Relation& relation,
                                             const EnclosedSample& sample);

/// Whether all relations of a condition hold, by the enclosures of both sides: one that fails
/// decides. Sides that are equal to `digits` digits, relative to the sizes of their terms, satisfy
/// =, and with `agreeing` also <= and >= if their enclosures overlap. More bits may separate them,
/// so that this is considered only after these were tried.
[[nodiscard]] Decision decide(const Condition& condition, const EnclosedSample& sample,
                              double digits, bool agreeing);
/// Returns what look(EnclosedSample&, agreeing, Decision&) finds for a condition with as many
/// bits as it needs to return true. Sides that agree count as equal if nothing else decides.
template <class Look>
[[nodiscard]] Decision decide_by(const Condition& condition, SampleInBalls& sample,
                                 const Look& look) {
    Decision found;
    const bool equality = std::ranges::any_of(condition, allows_equality);
    for (const bool agreeing : {false, true}) {
        if (is_open(found) && (equality || !agreeing)) {
            static_cast<void>(
                sample.until([&](EnclosedSample& at) { return look(at, agreeing, found); }));
        }
    }
    return found;
}
/// The same for the condition itself. Nothing where the enclosures do not decide.
[[nodiscard]] Decision decide(const Condition& condition, SampleInBalls& sample, double digits);

} // namespace edgeproof::audit
