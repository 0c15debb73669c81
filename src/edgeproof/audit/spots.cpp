// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/spots.hpp"

#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace edgeproof {
namespace {

constexpr double all_digits = 1e6;

double digits_of_ratio(const Real& difference, const Real& scale) {
    if (difference == 0) {
        return all_digits;
    }
    if (scale == 0) {
        return -all_digits;
    }
    return (-log10(Real(difference / scale))).convert_to<double>();
}

/// The sum of the sizes of the terms that e is made of: what its value cancels from.
Real magnitude(const Expr& e, const Spot& spot) {
    using Kind = Expr::Kind;
    switch (e.kind()) {
    case Kind::neg:
        return magnitude(e.arg(0), spot);
    case Kind::add:
    case Kind::sub:
        return magnitude(e.arg(0), spot) + magnitude(e.arg(1), spot);
    case Kind::mul:
        return magnitude(e.arg(0), spot) * magnitude(e.arg(1), spot);
    case Kind::div:
        return magnitude(e.arg(0), spot) / abs(spot.evaluate(e.arg(1)).value);
    default:
        return abs(spot.evaluate(e).value);
    }
}

} // namespace

bool Agreement::to(double digits) const {
    return !spots.empty() && std::all_of(spots.begin(), spots.end(), [&](const SpotAgreement& s) {
        return s.problem.empty() && s.digits >= digits;
    });
}

bool Agreement::undefined() const {
    return !spots.empty() && std::all_of(spots.begin(), spots.end(),
                                         [](const SpotAgreement& s) { return s.undefined; });
}

bool Agreement::differ(double digits_needed) const {
    // Three digits of margin: errors of quadratures are estimates.
    return std::any_of(spots.begin(), spots.end(), [&](const SpotAgreement& s) {
        return s.problem.empty() && s.digits < digits_needed && s.digits + 3 < s.good_digits;
    });
}

Spots::Spots(const Claim& claim, const AuditContext& context, unsigned digits, std::size_t most)
    : digits_(digits) {
    std::optional<Condition> where;
    if (claim.has("where")) {
        where = claim.condition("where");
    }
    std::string last;
    for (const Sample& sample : context.samples(claim)) {
        if (most != 0 && spots_.size() >= most) {
            break;
        }
        const std::string scene = sample.scene.family + ": " + sample.scene.text();
        if (settings_.empty() || scene != last) {
            settings_.push_back(std::make_unique<Setting>(sample.scene, digits));
            last = scene;
        }
        const Setting& setting = *settings_.back();
        Spot spot{&setting, std::nullopt, {}, sample.scene.family + ": " + sample.text(), sample};
        if (sample.fraction) {
            spot.place = setting.place(sample.edge, *sample.fraction);
        }
        spot.variables = setting.values_of(sample.variables);
        if (where && !setting.holds(*where, spot.place ? &*spot.place : nullptr, spot.variables)) {
            ++left_out_;
            continue;
        }
        spots_.push_back(std::move(spot));
    }
}

Agreement Spots::compare(const Expr& printed, const Expr& exact,
                         const std::optional<Expr>& scale) const {
    Agreement agreement;
    const PrecisionScope scope(digits_ + 20);
    for (const Spot& spot : spots_) {
        SpotAgreement s;
        try {
            const FormulaValue x = spot.evaluate(exact);
            s.undefined = true; // if what comes next throws
            const FormulaValue y = spot.evaluate(printed);
            s.undefined = false;
            s.exact = x.value;
            s.printed = y.value;
            s.good_digits = std::min(x.digits, y.digits);
            if (!x.converged || !y.converged) {
                s.problem = "an integral did not converge";
            }
            const Real difference = abs(s.printed - s.exact);
            Real against = abs(s.exact);
            if (scale) {
                against = abs(spot.evaluate(*scale).value);
            } else if (difference != 0) {
                // Where the exact value is zero but for roundoff, hold it against its terms.
                const Real terms = magnitude(printed, spot);
                if (against < terms * pow(Real(10), -static_cast<int>(digits_))) {
                    against = terms;
                }
            }
            s.digits = digits_of_ratio(difference, against);
        } catch (const DomainError& error) {
            s.problem = error.what();
            s.digits = -all_digits;
        }
        agreement.spots.push_back(std::move(s));
        if (agreement.spots.back().digits < agreement.spots[agreement.worst].digits) {
            agreement.worst = agreement.spots.size() - 1;
        }
    }
    return agreement;
}

std::string digits_text(double digits) {
    if (digits >= all_digits) {
        return "all";
    }
    return digits <= -all_digits ? "none" : fmt::format("{:.1f}", digits);
}

std::string value_text(const Real& value, unsigned digits) {
    return value.str(static_cast<std::streamsize>(digits), std::ios_base::scientific);
}

} // namespace edgeproof
