// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/tail/followed.hpp"

#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/checks/tail/parameter_sweep.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace edgeproof::audit {
namespace {

/// Decades from the last listed value.
constexpr std::array<unsigned, 22> stations{1,  2,  3,  4,  5,   6,   7,   8,   12,  16,  24,
                                            32, 48, 64, 96, 128, 192, 256, 384, 512, 768, 1024};
constexpr unsigned first_judged = 128;
constexpr unsigned farthest_of_integrals = 16;
constexpr std::size_t least_points = 5;
constexpr double margin = 20;      ///< required decades of decrease, plus those hidden
constexpr double short_margin = 4; ///< the same where enclosures end early
constexpr double most_decades = 4000;
constexpr long relative_bits = 30; ///< required relative accuracy of a gap
constexpr double least_steadiness = 0.5;

double decades_of_exact(const Exact& x) {
    try {
        return std::abs(decades_of(formula::ball_of(x, 256)).value_or(0));
    } catch (const Error&) {
        return 0;
    }
}

/// True if the slopes of a sequence over the stations have one sign, and the last is not much less
/// than the others: this holds for a power of the distance, or a faster change.
bool is_steady(const std::vector<Ball>& d, const std::vector<unsigned>& decades, bool rising) {
    double most = 0;
    double last = 0;
    for (std::size_t i = 0; i + 1 < d.size(); ++i) {
        const auto from = decades_of(d[i]);
        const auto to = decades_of(d[i + 1]);
        if (!from || !to) {
            return false;
        }
        const double slope = (rising ? *to - *from : *from - *to) / (decades[i + 1] - decades[i]);
        if (slope <= 0) {
            return false;
        }
        most = std::max(most, slope);
        last = slope;
    }
    return last >= least_steadiness * most;
}

/// Returns nothing for numbers beyond 10^100000, or as near to zero; they have no decimals here.
std::optional<std::string> printed_text(const Ball& x) {
    constexpr unsigned digits_shown = 12;
    try {
        return ball_text(x, digits_shown);
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// Returns the limit of the values in `along`; other numbers of the sample may be its units.
std::optional<SweepTarget> target_of(const ParameterSweep& sweep, std::size_t sample) {
    std::vector<Exact> listed;
    for (std::size_t j = 0; j < sweep.values().size(); ++j) {
        listed.push_back(sweep.value_at(j, sample));
    }
    const Sample& at = sweep.sample_at(0, sample);
    std::vector<Exact> units;
    for (const auto* names : {&at.scene.parameters, &at.variables}) {
        for (const auto& [name, value] : *names) {
            if (name != sweep.name()) {
                units.push_back(value);
            }
        }
    }
    return SweepTarget::of(listed, units);
}

class TailFollower {
public:
    TailFollower(const ParameterSweep& sweep, std::size_t sample, const SweepTarget& target,
                 const LimitClaimed& claimed, unsigned digits)
        : sweep_(sweep), sample_(sample), target_(target), claimed_(claimed), digits_(digits) {
        find_scales();
        if (problem_.empty()) {
            follow();
        }
    }
    [[nodiscard]] FollowedTail result() const {
        return {decision_, problem_, target_.text(), decades(), texts(), compared_};
    }

private:
    struct Point {
        unsigned decades = 0;
        Ball value;
        Ball difference; ///< value - limit, or value if the limit is infinity
        Ball gap;        ///< |difference|
    };
    void find_scales();
    void follow();
    [[nodiscard]] bool add(unsigned decades, std::size_t which);
    void judge();
    void judge_finite();
    void judge_infinite();
    /// Sets the decision, if there is one, and shows that `first` (if there is none, the step
    /// before) differs from the last of a sequence for which this is certain.
    void decide(const Decision& decision, std::string_view first_name,
                const std::optional<Ball>& first, std::string_view second_name,
                const std::vector<Ball>& sequence);
    [[nodiscard]] bool sums_settle() const;
    [[nodiscard]] std::vector<Ball> gaps() const;
    [[nodiscard]] std::vector<Ball> steps() const;
    [[nodiscard]] bool dies_away(const std::vector<Ball>& d, const Ball& reference) const;
    [[nodiscard]] bool grows(const std::vector<Ball>& d, const Ball& reference) const;
    [[nodiscard]] std::vector<std::string> texts() const;

    [[nodiscard]] bool is_short() const { return !ended_by_.empty(); }
    [[nodiscard]] unsigned decades() const { return points_.empty() ? 0 : points_.back().decades; }
    [[nodiscard]] Sample sample_at(unsigned decades, std::size_t which) const {
        return decades == 0 ? sweep_.last_sample(sample_)
                            : sweep_.sample_with(target_.beyond(decades, which), sample_);
    }
    [[nodiscard]] unsigned digits_at(unsigned decades) const {
        const double more = decades + target_.decades() + 2 * hidden_ + margin;
        return digits_ + static_cast<unsigned>(std::min(more, most_decades));
    }
    [[nodiscard]] Ball tolerance() const {
        const double needed =
            is_short() ? short_margin + hidden_ : margin + 2 * hidden_ + scene_decades_;
        return pow_int(Ball(10, formula::bits_for(static_cast<unsigned>(needed) + digits_)),
                       -static_cast<long>(std::ceil(needed)));
    }

    const ParameterSweep& sweep_;
    std::size_t sample_;
    const SweepTarget& target_;
    const LimitClaimed& claimed_;
    unsigned digits_;
    bool costly_ = false;       ///< integrals, or a curved profile
    double hidden_ = 0;         ///< decades that the formulas may hide
    double scene_decades_ = 0;  ///< from the scene's parameters
    std::optional<Ball> scale_; ///< of the gap
    std::vector<Point> points_; ///< from the last listed value on
    std::string ended_by_;      ///< why there is no further enclosure
    Decision decision_;
    std::string problem_;
    std::optional<Evidence> compared_;
};

/// Finds what the formulas may hide, and the scale of the gap at the first listed value.
void TailFollower::find_scales() {
    const Sample& sample = sweep_.sample_at(0, sample_);
    const long bits = 2 * formula::bits_for(digits_at(0));
    try {
        const EnclosedSample before(sample, bits);
        const EnclosedSample after(sweep_.last_sample(sample_), bits);
        const SweptPair pair{before, after};
        const Expr difference = claimed_.difference();
        hidden_ = hidden_decades(difference, pair);
        Ball scale = abs(before.evaluate(difference));
        if (claimed_.limit) {
            scale = max(scale, abs(before.evaluate(*claimed_.limit)));
        }
        if (!certainly_positive(scale)) {
            scale = claimed_.limit ? scale_of_terms(difference, before)
                                   : abs(after.evaluate(difference));
        }
        if (scale.is_finite() && certainly_positive(scale)) {
            scale_ = scale;
        }
    } catch (const Error& error) {
        problem_ = error.what();
        return;
    }
    for (const auto& [name, value] : sample.scene.parameters) {
        scene_decades_ += name == sweep_.name() ? 0 : decades_of_exact(value);
    }
    if (!(margin + 2 * hidden_ + scene_decades_ < most_decades)) {
        problem_ = "the formula has numbers beyond the range that is followed";
    }
}

bool TailFollower::add(unsigned decades, std::size_t which) {
    std::optional<Point> point;
    try {
        const unsigned digits = digits_at(decades);
        SampleInBalls sample(sample_at(decades, which), digits, costly_ ? digits_ + 20 : 0);
        const bool decided = sample.until([&](const EnclosedSample& at) {
            Point found{decades, at.evaluate(claimed_.of), {}, {}};
            found.difference =
                claimed_.limit ? found.value - at.evaluate(*claimed_.limit) : found.value;
            found.gap = abs(found.difference);
            if (!found.value.is_finite() || !found.gap.is_finite()) {
                return false;
            }
            point = found;
            return found.gap.relative_accuracy_bits() >= relative_bits ||
                   (scale_ && certainly_less(found.gap * Ball(10, 64), tolerance() * *scale_));
        });
        if (!decided && !point) {
            ended_by_ = sample.problem();
        }
    } catch (const Error& error) {
        ended_by_ = error.what(); // the family does not admit the value, or there is no enclosure
    }
    if (point) {
        points_.push_back(std::move(*point));
    }
    return point.has_value();
}

void TailFollower::follow() {
    const Sample& first = sweep_.sample_at(0, sample_);
    costly_ = has_binder(claimed_.of) || (claimed_.limit && has_binder(*claimed_.limit)) ||
              !contact::BallContact::has_closed_form(first.scene.make_profile());
    std::size_t which = 0;
    bool more = add(0, which++);
    for (const unsigned decades : stations) {
        if (!more) {
            break;
        }
        check_interruption();
        if (costly_ && decades > farthest_of_integrals) {
            ended_by_ = "integrals are not followed further";
            break;
        }
        more = add(decades, which++);
        if (more && decades >= first_judged) {
            judge();
            if (!is_open(decision_)) {
                return;
            }
        }
    }
    if (is_short()) {
        judge();
    }
    if (is_open(decision_) && problem_.empty()) {
        problem_ = points_.size() < least_points && is_short()
                       ? "no enclosures near the end of the sweep: " + ended_by_
                       : "the values up to 10^" + std::to_string(decades()) +
                             " times as far do not show the limit";
    }
}

std::vector<Ball> TailFollower::gaps() const {
    std::vector<Ball> all;
    for (const Point& point : points_) {
        all.push_back(point.gap);
    }
    return all;
}

std::vector<Ball> TailFollower::steps() const {
    std::vector<Ball> all;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
        all.push_back(abs(points_[i + 1].difference - points_[i].difference));
    }
    return all;
}

/// True if the last three values are certainly less than the tolerance times `reference`, and each
/// is at most half of the previous one or not distinguished from zero. If the enclosures end early,
/// all values must also decrease steadily.
bool TailFollower::dies_away(const std::vector<Ball>& d, const Ball& reference) const {
    if (points_.size() < least_points) {
        return false;
    }
    const Ball most = tolerance() * reference;
    const std::size_t n = d.size();
    // If they end early, a decrease faster than a power law is visible at the last station only.
    const std::size_t below = is_short() ? 1 : 3;
    for (std::size_t i = n - below; i < n; ++i) {
        if (!certainly_less(d[i], most) ||
            !(contains_zero(d[i]) || certainly_less(d[i] * 2, d[i - 1]))) {
            return false;
        }
    }
    if (!is_short()) {
        return true;
    }
    std::vector<Ball> before;
    std::vector<unsigned> decades;
    for (std::size_t i = 0; i < n; ++i) {
        if (i > 0 && !certainly_less(d[i], d[i - 1]) && !certainly_less(d[i], most)) {
            return false;
        }
        if (!contains_zero(d[i])) {
            before.push_back(d[i]);
            decades.push_back(points_[points_.size() - n + i].decades);
        }
    }
    return before.size() < 2 || is_steady(before, decades, false);
}

bool TailFollower::grows(const std::vector<Ball>& d, const Ball& reference) const {
    if (points_.size() < least_points || !certainly_less(reference, tolerance() * d.back())) {
        return false;
    }
    const std::size_t n = d.size();
    for (std::size_t i = n - std::min<std::size_t>(n - 1, 4); i < n; ++i) {
        if (!certainly_less(d[i - 1], d[i])) {
            return false;
        }
    }
    if (!is_short()) {
        return true;
    }
    std::vector<unsigned> decades;
    for (const Point& point : points_) {
        decades.push_back(point.decades);
    }
    return is_steady(d, decades, true);
}

/// True if the sums of the formulas have reached their final form between half-way and the end.
bool TailFollower::sums_settle() const {
    const std::size_t last = points_.size() - 1;
    std::size_t half = last;
    while (half > 0 && 2 * points_[half].decades > points_[last].decades) {
        --half;
    }
    try {
        const long bits = 2 * formula::bits_for(digits_at(points_[last].decades));
        const EnclosedSample before(sample_at(points_[half].decades, half), bits);
        const EnclosedSample after(sample_at(points_[last].decades, last), bits);
        const SweptPair pair{before, after};
        return sums_are_steady(claimed_.of, pair) &&
               (!claimed_.limit || sums_are_steady(*claimed_.limit, pair));
    } catch (const Error&) {
        return false;
    }
}

void TailFollower::judge() {
    if (points_.size() < least_points) {
        return;
    }
    if (claimed_.limit) {
        judge_finite();
    } else {
        judge_infinite();
    }
    if (!is_open(decision_) && !sums_settle()) {
        decision_ = {};
        compared_.reset();
    }
}

void TailFollower::judge_finite() {
    const std::vector<Ball> gap = gaps();
    const Ball& last = gap.back();
    const char* distance = "distance from the limit";
    if (!scale_) {
        // If all gaps are zero, they must be exactly zero.
        const Ball one(1, last.bits());
        if (std::ranges::all_of(gap,
                                [](const Ball& d) { return d.is_exact() && contains_zero(d); })) {
            decide(decision({}, Confirmation::agreement(last, one - one, one, digits_)), "scale",
                   one, distance, gap);
        }
    } else if (dies_away(gap, *scale_)) {
        decide(decision({}, Confirmation::less(last, tolerance() * *scale_)), "scale", scale_,
               distance, gap);
    } else if (certainly_positive(last) && dies_away(steps(), last)) {
        decide(decision(Refutation::less(steps().back(), tolerance() * last), {}), "last step", {},
               distance, gap);
    } else if (grows(gap, *scale_)) {
        decide(decision(Refutation::less(*scale_, tolerance() * last), {}), "scale", scale_,
               distance, gap);
    }
}

void TailFollower::judge_infinite() {
    const std::vector<Ball> size = gaps();
    const Ball& last = size.back();
    if (scale_ && grows(size, *scale_)) {
        // The value is compared with its sign, as minus infinity is not infinity.
        const Ball& value = points_.back().value;
        decide(decision(Refutation::less(value, -*scale_),
                        Confirmation::less(*scale_, tolerance() * value)),
               "size of the first value", scale_, "last size", size);
    } else if (certainly_positive(last) && dies_away(steps(), last)) {
        decide(decision(Refutation::less(steps().back(), tolerance() * last), {}), "last step", {},
               "last value", size);
    } else if (scale_ && dies_away(size, *scale_)) {
        decide(decision(Refutation::less(last, tolerance() * *scale_), {}), "first value", scale_,
               "last value", size);
    }
}

void TailFollower::decide(const Decision& decision, std::string_view first_name,
                          const std::optional<Ball>& first, std::string_view second_name,
                          const std::vector<Ball>& sequence) {
    decision_ = decision;
    const std::vector<Ball> step = steps();
    for (std::size_t i = is_open(decision) ? 1 : sequence.size(); i-- > 1;) {
        const Ball& other = first ? *first : step[i - 1];
        if (printed_text(other) && printed_text(sequence[i]) && disjoint(other, sequence[i])) {
            const Sample& last = sweep_.last_sample(sample_);
            compared_ = pair_evidence(full_text(last) + "; followed from there", first_name, other,
                                      second_name, sequence[i], digits_);
            return;
        }
    }
}

std::vector<std::string> TailFollower::texts() const {
    std::vector<std::string> all;
    for (std::size_t i = 1; i < points_.size(); ++i) {
        const auto text = printed_text(points_[i].value);
        if (text && (i + 4 >= points_.size() || i % 4 == 1)) {
            all.push_back("about 10^" + std::to_string(points_[i].decades) +
                          (target_.is_infinite() ? " times the last value: "
                                                 : " times as near as the last value: ") +
                          *text);
        }
    }
    return all;
}

} // namespace

FollowedTail follow_tail(const ParameterSweep& sweep, std::size_t sample,
                         const LimitClaimed& claimed, unsigned digits) {
    if (const auto target = target_of(sweep, sample)) {
        return TailFollower(sweep, sample, *target, claimed, digits).result();
    }
    FollowedTail none;
    none.problem = "the values of " + sweep.name() +
                   " do not show which value it approaches; list values that halve, or double, at "
                   "each step, or whose distance from a simple number halves";
    return none;
}

} // namespace edgeproof::audit
