// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/checks/parts/decimal_fit.hpp"

#include "edgeproof/audit/diagnosis/diagnosis.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <memory>

namespace edgeproof::audit {
namespace {

constexpr int most_iterations = 60;
constexpr std::size_t most_boxes = 3000;   ///< in a subdivision
constexpr std::size_t most_subdivided = 4; ///< decimals of a box that is subdivided

using Row = std::vector<Real>;

Real norm_squared(const Row& r) {
    Real sum(0);
    for (const Real& x : r) {
        sum += x * x;
    }
    return sum;
}

/// Decimals for which the printed formula agrees with the exact values.
struct FittedDecimals {
    std::vector<Real> numbers;
    Confirmation agrees;
};

/// Finds numbers that can replace the decimals of a printed formula.
class DecimalFit {
public:
    /// `digits`: the digits to which the formula must agree with the exact values.
    DecimalFit(const std::vector<PrintedDecimal>& decimals,
               const std::vector<DecimalEquation>& equations, unsigned digits, long bits)
        : decimals_(decimals), equations_(equations), digits_(digits), bits_(bits) {}

    /// Finds numbers, at most `units` units of the last place from the printed ones (without a
    /// limit: any numbers), for which all equations are proved to hold. They are searched by the
    /// Levenberg-Marquardt iteration in Real; only the enclosures at its result decide. Returns
    /// nothing if no such numbers are found.
    [[nodiscard]] std::optional<FittedDecimals> find(const std::optional<Rational>& units) const {
        const PrecisionScope scope(2 * digits_ + 30);
        try {
            const auto numbers =
                search(units, std::vector<std::optional<Real>>(decimals_.size(), std::nullopt));
            if (!numbers) {
                return std::nullopt;
            }
            for (std::size_t k = 0; units && k < numbers->size(); ++k) {
                const Ball off = Ball((*numbers)[k], bits_) - Ball(decimals_[k].value, bits_);
                const Ball most(Rational(*units * decimals_[k].unit), bits_);
                if (certainly_less(most, abs(off))) {
                    return std::nullopt;
                }
            }
            const auto holds = agrees(*numbers);
            return holds ? std::optional(FittedDecimals{*numbers, *holds}) : std::nullopt;
        } catch (const Error&) {
            return std::nullopt; // no enclosure for these numbers
        }
    }
    /// Proves that no numbers at most half a unit away satisfy all equations: the enclosure of one
    /// equation over all of them excludes its exact value, or each part of a subdivision is
    /// excluded by an equation.
    [[nodiscard]] std::optional<Refutation> exclude() const {
        Decimals whole;
        for (const PrintedDecimal& d : decimals_) {
            whole.push_back(d.interval(rounding_units(), bits_));
        }
        std::size_t first = 0;
        if (auto apart = excluded(whole, first)) {
            return apart;
        }
        if (decimals_.size() > most_subdivided) {
            return std::nullopt;
        }
        std::vector<Decimals> open{whole};
        std::optional<Refutation> last;
        for (std::size_t looked_at = 0; !open.empty(); ++looked_at) {
            check_interruption();
            if (looked_at == most_boxes) {
                return std::nullopt;
            }
            const Decimals box = std::move(open.back());
            open.pop_back();
            if (auto apart = excluded(box, first)) {
                last = apart;
                continue;
            }
            // Halve the box in its widest direction, measured in units of the last place.
            std::size_t widest = 0;
            Real width(0);
            for (std::size_t k = 0; k < box.size(); ++k) {
                const Real w = Real(box[k].radius() / Real(decimals_[k].unit));
                if (w > width) {
                    width = w;
                    widest = k;
                }
            }
            const Ball middle(box[widest].midpoint(), bits_);
            for (const Real& end : {box[widest].lower(), box[widest].upper()}) {
                Decimals part = box;
                part[widest] = Ball::hull(Ball(end, bits_), middle);
                open.push_back(std::move(part));
            }
        }
        return last;
    }

private:
    /// The unknowns are the differences from the printed decimals, in units of the last place;
    /// `fixed` are decimals that stay. Difference quotients approximate the derivatives. This is
    /// safe, because results are proved afterwards.
    [[nodiscard]] std::optional<Row> search(const std::optional<Rational>& units,
                                            const std::vector<std::optional<Real>>& fixed) const {
        const std::size_t n = decimals_.size();
        Row y;
        for (const auto& end : fixed) {
            y.push_back(end.value_or(Real(0)));
        }
        const auto free = std::ranges::count(fixed, false, &std::optional<Real>::has_value);
        const auto numbers = [&](const Row& at) {
            Row c;
            for (std::size_t k = 0; k < n; ++k) {
                c.push_back(from_rational<Real>(decimals_[k].value) +
                            at[k] * from_rational<Real>(decimals_[k].unit));
            }
            return c;
        };
        auto r = residuals(numbers(y));
        if (!r) {
            return std::nullopt;
        }
        const Real enough = pow(Real(10), -2 * static_cast<int>(digits_ + 5));
        const Real step = pow(Real(10), -static_cast<int>(digits_ / 2 + 5));
        const Real most = units ? from_rational<Real>(*units) : Real(0);
        for (int i = 0; i < most_iterations && norm_squared(*r) > enough; ++i) {
            check_interruption();
            if (free == 0) {
                return std::nullopt;
            }
            std::vector<Row> J(r->size(), Row(n, Real(0))); // decimals that stay have no effect
            for (std::size_t k = 0; k < n; ++k) {
                if (fixed[k]) {
                    continue;
                }
                Row moved = y;
                moved[k] += step;
                const auto there = residuals(numbers(moved));
                if (!there) {
                    return std::nullopt;
                }
                for (std::size_t j = 0; j < r->size(); ++j) {
                    J[j][k] = ((*there)[j] - (*r)[j]) / step;
                }
            }
            // The damping is |r|^2 times the mean of the diagonal of J^T J.
            Real diagonal(0);
            for (const Row& row : J) {
                diagonal += norm_squared(row);
            }
            const Real damping = diagonal * norm_squared(*r) / static_cast<unsigned>(free);
            const auto d = least_squares(J, *r, damping, Real(0));
            for (std::size_t k = 0; k < n; ++k) {
                if (!d[k] || !isfinite(*d[k])) {
                    return std::nullopt;
                }
                y[k] -= *d[k];
            }
            r = residuals(numbers(y));
            if (!r) {
                return std::nullopt;
            }
        }
        if (norm_squared(*r) > enough) {
            return std::nullopt;
        }
        if (units) {
            // A decimal outside its interval is fixed at the interval's end, and the others stay
            // free.
            std::vector<std::optional<Real>> held = fixed;
            bool beyond = false;
            for (std::size_t k = 0; k < n; ++k) {
                if (abs(y[k]) > most) {
                    held[k] = y[k] > 0 ? most : Real(-most);
                    beyond = true;
                }
            }
            if (beyond) {
                return search(units, held);
            }
        }
        return numbers(y);
    }
    [[nodiscard]] Decimals balls(const Row& numbers) const {
        Decimals at;
        for (const Real& x : numbers) {
            at.emplace_back(x, bits_);
        }
        return at;
    }
    [[nodiscard]] std::optional<Row> residuals(const Row& numbers) const {
        const Decimals at = balls(numbers);
        Row r;
        for (const DecimalEquation& e : equations_) {
            const Ball off = (e.printed(at) - e.exact) / e.scale;
            if (!off.is_finite()) {
                return std::nullopt;
            }
            r.push_back(off.midpoint());
        }
        return r;
    }
    [[nodiscard]] std::optional<Confirmation> agrees(const Row& numbers) const {
        const Decimals at = balls(numbers);
        std::optional<Confirmation> last;
        for (const DecimalEquation& e : equations_) {
            last = Confirmation::agreement(e.printed(at), e.exact, e.scale, digits_);
            if (!last) {
                break;
            }
        }
        return last;
    }
    /// A proof that one equation excludes all numbers in the box.
    [[nodiscard]] std::optional<Refutation> excluded(const Decimals& box,
                                                     std::size_t& first) const {
        for (std::size_t k = 0; k < equations_.size(); ++k) {
            const std::size_t i = (first + k) % equations_.size();
            try {
                if (const auto apart =
                        Refutation::disjoint(equations_[i].printed(box), equations_[i].exact)) {
                    first = i;
                    return apart;
                }
            } catch (const Error&) {
                continue; // no enclosure over this box
            }
        }
        return std::nullopt;
    }

    const std::vector<PrintedDecimal>& decimals_;
    const std::vector<DecimalEquation>& equations_;
    unsigned digits_;
    long bits_;
};

struct Described {
    std::string right; ///< the decimals to which the fitted numbers round
    std::string off;   ///< the other decimals
};

/// True if every number is more than half a unit away from zero.
bool none_vanishes(const std::vector<PrintedDecimal>& decimals, const std::vector<Real>& numbers) {
    for (std::size_t k = 0; k < decimals.size(); ++k) {
        if (abs(numbers[k]) * 2 <= from_rational<Real>(decimals[k].unit)) {
            return false;
        }
    }
    return true;
}

Described describe(const std::vector<PrintedDecimal>& decimals, const std::vector<Real>& numbers,
                   std::size_t comparisons, unsigned digits, Outcome& outcome) {
    const PrecisionScope scope(digits + 20);
    std::vector<Evidence> list;
    Described all;
    for (std::size_t k = 0; k < decimals.size(); ++k) {
        const PrintedDecimal& printed = decimals[k];
        const Real off =
            (numbers[k] - from_rational<Real>(printed.value)) / from_rational<Real>(printed.unit);
        const bool rounds = abs(off) <= Real(1) / 2;
        list.push_back({{"printed", printed.text},
                        {"stands_for", to_decimal(numbers[k], digits)},
                        {"units_off", to_decimal(off, 3)},
                        {"rounds_to_it", rounds}});
        const std::size_t known = printed.significant_digits();
        const std::string exactly = to_decimal(numbers[k], static_cast<unsigned>(known) + 5);
        std::string& text = rounds ? all.right : all.off;
        text += text.empty() ? "" : ", ";
        text += rounds ? std::to_string(known) + " printed digits of " + printed.text +
                             " (exactly " + exactly + "...)"
                       : printed.text + " should be " + printed.in_its_place(numbers[k]) +
                             " (exactly " + exactly + "...)";
    }
    outcome.evidence["rounded"] = {
        {"constants", list}, {"samples", comparisons}, {"digits", digits}};
    return all;
}

} // namespace

void set_decimals(EnclosedSample& sample, const Decimals& numbers) {
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        sample.set(name_of_decimal(k), numbers[k]);
    }
}

DecimalEquation equation_at(const Sample& sample, long bits, unsigned integral_digits,
                            const Expr& printed, const Expr& exact,
                            const std::optional<Expr>& scale, const Expr& terms) {
    const auto at = std::make_shared<EnclosedSample>(sample, bits, integral_digits);
    Ball value = at->evaluate(exact);
    Ball size = scale                  ? abs(at->evaluate(*scale))
                : contains_zero(value) ? scale_of_terms(terms, *at)
                                       : abs(value);
    return {[at, printed](const Decimals& numbers) {
                set_decimals(*at, numbers);
                return at->evaluate(printed);
            },
            std::move(value), std::move(size)};
}

Judgement judge_decimals(const PrintedFormula& printed,
                         const std::vector<DecimalEquation>& equations, unsigned digits, long bits,
                         Outcome& outcome) {
    const std::vector<PrintedDecimal>& decimals = printed.decimals;
    const std::size_t comparisons = equations.size();
    const DecimalFit fit(decimals, equations, AuditContext::digits_needed(digits), bits);
    if (const auto found = fit.find(rounding_units())) {
        const Described d = describe(decimals, found->numbers, comparisons, digits, outcome);
        outcome.note = "right to the " + d.right + ", at " + std::to_string(comparisons) +
                       (comparisons == 1 ? " sample" : " samples") + "; a rounded formula";
        return Judgement(found->agrees);
    }
    const auto excluded = fit.exclude();
    if (!excluded) {
        outcome.note = "it is not decided whether numbers that round to the printed decimals fit";
        return {};
    }
    auto found = fit.find(neighbour_units());
    // If a decimal has to vanish, the correct formula is a different one, not an imprecise one.
    const bool near = found && none_vanishes(decimals, found->numbers);
    if (!near) {
        found = fit.find(std::nullopt);
    }
    if (!found) {
        outcome.note = "no numbers that round to the printed decimals fit";
        return Judgement(*excluded);
    }
    const Described d = describe(decimals, found->numbers, comparisons, digits, outcome);
    outcome.correct = printed.text_with(found->numbers);
    outcome.note = d.off + (d.right.empty() ? "" : "; right to the " + d.right);
    return near ? Judgement::imprecise(found->agrees) : Judgement(*excluded);
}

} // namespace edgeproof::audit
