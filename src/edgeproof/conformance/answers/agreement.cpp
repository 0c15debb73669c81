// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/conformance/answers/answers.hpp"

#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/parallel/parallel_for.hpp"

#include <algorithm>
#include <array>
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

Nearness nearness_of(const Question& q, const Sizes& sizes) {
    const double length = sizes.a + sizes.b;
    Nearness near;
    if (q.u) {
        const double u = q.u->to<Real>().convert_to<double>();
        const double x = q.edge == contact::Edge::right ? sizes.a - u : u - sizes.b;
        near.edge = u / length;
        near.other_edge = std::max(1 - u / length, 0.0);
        near.apex = near.knot = std::abs(x) / length;
        for (const double knot : sizes.knots) {
            near.knot = std::min(near.knot, std::abs(x - knot) / length);
        }
        return near;
    }
    near.edge_to_knot = sizes.knots.empty() ? 0 : 1;
    for (const double knot : sizes.knots) {
        const bool right = !q.at_edge() || q.edge == contact::Edge::right;
        const bool left = !q.at_edge() || q.edge == contact::Edge::left;
        for (const double apart :
             {right ? sizes.a - knot : length, left ? sizes.b + knot : length}) {
            near.edge_to_knot = std::min(near.edge_to_knot, std::max(apart, 0.0) / length);
        }
    }
    return near;
}

Regime regime_of(const Question& q, const Nearness& near) {
    constexpr double by_edge = 1e-3;
    constexpr double by_knot = 1e-2;
    return !q.u ? q.at_edge() ? Regime::coefficient : Regime::contact
           : std::min(near.edge, near.other_edge) <= by_edge ? Regime::near_edge
           : near.apex <= by_knot                            ? Regime::apex
           : near.knot <= by_knot                            ? Regime::knot
           : near.edge > 0.5                                 ? Regime::far_field
                                                             : Regime::interior;
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

/// Sets what depends on the answer. `held` has the rest, the scale of a reference that is 0 too.
void judge(CaseAgreement& held, const Answer& answer, const Reference& reference,
           const Target& target, unsigned digits) {
    if (!held.no_reference.empty() || answer.state != Answer::State::number) {
        held.digits = held.relative = 0;
        held.ulps = std::numeric_limits<double>::infinity();
        held.within = held.pass = held.explained = false;
        return;
    }
    const Ball& exact = reference.value.value;
    const long bits = std::max(exact.bits(), formula::bits_for(digits + 20));
    const Ball error = abs(Ball(Ball(answer.value, bits) - exact));
    // The uncertainty of the reference is not counted as an error of the answer.
    const Real off = error.lower() > 0 ? error.lower() : Real(0);
    const bool zero = contains_zero(exact);
    const Real size = zero ? Real(held.scale) : Real(abs(exact.midpoint()));
    const Real relative = off / size;
    held.digits = digits_of(relative, digits);
    // For a ball around a power of two, the unit is that of the power, not the half of it below.
    const Real reach = zero ? size : Real(abs(exact).upper());
    held.ulps = off == 0 ? 0 : Real(off / ulp(reach)).convert_to<double>();
    held.relative = relative.convert_to<double>();
    const double needed = target.digits.value_or(target.ulps ? 0 : Target::default_digits);
    held.within =
        ((target.stated() && !target.digits) || relative <= Real(pow(Real(10), Real(-needed)))) &&
        (!target.ulps || held.ulps <= *target.ulps);
    held.explained =
        held.conditioning && held.relative <= explained_by_conditioning * held.conditioning->moved;
    held.pass = held.within || (held.explained && target.forgives());
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
            held.nearness = nearness_of(q, s);
            held.regime = regime_of(q, held.nearness);
            held.no_reference = std::move(found[i].why);
            if (found[i].reference) {
                result.references[i] = std::move(*found[i].reference);
                held.reference = printed(result.references[i].value,
                                         {std::min(result.digits, 20U), Rounding::nearest})
                                     .text;
                held.scale = scale_of(q, std::abs(s.force), s.a + s.b);
            } else {
                const bool outside = q.u && !(held.nearness.edge > 0 && held.nearness.edge < 1);
                held.regime = outside ? Regime::outside : held.regime;
                held.nearness = {};
            }
            judge(held, answers.given[i], result.references[i], target, result.digits);
        }
    });
    std::vector<std::size_t> conditioned;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const CaseAgreement& held = result.cases[i];
        result.estimates += held.no_reference.empty() && !result.references[i].value.proved ? 1 : 0;
        if (held.no_reference.empty() && (all || !held.pass)) {
            conditioned.push_back(i);
        }
    }
    const auto conditions = conditioning(questions, result.references, conditioned, options);
    const PrecisionScope scope(result.digits + 20);
    for (const std::size_t i : conditioned) {
        result.cases[i].conditioning = conditions[i];
        judge(result.cases[i], answers.given[i], result.references[i], target, result.digits);
    }
    return result;
}

} // namespace

std::string regime_name(Regime regime) {
    static constexpr std::array names{"near edge", "apex",        "knot",    "far field",
                                      "interior",  "coefficient", "contact", "outside"};
    return names.at(static_cast<std::size_t>(regime));
}

Agreements compare(const Answers& answers, const Target& target, ReferenceOptions options) {
    const auto wanted = static_cast<unsigned>(target.digits.value_or(0)) + digits_beyond;
    options.digits = {std::max(least_reference_digits, wanted), Rounding::nearest, false};
    const Questions& questions = answers.questions;
    auto found = references_or_why(questions, options);
    if (!found.empty() &&
        std::ranges::none_of(found, [](const auto& r) { return r.reference.has_value(); })) {
        (void)references(questions, options); // throws the first error
    }
    return held_against(std::move(found), answers, target, options,
                        questions.list.size() <= most_conditioned);
}

Agreements compare_again(const Answers& answers, const Target& target, const Agreements& known) {
    const PrecisionScope scope(known.digits + 20);
    Agreements result = known;
    for (std::size_t i = 0; i < result.cases.size(); ++i) {
        judge(result.cases[i], answers.given[i], known.references[i], target, known.digits);
    }
    return result;
}

} // namespace edgeproof::conformance
