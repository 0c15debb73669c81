// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ledger/judgement.hpp"

#include <algorithm>
#include <cmath>

namespace edgeproof::audit {

std::optional<Refutation> Refutation::disjoint(const Ball& claimed, const Ball& found) {
    if (!claimed.is_finite() || !found.is_finite() || overlaps(claimed, found)) {
        return std::nullopt;
    }
    return Refutation();
}

std::optional<Refutation> Refutation::less(const Ball& x, const Ball& y) {
    if (!x.is_finite() || !y.is_finite() || !certainly_less(x, y)) {
        return std::nullopt;
    }
    return Refutation();
}

std::optional<Confirmation> Confirmation::agreement(const Ball& claimed, const Ball& found,
                                                    const Ball& scale, double digits) {
    if (!claimed.is_finite() || !found.is_finite()) {
        return std::nullopt;
    }
    const Ball off = abs(claimed - found);
    if (arb_is_zero(off.data()) != 0) {
        return Confirmation();
    }
    const Ball tolerance =
        pow_int(Ball(10, off.bits()), -static_cast<long>(std::ceil(digits))) * scale;
    if (!scale.is_finite() || !certainly_positive(scale) || !certainly_less(off, tolerance)) {
        return std::nullopt;
    }
    return Confirmation();
}

std::optional<Confirmation> Confirmation::less(const Ball& x, const Ball& y) {
    if (!x.is_finite() || !y.is_finite() || !certainly_less(x, y)) {
        return std::nullopt;
    }
    return Confirmation();
}

std::optional<Confirmation> Confirmation::within(const Ball& x, const Rational& lower,
                                                 const Rational& upper) {
    const Ball from_lower = x - Ball(lower, x.bits());
    if (!x.is_finite() || arb_is_nonnegative(from_lower.data()) == 0 ||
        !certainly_less(x, Ball(upper, x.bits()))) {
        return std::nullopt;
    }
    return Confirmation();
}

Decision decision(const std::optional<Refutation>& fails,
                  const std::optional<Confirmation>& holds) {
    if (fails) {
        return *fails;
    }
    return holds ? Decision(*holds) : Decision();
}

Judgement::Judgement(const Decision& decision) {
    if (refutes(decision)) {
        verdict_ = Verdict::refuted;
    } else if (confirms(decision)) {
        verdict_ = Verdict::confirmed;
    }
}

Judgement Judgement::of_all(const std::vector<Decision>& parts) {
    if (std::any_of(parts.begin(), parts.end(), refutes)) {
        return Judgement(Verdict::refuted);
    }
    return !parts.empty() && std::all_of(parts.begin(), parts.end(), confirms)
               ? Judgement(Verdict::confirmed)
               : Judgement();
}

Judgement Judgement::of_readings(const std::vector<Judgement>& readings) {
    const auto count = [&](auto&& test) {
        return std::count_if(readings.begin(), readings.end(), test);
    };
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

Evidence& Evidence::add(std::string_view key, EvidenceItem value) {
    for (Entry& entry : entries_) {
        if (entry.first == key) {
            entry.second = std::move(value);
            return *this;
        }
    }
    entries_.emplace_back(std::string(key), std::move(value));
    return *this;
}

const EvidenceItem* Evidence::find(std::string_view key) const {
    for (const Entry& entry : entries_) {
        if (entry.first == key) {
            return &entry.second;
        }
    }
    return nullptr;
}

namespace {

struct OneLine {
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(long count) const { return std::to_string(count); }
    std::string operator()(bool yes) const { return yes ? "yes" : "no"; }
    std::string operator()(const std::vector<EvidenceItem>& list) const {
        std::string text;
        for (const EvidenceItem& item : list) {
            text += (text.empty() ? "" : ", ") + item.text();
        }
        return text;
    }
    std::string operator()(const Evidence& nested) const {
        std::string text;
        for (const auto& [key, item] : nested.entries()) {
            text += (text.empty() ? "" : ", ") + key + " " + item.text();
        }
        return text;
    }
};

} // namespace

std::string EvidenceItem::text() const { return std::visit(OneLine{}, value_); }

std::string_view name_of(Verdict verdict) {
    switch (verdict) {
    case Verdict::proved:
        return "proved";
    case Verdict::confirmed:
        return "confirmed";
    case Verdict::imprecise:
        return "imprecise";
    case Verdict::refuted:
        return "refuted";
    case Verdict::underspecified:
        return "underspecified";
    case Verdict::undecided:
        return "undecided";
    case Verdict::definition:
        break;
    }
    return "definition";
}

std::optional<Verdict> find_verdict(std::string_view name) {
    for (const Verdict verdict : all_verdicts) {
        if (name_of(verdict) == name) {
            return verdict;
        }
    }
    return std::nullopt;
}

} // namespace edgeproof::audit
