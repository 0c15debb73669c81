// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/ledger/judgement.hpp"

#include <algorithm>
#include <cmath>

namespace edgeproof::audit {

std::optional<Refutation> Refutation::disjoint(const Ball& claimed, const Ball& found) {
    const bool finite = claimed.is_finite() && found.is_finite();
    return finite && !overlaps(claimed, found) ? std::optional(Refutation()) : std::nullopt;
}

namespace {

bool proved_less(const Ball& x, const Ball& y, bool or_equal) {
    return x.is_finite() && y.is_finite() &&
           (or_equal ? arb_le(x.data(), y.data()) != 0 : certainly_less(x, y));
}

} // namespace

std::optional<Refutation> Refutation::less(const Ball& x, const Ball& y, bool or_equal) {
    return proved_less(x, y, or_equal) ? std::optional(Refutation()) : std::nullopt;
}

std::optional<Confirmation> Confirmation::less(const Ball& x, const Ball& y, bool or_equal) {
    return proved_less(x, y, or_equal) ? std::optional(Confirmation()) : std::nullopt;
}

namespace {

/// 10^-digits of the scale.
Ball tolerance(const Ball& scale, double digits) {
    return pow_int(Ball(10, scale.bits()), -static_cast<long>(std::ceil(digits))) * scale;
}

} // namespace

std::optional<Confirmation> Confirmation::agreement(const Ball& claimed, const Ball& found,
                                                    const Ball& scale, double digits) {
    if (!claimed.is_finite() || !found.is_finite()) {
        return std::nullopt;
    }
    const Ball off = abs(claimed - found);
    if (arb_is_zero(off.data()) != 0) {
        return Confirmation();
    }
    if (!scale.is_finite() || !certainly_positive(scale) ||
        !certainly_less(off, tolerance(scale, digits))) {
        return std::nullopt;
    }
    return Confirmation();
}

std::optional<Confirmation> Confirmation::within(const Ball& x, const Rational& lower,
                                                 const Rational& upper) {
    const Ball from_lower = x - Ball(lower, x.bits());
    const bool holds = x.is_finite() && arb_is_nonnegative(from_lower.data()) != 0 &&
                       certainly_less(x, Ball(upper, x.bits()));
    return holds ? std::optional(Confirmation()) : std::nullopt;
}

Decision decision(const std::optional<Refutation>& fails,
                  const std::optional<Confirmation>& holds) {
    return fails ? Decision(*fails) : holds ? Decision(*holds) : Decision();
}

Decision equality(const Ball& claimed, const Ball& found, const std::optional<Ball>& scale,
                  double digits) {
    const Decision apart = decision(Refutation::disjoint(claimed, found), {});
    if (!scale) {
        return apart;
    }
    const auto agrees = Confirmation::agreement(claimed, found, *scale, digits);
    return agrees                                                            ? Decision(*agrees)
           : certainly_less(tolerance(*scale, digits), abs(claimed - found)) ? apart
                                                                             : Decision();
}

Judgement::Judgement(const Decision& decision) {
    if (refutes(decision)) {
        verdict_ = Verdict::refuted;
    } else if (confirms(decision)) {
        verdict_ = Verdict::confirmed;
    }
}

Judgement Judgement::of_all(const std::vector<Decision>& parts) {
    if (std::ranges::any_of(parts, refutes)) {
        return Judgement(Verdict::refuted);
    }
    return !parts.empty() && std::ranges::all_of(parts, confirms) ? Judgement(Verdict::confirmed)
                                                                  : Judgement();
}

Judgement Judgement::of_readings(const std::vector<Judgement>& readings) {
    const auto count = [&](auto&& test) { return std::ranges::count_if(readings, test); };
    const auto n = static_cast<std::ptrdiff_t>(readings.size());
    const auto holding = count([](Verdict v) { return holds(v); });
    const auto is = [&](Verdict which) { return count([&](Verdict v) { return v == which; }); };
    if (n == 0) {
        return {};
    }
    if (holding == n) {
        if (is(Verdict::definition) == n) {
            return definition();
        }
        return is(Verdict::proved) + is(Verdict::definition) == n ? proved_by_symbols()
                                                                  : Judgement(Verdict::confirmed);
    }
    if (holding > 0) {
        const auto known_not =
            is(Verdict::refuted) + is(Verdict::imprecise) + is(Verdict::underspecified);
        return known_not > 0 ? Judgement(Verdict::imprecise) : Judgement();
    }
    return is(Verdict::undecided) > 0 ? Judgement() : readings.front();
}

std::string_view name_of(Verdict verdict) {
    static constexpr std::array<std::string_view, all_verdicts.size()> names{
        "proved", "confirmed", "imprecise", "refuted", "underspecified", "undecided", "definition"};
    return names.at(static_cast<std::size_t>(verdict));
}

} // namespace edgeproof::audit
