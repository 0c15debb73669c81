// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/tail/parameter_sweep.hpp"
#include "edgeproof/contact/enclosure/exact_contact.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace edgeproof::audit {

Ledger with_parameter(const Ledger& ledger, const std::string& family, const std::string& parameter,
                      const Expr& value) {
    Ledger fixed;
    fixed.name = ledger.name;
    fixed.file = ledger.file;
    fixed.families = ledger.families;
    for (Family& f : fixed.families) {
        for (auto& [name, values] : f.parameters) {
            if (f.name == family && name == parameter) {
                values = {value};
            }
        }
    }
    return fixed;
}

ParameterSweep::ParameterSweep(const Claim& claim, const AuditContext& context)
    : claim_(claim), context_(context), name_(claim.text("along")) {
    if (claim.has("where")) {
        claim.reject("where", "a claim along " + name_ + " leaves samples out",
                     "list admissible values only, and leave out `where`");
    }
    for (const auto& [name, values] : context.ledger().family(claim.text("over")).parameters) {
        of_family_ = of_family_ || name == name_;
        for (std::size_t i = 0; name == name_ && i < values.size(); ++i) {
            add_step(to_text(values[i]), samples_with(values[i]));
        }
    }
    if (!of_family_ && claim.has("vary")) {
        Claim at = claim;
        for (auto& [name, texts] : std::get<Field::Table>(at.fields.find("vary")->second.value)) {
            for (const std::string& text : name == name_ ? Field::List(texts) : Field::List()) {
                texts = {text};
                add_step(text, context.samples(at));
            }
        }
    }
    if (values_.size() < 3) {
        claim.reject("along", "'" + name_ + "' does not take three values",
                     "name a parameter of the family, or a name of `vary`, with a list of values");
    }
}

std::vector<Sample> ParameterSweep::samples_with(const Expr& value) const {
    const Ledger fixed = with_parameter(context_.ledger(), claim_.text("over"), name_, value);
    return AuditContext(fixed, context_.digits()).samples(claim_);
}

void ParameterSweep::add_step(std::string value, std::vector<Sample> samples) {
    for (const Sample& sample : samples) {
        if (sample.scene.slips()) {
            require_partial_slip(sample.scene);
        }
    }
    values_.push_back(std::move(value));
    steps_.push_back(std::move(samples));
}

const Exact& ParameterSweep::value_at(std::size_t value, std::size_t sample) const {
    const Sample& at = sample_at(value, sample);
    return of_family_ ? at.scene.parameter(name_) : at.variables.find(name_)->second;
}

Sample ParameterSweep::sample_with(const Exact& value, std::size_t sample) const {
    if (of_family_) {
        return samples_with(value.expr())[sample];
    }
    Sample at = sample_at(0, sample);
    at.variables.insert_or_assign(name_, value);
    return at;
}

namespace {

constexpr long target_bits = 4000;
constexpr double most_height = 1000; ///< of the simplest multiple of a unit
/// A multiple is not a coincidence if its height, times the relative width of the interval in which
/// it must lie, is below this.
constexpr double most_coincidence = 0.1;

/// True if each value is at most half of the previous one (`twice`: at least twice it), all with
/// one sign. Values pass if balls do not prove the contrary: the balls of a ratio of exactly 2
/// overlap.
bool each_halves(const std::vector<Ball>& d, bool twice) {
    for (std::size_t i = 0; i + 1 < d.size(); ++i) {
        const Ball& larger = twice ? d[i + 1] : d[i];
        const Ball& smaller = twice ? d[i] : d[i + 1];
        if (!certainly_positive(larger * smaller) ||
            certainly_less(abs(larger), abs(smaller) * 2)) {
            return false;
        }
    }
    return true;
}

bool halves_towards(const Expr& at, std::vector<Ball> values) {
    const Ball target = formula::ball_of(Exact(at), target_bits);
    for (Ball& value : values) {
        value -= target;
    }
    return each_halves(values, false);
}

struct Candidate {
    Expr at;
    Ball value;
    double height = 0;
};

/// Returns the simplest multiple of the unit to which the values can tend. It lies beyond the last
/// value by at most the last step.
std::optional<Candidate> multiple_of(const Expr& unit, const std::vector<Ball>& values) {
    const Ball u = formula::ball_of(Exact(unit), target_bits);
    if (contains_zero(u)) {
        return std::nullopt;
    }
    const Ball last = values.back() / u;
    const Ball step = last - values[values.size() - 2] / u;
    const Ball end = last + step;
    const bool negative = certainly_negative(last);
    if (!certainly_positive(last * end)) {
        return std::nullopt;
    }
    const Ball between = Ball::hull(abs(last), abs(end));
    const auto q = contact::simplest_rational(between);
    const double height = q ? Rational(numerator(*q) * denominator(*q)).convert_to<double>() : 0;
    const Real width = (between.upper() - between.lower()) / between.lower();
    if (!q || height > most_height || height * width.convert_to<double>() > most_coincidence) {
        return std::nullopt;
    }
    const Rational factor = negative ? Rational(-*q) : *q;
    const Rational* known = unit.rational();
    const Expr at = known != nullptr ? Expr::number(factor * *known)
                    : factor == 1    ? unit
                                     : Expr::number(factor) * unit;
    if (!halves_towards(at, values)) {
        return std::nullopt;
    }
    return Candidate{at, u * Ball(factor, target_bits), height};
}

std::optional<Expr> finite_target(const std::vector<Ball>& values,
                                  const std::vector<Exact>& units) {
    std::vector<Expr> all{Expr::number(1), Expr::pi()};
    for (const Exact& unit : units) {
        all.push_back(unit.expr());
    }
    std::vector<Candidate> found;
    for (const Expr& unit : all) {
        if (auto candidate = multiple_of(unit, values)) {
            found.push_back(std::move(*candidate));
        }
    }
    if (found.empty()) {
        return std::nullopt;
    }
    const auto best = std::ranges::min_element(found, {}, &Candidate::height);
    // Two numbers fit, and there is no reason to prefer one of them.
    constexpr double as_simple = 4;
    const bool doubtful = std::ranges::any_of(found, [&](const Candidate& other) {
        return disjoint(other.value, best->value) && other.height <= as_simple * best->height;
    });
    return doubtful ? std::nullopt : std::optional(best->at);
}

/// Returns a factor between 1/2 and 1 that has no meaning in any formula.
Rational irregular(std::size_t which) {
    static constexpr std::array<std::array<long, 2>, 7> factors{{{7001, 7919},
                                                                 {6007, 7013},
                                                                 {6101, 8059},
                                                                 {5003, 6863},
                                                                 {8111, 9973},
                                                                 {6271, 8243},
                                                                 {5309, 7477}}};
    const auto& [over, under] = factors.at(which % factors.size());
    return {over, under};
}

} // namespace

std::optional<double> decades_of(const Ball& x) {
    if (!x.is_finite() || contains_zero(x)) {
        return std::nullopt;
    }
    const Ball ten(10, x.bits());
    const Ball decades = log(abs(x)) / log(ten);
    return decades.is_finite() ? std::optional(decades.midpoint().convert_to<double>())
                               : std::nullopt;
}

SweepTarget::SweepTarget(Kind kind, Expr at, const Exact& last)
    : kind_(kind), at_(std::move(at)), last_(last) {
    const Ball end = formula::ball_of(last, target_bits);
    const Ball off = kind == Kind::finite ? end - formula::ball_of(Exact(at_), target_bits) : end;
    decades_ = std::abs(decades_of(off).value_or(0));
}

std::optional<SweepTarget> SweepTarget::of(const std::vector<Exact>& listed,
                                           const std::vector<Exact>& units) {
    const PrecisionScope scope(target_bits * 3 / 10);
    std::vector<Ball> values;
    for (const Exact& value : listed) {
        values.push_back(formula::ball_of(value, target_bits));
    }
    if (each_halves(values, false)) {
        return SweepTarget(Kind::zero, Expr::number(0), listed.back());
    }
    if (each_halves(values, true)) {
        return SweepTarget(Kind::infinity, Expr::number(0), listed.back());
    }
    const auto at = finite_target(values, units);
    return at ? std::optional(SweepTarget(Kind::finite, *at, listed.back())) : std::nullopt;
}

std::string SweepTarget::text() const {
    return kind_ == Kind::infinity ? "infinity" : to_text(at_);
}

Exact SweepTarget::beyond(unsigned decades, std::size_t which) const {
    Rational power(boost::multiprecision::pow(Integer(10), decades));
    if (kind_ != Kind::infinity) {
        power = 1 / power;
    }
    const Rational factor = irregular(which) * power;
    const Rational* last = last_.expr().rational();
    if (kind_ != Kind::finite) {
        return last != nullptr ? Exact::of(factor * *last)
                               : Exact(Expr::number(factor) * last_.expr());
    }
    const Rational* at = at_.rational();
    if (last != nullptr && at != nullptr) {
        return Exact::of(*at + factor * (*last - *at));
    }
    return Exact(at_ + Expr::number(factor) * (last_.expr() - at_));
}

namespace {

using formula::Builtin;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double prevails = 3;     ///< decades by which a term dominates
constexpr double no_change = 1e-6; ///< of the ratio of two terms, in decades

std::optional<Ball> value_in(const EnclosedSample& sample, const Expr& e) {
    try {
        Ball value = sample.evaluate(e);
        return value.is_finite() ? std::optional(std::move(value)) : std::nullopt;
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// Returns log10 |e|.
std::optional<double> decades_in(const EnclosedSample& sample, const Expr& e) {
    const auto value = value_in(sample, e);
    return value ? decades_of(*value) : std::nullopt;
}

bool is_zero_ball(const Ball& x) { return x.is_exact() && contains_zero(x); }

/// True if no name in an expression changes from one sample to the other.
bool is_constant(const Expr& e, const SweptPair& at) {
    if (e.is_binder()) {
        return false;
    }
    if (e.args().empty() || (e.kind() == Expr::Kind::call && e.builtin() == Builtin::none)) {
        const auto before = value_in(at.before, e);
        const auto after = before ? value_in(at.after, e) : std::nullopt;
        if (!after || !overlaps(*before, *after)) {
            return false;
        }
    }
    return std::ranges::all_of(e.args(), [&](const Expr& part) { return is_constant(part, at); });
}

/// Returns the number of written digits, without zeros at the ends.
double digits_of_number(const Rational& q) {
    const auto digits = [](Integer n) {
        n = abs(n);
        while (n != 0 && n % 10 == 0) {
            n /= 10;
        }
        return n == 0 ? 0 : static_cast<double>(msb(n)) * 0.30103;
    };
    return digits(numerator(q)) + digits(denominator(q));
}

bool combines(const Expr& e) {
    return e.kind() == Expr::Kind::add || e.kind() == Expr::Kind::sub ||
           e.builtin() == Builtin::max || e.builtin() == Builtin::min ||
           e.builtin() == Builtin::hypot;
}

/// Everything that may hide a term in a formula, each part once, with its number of decades.
class HiddenScales {
public:
    explicit HiddenScales(const SweptPair& at) : at_(at) {}
    void collect(const Expr& e, double times = 1);
    [[nodiscard]] double sum() const {
        double all = 0;
        for (const auto& [text, decades] : decades_) {
            all += decades;
        }
        return all;
    }

private:
    void add(const Expr& e, double decades) {
        double& known = decades_[to_text(e)];
        known = std::max(known, decades);
    }
    void collect_terms(const Expr& e, double times);
    void collect_binder(const Expr& e, double times);
    [[nodiscard]] double power_of(const Expr& e) const;
    const SweptPair& at_;
    std::map<std::string, double> decades_;
};

/// Adds the ratios of the terms at the first sample in decades; for a constant, also the
/// cancellation.
void HiddenScales::collect_terms(const Expr& e, double times) {
    double apart = 0;
    for (std::size_t i = 0; i + 1 < e.args().size(); ++i) {
        const auto first = decades_in(at_.before, e.arg(i));
        const auto second = decades_in(at_.before, e.arg(i + 1));
        if (first && second) {
            apart += std::abs(*first - *second);
            const auto all = is_constant(e, at_) ? decades_in(at_.before, e) : std::nullopt;
            apart += all ? std::abs(std::max(*first, *second) - *all) : 0;
        }
    }
    add(e, times * apart);
}

void HiddenScales::collect_binder(const Expr& e, double times) {
    const Expr middle = (e.arg(2) + e.arg(3)) / Expr::number(2);
    collect(substitute(e.arg(0), e.arg(1).name(), middle), times);
    collect(e.arg(2), times);
    collect(e.arg(3), times);
}

/// Returns the factor by which a power multiplies what its base hides.
double HiddenScales::power_of(const Expr& e) const {
    const auto exponent = e.kind() == Expr::Kind::pow && is_constant(e.arg(1), at_)
                              ? value_in(at_.after, e.arg(1))
                              : std::nullopt;
    return exponent ? std::max(1.0, std::abs(exponent->midpoint().convert_to<double>())) : 1;
}

void HiddenScales::collect(const Expr& e, double times) {
    if (e.kind() == Expr::Kind::number) {
        add(e, times * digits_of_number(e.number()));
    } else if (e.kind() == Expr::Kind::symbol && (e.name() == "x" || e.name() == "u")) {
        // A place near an edge hides as many decades as its distance from the edge.
        const Expr fraction = Expr::symbol("u") / Expr::symbol("L");
        add(fraction, std::abs(decades_in(at_.after, fraction).value_or(infinite)));
    } else if (e.args().empty()) {
        if (!value_in(at_.after, e)) {
            add(e, infinite);
        }
    } else if (e.is_binder()) {
        collect_binder(e, times);
    } else {
        if (combines(e)) {
            collect_terms(e, times);
        }
        for (const Expr& part : e.args()) {
            collect(part, times * power_of(e));
        }
    }
}

bool pair_is_steady(const Expr& first, const Expr& second, const SweptPair& at) {
    const auto ratio = [&](const EnclosedSample& sample) -> std::optional<double> {
        const auto p = decades_in(sample, first);
        const auto q = decades_in(sample, second);
        return p && q ? std::optional(*p - *q) : std::nullopt;
    };
    const auto zero = [&](const Expr& e) {
        const auto before = value_in(at.before, e);
        const auto after = value_in(at.after, e);
        return before && after && is_zero_ball(*before) && is_zero_ball(*after);
    };
    if (zero(first) || zero(second)) {
        return true;
    }
    const auto before = ratio(at.before);
    const auto after = ratio(at.after);
    if (!before || !after) {
        return false;
    }
    return std::abs(*after - *before) < no_change ||
           (*before * *after > 0 && std::abs(*after) > std::abs(*before) &&
            std::abs(*after) >= prevails);
}

} // namespace

double hidden_decades(const Expr& e, const SweptPair& at) {
    HiddenScales scales(at);
    scales.collect(e);
    return scales.sum();
}

bool sums_are_steady(const Expr& e, const SweptPair& at) {
    if (e.is_binder() || e.args().empty() || is_constant(e, at)) {
        return true;
    }
    if (combines(e)) {
        for (std::size_t i = 0; i + 1 < e.args().size(); ++i) {
            if (!pair_is_steady(e.arg(i), e.arg(i + 1), at)) {
                return false;
            }
        }
    }
    return std::ranges::all_of(e.args(),
                               [&](const Expr& part) { return sums_are_steady(part, at); });
}

} // namespace edgeproof::audit
