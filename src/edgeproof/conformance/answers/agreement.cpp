// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/answers/agreement.hpp"

#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/parallel/parallel_for.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace edgeproof::conformance {
namespace {

constexpr unsigned least_reference_digits = 40;
constexpr unsigned digits_beyond = 15;
constexpr int binary64_bits = 53;
constexpr long least_exponent = -1074;

/// The dimensions of a contact that determine the position of a point and the scale of M.
struct Sizes {
    double a = 0;
    double b = 0;
    double force = 0;
    std::vector<double> knots = {};
};

double number(const scene::BoundedValue& v) { return v.value.midpoint().convert_to<double>(); }

/// Computes a, b and P of every contact in the questions.
std::vector<Sizes> sizes_of(const Questions& questions, ReferenceOptions options) {
    Questions sizes;
    sizes.file = questions.file;
    sizes.contacts = questions.contacts;
    std::map<std::size_t, std::size_t> line;
    for (const Question& q : questions.list) {
        line.emplace(q.contact, q.line);
    }
    for (const auto& [contact, at] : line) {
        for (const auto size : {scene::Quantity::a, scene::Quantity::b, scene::Quantity::P}) {
            sizes.list.push_back({{size}, "", contact, at});
        }
    }
    options.digits.count = 20;
    options.progress = {};
    const auto values = references(sizes, options);
    std::vector<Sizes> list(questions.contacts.size());
    for (std::size_t i = 0; i < values.size(); i += 3) {
        Sizes& s = list[sizes.list[i].contact];
        s = {number(values[i].value), number(values[i + 1].value), number(values[i + 2].value)};
        if (const auto& profile = questions.contacts[sizes.list[i].contact].scene.profile) {
            for (const formula::Exact& knot : profile->knots()) {
                s.knots.push_back(knot.to<double>());
            }
        }
    }
    return list;
}

Regime regime_of(const Question& q, const Sizes& sizes) {
    if (!q.at_edge()) {
        return Regime::contact;
    }
    if (!q.at_point()) {
        return Regime::coefficient;
    }
    const double length = sizes.a + sizes.b;
    const double u = q.u->to<Real>().convert_to<double>();
    if (std::min(u, length - u) <= length / 1000) {
        return Regime::near_edge;
    }
    const double x = q.edge == contact::Edge::right ? sizes.a - u : u - sizes.b;
    if (std::abs(x) <= length / 100) {
        return Regime::apex;
    }
    for (const double knot : sizes.knots) {
        if (std::abs(x - knot) <= length / 100) {
            return Regime::knot;
        }
    }
    return u > length / 2 ? Regime::far_field : Regime::interior;
}

Nearness nearness_of(const Question& q, const Sizes& sizes) {
    const double length = sizes.a + sizes.b;
    Nearness near;
    if (q.u) {
        near.edge = q.u->to<Real>().convert_to<double>() / length;
        near.other_edge = std::max(1 - near.edge, 0.0);
        const double x = q.edge == contact::Edge::right ? sizes.a - near.edge * length
                                                        : near.edge * length - sizes.b;
        near.knot = std::abs(x) / length; // of the apex
        for (const double knot : sizes.knots) {
            near.knot = std::min(near.knot, std::abs(x - knot) / length);
        }
    } else if (!sizes.knots.empty()) {
        near.edge_to_knot = 1;
        for (const double knot : sizes.knots) {
            const bool right = !q.at_edge() || q.edge == contact::Edge::right;
            const bool left = !q.at_edge() || q.edge == contact::Edge::left;
            for (const double apart :
                 {right ? sizes.a - knot : length, left ? sizes.b + knot : length}) {
                near.edge_to_knot = std::min(near.edge_to_knot, std::max(apart, 0.0) / length);
            }
        }
    }
    return near;
}

/// True if a point has no reference because it lies outside the contact.
bool is_outside(const Question& q, const Sizes& sizes) {
    const double u = q.u ? q.u->to<Real>().convert_to<double>() : 0;
    return q.u && !(u > 0 && u < sizes.a + sizes.b);
}

Real ulp(const Real& x) {
    long exponent = least_exponent;
    if (x != 0) {
        exponent = std::max<long>(mpfr_get_exp(x.backend().data()) - binary64_bits, exponent);
    }
    return ldexp(Real(1), static_cast<int>(exponent));
}

/// Returns -log10(relative), at least 0 and at most `most`. Binary64 suffices except near a tenth
/// of a digit, the precision of the printed value.
double digits_of(const Real& relative, unsigned most) {
    constexpr double near_tenth = 1e-9;
    if (relative == 0) {
        return most;
    }
    long exponent = 0;
    const double mantissa = mpfr_get_d_2exp(&exponent, relative.backend().data(), MPFR_RNDN);
    double digits = -(std::log10(mantissa) + static_cast<double>(exponent) * std::log10(2.0));
    if (std::abs(digits * 10 - std::round(digits * 10)) < near_tenth) {
        digits = Real(-log10(relative)).convert_to<double>();
    }
    return std::clamp(digits, 0.0, static_cast<double>(most));
}

/// Compares an answer with a reference of a given number of digits. `scale`: of a value that is 0.
CaseAgreement compared(const Answer& answer, const Reference& reference, const Target& target,
                       unsigned digits, double scale) {
    CaseAgreement result;
    result.reference = printed_text(reference.value, {std::min(digits, 20U), Rounding::nearest});
    if (answer.state != Answer::State::number) {
        result.ulps = std::numeric_limits<double>::infinity();
        return result;
    }
    const Ball& exact = reference.value.value;
    const long bits = std::max(exact.bits(), formula::bits_for(digits + 20));
    const Ball error = abs(Ball(Ball(answer.value, bits) - exact));
    // The uncertainty of the reference is not counted as an error of the answer.
    const Real off = error.lower() > 0 ? error.lower() : Real(0);
    const bool zero = contains_zero(exact);
    const Real size = zero ? Real(scale) : Real(abs(exact.midpoint()));
    const Real relative = off / size;
    result.digits = digits_of(relative, digits);
    // For a ball around a power of two, the unit is that of the power, not the half of it below.
    const Real reach = zero ? size : Real(abs(exact).upper());
    result.ulps = off == 0 ? 0 : Real(off / ulp(reach)).convert_to<double>();
    result.relative = relative.convert_to<double>();
    const double needed = target.digits.value_or(target.ulps ? 0 : Target::default_digits);
    result.within =
        ((target.stated() && !target.digits) || relative <= Real(pow(Real(10), Real(-needed)))) &&
        (!target.ulps || result.ulps <= *target.ulps);
    result.pass = result.within;
    return result;
}

/// Lets an error pass that the conditioning explains, if the target allows it.
void take_conditioning(CaseAgreement& held, const Answer& answer, const Target& target) {
    held.explained = held.no_reference.empty() && answer.state == Answer::State::number &&
                     held.conditioning &&
                     held.relative <= explained_by_conditioning * held.conditioning->moved;
    held.pass = held.pass || (held.explained && target.forgives());
}

/// `all`: the conditioning of all cases, not only of those that miss the target.
Agreements held_against(std::vector<ReferenceOrWhy> found, const Answers& answers,
                        const Target& target, const ReferenceOptions& options, bool all) {
    Agreements result;
    result.digits = options.digits.count;
    const Questions& questions = answers.questions;
    const auto sizes = sizes_of(questions, options);
    result.cases.resize(found.size());
    result.references.resize(found.size());
    constexpr std::size_t piece = 256;
    const std::size_t pieces = (found.size() + piece - 1) / piece;
    parallel::parallel_for(pieces, options.threads, [&](std::size_t p) {
        const PrecisionScope scope(result.digits + 20);
        for (std::size_t i = p * piece; i < std::min(found.size(), (p + 1) * piece); ++i) {
            const Question& q = questions.list[i];
            const Sizes& s = sizes[q.contact];
            CaseAgreement& held = result.cases[i];
            if (!found[i].reference) {
                held.ulps = std::numeric_limits<double>::infinity();
                held.no_reference = std::move(found[i].why);
                held.regime = is_outside(q, s) ? Regime::outside : regime_of(q, s);
                continue;
            }
            result.references[i] = std::move(*found[i].reference);
            const double scale = scale_of(q, std::abs(s.force), s.a + s.b);
            held = compared(answers.given[i], result.references[i], target, result.digits, scale);
            held.scale = scale;
            held.regime = regime_of(q, s);
            held.nearness = nearness_of(q, s);
        }
    });
    std::vector<std::size_t> conditioned;
    for (std::size_t i = 0; i < found.size(); ++i) {
        result.estimates += found[i].reference && !result.references[i].value.proved ? 1 : 0;
        if (result.cases[i].no_reference.empty() && (all || !result.cases[i].pass)) {
            conditioned.push_back(i);
        }
    }
    const auto conditions = conditioning(questions, result.references, conditioned, options);
    for (std::size_t i = 0; i < result.cases.size(); ++i) {
        CaseAgreement& held = result.cases[i];
        held.conditioning = conditions[i];
        take_conditioning(held, answers.given[i], target);
    }
    return result;
}

} // namespace

std::string regime_name(Regime regime) {
    switch (regime) {
    case Regime::near_edge:
        return "near edge";
    case Regime::apex:
        return "apex";
    case Regime::knot:
        return "knot";
    case Regime::far_field:
        return "far field";
    case Regime::interior:
        return "interior";
    case Regime::coefficient:
        return "coefficient";
    case Regime::contact:
        return "contact";
    case Regime::outside:
        break;
    }
    return "outside";
}

unsigned reference_digits(const Target& target) {
    const double wanted = target.digits.value_or(0);
    return std::max(least_reference_digits, static_cast<unsigned>(wanted) + digits_beyond);
}

Agreements compare(const Answers& answers, const Target& target, ReferenceOptions options) {
    options.digits = {reference_digits(target), Rounding::nearest, false};
    const Questions& questions = answers.questions;
    auto found = references_or_why(questions, options);
    if (!found.empty() && std::none_of(found.begin(), found.end(),
                                       [](const ReferenceOrWhy& r) { return r.reference; })) {
        (void)references(questions, options); // throws the first error
    }
    return held_against(std::move(found), answers, target, options,
                        questions.list.size() <= most_conditioned);
}

Agreements compare_again(const Answers& answers, const Target& target, const Agreements& known) {
    const PrecisionScope scope(known.digits + 20);
    Agreements result = known;
    for (std::size_t i = 0; i < result.cases.size(); ++i) {
        CaseAgreement& held = result.cases[i];
        if (!held.no_reference.empty()) {
            continue;
        }
        const CaseAgreement old =
            std::exchange(held, compared(answers.given[i], known.references[i], target,
                                         known.digits, held.scale));
        held.regime = old.regime;
        held.nearness = old.nearness;
        held.scale = old.scale;
        held.conditioning = old.conditioning;
        take_conditioning(held, answers.given[i], target);
    }
    return result;
}

} // namespace edgeproof::conformance
