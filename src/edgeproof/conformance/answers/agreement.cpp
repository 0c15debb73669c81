// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/answers/agreement.hpp"

#include "edgeproof/formula/exact/exact_ball.hpp"

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

/// Sizes of a contact, enough to tell where a point lies and how large M may be.
struct Sizes {
    double a = 0;
    double b = 0;
    double force = 0;
};

double number(const scene::BoundedValue& v) { return v.value.midpoint().convert_to<double>(); }

/// a, b and P of every contact that is asked about.
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
        list[sizes.list[i].contact] = {number(values[i].value), number(values[i + 1].value),
                                       number(values[i + 2].value)};
    }
    return list;
}

Regime regime_of(const Question& q, const AskedContact& contact, const Sizes& sizes) {
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
    if (contact.scene.profile) {
        for (const formula::Exact& knot : contact.scene.profile->knots()) {
            if (std::abs(x - knot.to<double>()) <= length / 100) {
                return Regime::knot;
            }
        }
    }
    return u > length / 2 ? Regime::far_field : Regime::interior;
}

/// Of a point that has no reference.
bool is_outside(const Question& q, const Sizes& sizes) {
    const double u = q.u ? q.u->to<Real>().convert_to<double>() : 0;
    return q.u && !(u > 0 && u < sizes.a + sizes.b);
}

/// The unit in the last place of the binary64 of x.
Real ulp(const Real& x) {
    long exponent = least_exponent;
    if (x != 0) {
        exponent = std::max<long>(mpfr_get_exp(x.backend().data()) - binary64_bits, exponent);
    }
    return ldexp(Real(1), static_cast<int>(exponent));
}

double digits_of(const Real& relative, unsigned most) {
    if (relative == 0) {
        return most;
    }
    const double digits = Real(-log10(relative)).convert_to<double>();
    return digits > 0 ? std::min(digits, static_cast<double>(most)) : 0.0;
}

CaseAgreement held(const Answer& answer, const Reference& reference, double scale,
                   const Target& target, unsigned digits) {
    CaseAgreement result;
    result.reference = printed(reference.value, {std::min(digits, 20U), Rounding::nearest}).text;
    if (answer.state != Answer::State::number) {
        result.ulps = std::numeric_limits<double>::infinity();
        return result;
    }
    const PrecisionScope scope(digits + 20);
    const Ball& exact = reference.value.value;
    const long bits = std::max(exact.bits(), formula::bits_for(digits + 20));
    const Ball error = abs(Ball(Ball(answer.value, bits) - exact));
    // What the reference itself leaves open is not counted against the answer.
    const Real off = error.lower() > 0 ? error.lower() : Real(0);
    const bool zero = contains_zero(exact);
    const Real size = zero ? Real(scale) : Real(abs(exact.midpoint()));
    const Real relative = off / size;
    result.digits = digits_of(relative, digits);
    // Of a ball around a power of two the unit is that of the power, not the half of it below.
    const Real reach = zero ? size : Real(abs(exact).upper());
    result.ulps = Real(off / ulp(reach)).convert_to<double>();
    result.relative = relative.convert_to<double>();
    const double needed = target.digits.value_or(target.ulps ? 0 : Target::default_digits);
    result.within =
        ((target.stated() && !target.digits) || relative <= Real(pow(Real(10), Real(-needed)))) &&
        (!target.ulps || result.ulps <= *target.ulps);
    result.pass = result.within;
    return result;
}

/// Which cases to find the conditioning of.
std::vector<std::size_t> to_condition(const Agreements& agreements) {
    std::vector<std::size_t> which;
    const bool all = agreements.cases.size() <= most_conditioned;
    for (std::size_t i = 0; i < agreements.cases.size(); ++i) {
        const CaseAgreement& held = agreements.cases[i];
        if (held.no_reference.empty() && (all || !held.pass)) {
            which.push_back(i);
        }
    }
    return which;
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
    case Regime::interior:
        return "interior";
    case Regime::far_field:
        return "far field";
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
    Agreements result;
    result.digits = reference_digits(target);
    options.digits = {result.digits, Rounding::nearest, false};
    const Questions& questions = answers.questions;
    const auto found = references_or_why(questions, options);
    if (!found.empty() && std::none_of(found.begin(), found.end(),
                                       [](const ReferenceOrWhy& r) { return r.reference; })) {
        (void)references(questions, options); // throws the first
    }
    const auto sizes = sizes_of(questions, options);
    for (std::size_t i = 0; i < questions.list.size(); ++i) {
        const Question& q = questions.list[i];
        const Sizes& s = sizes[q.contact];
        result.references.push_back(found[i].reference.value_or(Reference{}));
        if (!found[i].reference) {
            CaseAgreement& none = result.cases.emplace_back();
            none.ulps = std::numeric_limits<double>::infinity();
            none.no_reference = found[i].why;
            none.regime =
                is_outside(q, s) ? Regime::outside : regime_of(q, questions.contacts[q.contact], s);
            continue;
        }
        result.cases.push_back(held(answers.given[i], result.references[i],
                                    scale_of(q, std::abs(s.force), s.a + s.b), target,
                                    result.digits));
        result.cases.back().regime = regime_of(q, questions.contacts[q.contact], s);
        result.estimates += result.references[i].value.proved ? 0 : 1;
    }
    const auto conditions =
        conditioning(questions, result.references, to_condition(result), options);
    for (std::size_t i = 0; i < result.cases.size(); ++i) {
        CaseAgreement& held = result.cases[i];
        held.conditioning = conditions[i];
        held.explained = held.no_reference.empty() &&
                         answers.given[i].state == Answer::State::number && conditions[i] &&
                         held.relative <= explained_by_conditioning * conditions[i]->moved;
        held.pass = held.pass || (held.explained && target.forgives());
    }
    return result;
}

} // namespace edgeproof::conformance
