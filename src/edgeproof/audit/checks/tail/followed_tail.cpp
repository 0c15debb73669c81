// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/tail/followed_tail.hpp"

#include "edgeproof/audit/checks/tail/hidden_terms.hpp"
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

double decades_of_exact(const formula::Exact& x) {
    try {
        const auto decades = decades_of(formula::ball_of(x, 256));
        return decades ? std::abs(*decades) : 0;
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

} // namespace

bool can_be_printed(const Ball& x) {
    try {
        return !ball_text(x, 5).empty();
    } catch (const Error&) {
        return false;
    }
}

FollowedTail::FollowedTail(const ParameterSweep& sweep, std::size_t sample, SweepTarget target,
                           LimitClaimed claimed, unsigned digits)
    : sweep_(sweep), sample_(sample), target_(std::move(target)), claimed_(std::move(claimed)),
      digits_(digits) {
    find_scales();
    if (problem_.empty()) {
        follow();
    }
}

unsigned FollowedTail::decades() const { return points_.empty() ? 0 : points_.back().decades; }

bool FollowedTail::is_costly() const {
    const Sample& sample = sweep_.sample_at(0, sample_).sample;
    return has_binder(claimed_.of) || (claimed_.limit && has_binder(*claimed_.limit)) ||
           !contact::BallContact::has_closed_form(sample.scene.make_profile());
}

unsigned FollowedTail::digits_at(unsigned decades) const {
    const double more = decades + target_.decades() + 2 * hidden_ + margin;
    return digits_ + static_cast<unsigned>(std::min(more, most_decades));
}

Ball FollowedTail::tolerance() const {
    const double needed =
        is_short() ? short_margin + hidden_ : margin + 2 * hidden_ + scene_decades_;
    return pow_int(Ball(10, formula::bits_for(static_cast<unsigned>(needed) + digits_)),
                   -static_cast<long>(std::ceil(needed)));
}

/// Finds what the formulas may hide, and the scale of the gap at the first listed value.
void FollowedTail::find_scales() {
    const std::size_t last = sweep_.values().size() - 1;
    const Sample& sample = sweep_.sample_at(0, sample_).sample;
    const long bits = 2 * formula::bits_for(digits_at(0));
    try {
        const EnclosedSample before(sample, bits);
        const EnclosedSample after(sweep_.sample_at(last, sample_).sample, bits);
        const SweptPair pair{before, after};
        const formula::Expr difference = claimed_.difference();
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

Sample FollowedTail::sample_at(unsigned decades, std::size_t which) const {
    return decades == 0 ? sweep_.sample_at(sweep_.values().size() - 1, sample_).sample
                        : sweep_.sample_with(target_.beyond(decades, which), sample_);
}

bool FollowedTail::add(unsigned decades, std::size_t which) {
    std::optional<Point> point;
    try {
        const unsigned digits = digits_at(decades);
        SampleInBalls sample(sample_at(decades, which), digits, is_costly() ? digits_ + 20 : 0);
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

void FollowedTail::follow() {
    const bool costly = is_costly();
    std::size_t which = 0;
    bool more = add(0, which++);
    for (const unsigned decades : stations) {
        if (!more) {
            break;
        }
        check_interruption();
        if (costly && decades > farthest_of_integrals) {
            ended_by_ = "integrals are not followed further";
            break;
        }
        more = add(decades, which++);
        if (more && decades >= first_judged) {
            judge();
            if (!std::holds_alternative<std::monostate>(decision_)) {
                return;
            }
        }
    }
    if (is_short()) {
        judge();
    }
    if (std::holds_alternative<std::monostate>(decision_) && problem_.empty()) {
        problem_ = points_.size() < least_points && is_short()
                       ? "no enclosures near the end of the sweep: " + ended_by_
                       : "the values up to 10^" + std::to_string(decades()) +
                             " times as far do not show the limit";
    }
}

std::vector<Ball> FollowedTail::gaps() const {
    std::vector<Ball> all;
    for (const Point& point : points_) {
        all.push_back(point.gap);
    }
    return all;
}

std::vector<Ball> FollowedTail::steps() const {
    std::vector<Ball> all;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
        all.push_back(abs(points_[i + 1].difference - points_[i].difference));
    }
    return all;
}

/// True if the last three values are certainly less than the tolerance times `reference`, and each
/// is at most half of the previous one or not distinguished from zero. If the enclosures end early,
/// all values must also decrease steadily.
bool FollowedTail::dies_away(const std::vector<Ball>& d, const Ball& reference) const {
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

bool FollowedTail::grows(const std::vector<Ball>& d, const Ball& reference) const {
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
bool FollowedTail::sums_settle() const {
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

void FollowedTail::judge() {
    if (points_.size() < least_points) {
        return;
    }
    if (claimed_.is_infinite()) {
        judge_infinite();
    } else {
        judge_finite();
    }
    if (!std::holds_alternative<std::monostate>(decision_) && !sums_settle()) {
        decision_ = {};
        compared_.reset();
    }
}

void FollowedTail::judge_finite() {
    const std::vector<Ball> gap = gaps();
    const Ball& last = gap.back();
    if (!scale_) {
        // If all gaps are zero, they must be exactly zero.
        const bool zero = std::all_of(
            gap.begin(), gap.end(), [](const Ball& d) { return d.is_exact() && contains_zero(d); });
        if (const auto equal =
                Confirmation::agreement(last, Ball(0, last.bits()), Ball(1, last.bits()), digits_);
            zero && equal) {
            decision_ = *equal;
            compare("scale", Ball(1, last.bits()), "distance from the limit", gap);
        }
        return;
    }
    if (dies_away(gap, *scale_)) {
        if (const auto holds = Confirmation::less(last, tolerance() * *scale_)) {
            decision_ = *holds;
            compare("scale", *scale_, "distance from the limit", gap);
        }
    } else if (certainly_positive(last) && dies_away(steps(), last)) {
        if (const auto fails = Refutation::less(steps().back(), tolerance() * last)) {
            decision_ = *fails;
            compare("last step", std::nullopt, "distance from the limit", gap);
        }
    } else if (grows(gap, *scale_)) {
        if (const auto fails = Refutation::less(*scale_, tolerance() * last)) {
            decision_ = *fails;
            compare("scale", *scale_, "distance from the limit", gap);
        }
    }
}

void FollowedTail::judge_infinite() {
    const std::vector<Ball> size = gaps();
    const Ball& last = size.back();
    if (scale_ && grows(size, *scale_)) {
        // The value is compared with its sign, as minus infinity is not infinity.
        const Ball& value = points_.back().value;
        decision_ = edgeproof::audit::decision(Refutation::less(value, -*scale_),
                                               Confirmation::less(*scale_, tolerance() * value));
        compare("size of the first value", *scale_, "last size", size);
    } else if (certainly_positive(last) && dies_away(steps(), last)) {
        if (const auto fails = Refutation::less(steps().back(), tolerance() * last)) {
            decision_ = *fails;
            compare("last step", std::nullopt, "last value", size);
        }
    } else if (scale_ && dies_away(size, *scale_)) {
        if (const auto fails = Refutation::less(last, tolerance() * *scale_)) {
            decision_ = *fails;
            compare("first value", *scale_, "last value", size);
        }
    }
}

/// Finds the last value of a sequence that can be printed and certainly differs from `first` (from
/// the previous step if there is no `first`).
void FollowedTail::compare(const std::string& first_name, const std::optional<Ball>& first,
                           const std::string& second_name, const std::vector<Ball>& sequence) {
    const std::vector<Ball> step = steps();
    for (std::size_t i = sequence.size(); i-- > 1;) {
        const Ball& other = first ? *first : step[i - 1];
        if (can_be_printed(other) && can_be_printed(sequence[i]) && disjoint(other, sequence[i])) {
            compared_ = Compared{first_name, other, second_name, sequence[i]};
            return;
        }
    }
}

std::vector<std::string> FollowedTail::texts() const {
    constexpr unsigned digits_shown = 12;
    std::vector<std::string> all;
    for (std::size_t i = 1; i < points_.size(); ++i) {
        const bool shown = i + 4 >= points_.size() || i % 4 == 1;
        if (shown && can_be_printed(points_[i].value)) {
            all.push_back("about 10^" + std::to_string(points_[i].decades) +
                          (target_.is_infinite() ? " times the last value: "
                                                 : " times as near as the last value: ") +
                          ball_text(points_[i].value, digits_shown));
        }
    }
    return all;
}

} // namespace edgeproof::audit
