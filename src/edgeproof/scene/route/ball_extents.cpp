// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/route/ball_route.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::scene {
namespace {

formula::ExactNumber exact_number(const formula::Exact& x) {
    return formula::ExactNumber::of(x.expr());
}

} // namespace

std::vector<Row> BallRoute::extent(const AskedValue& asked) {
    contact::BallExtentSearch search(
        [&](long bits) -> const contact::ProvedContact& {
            BallLevel* level = at_level(bits);
            if (level == nullptr) {
                throw BudgetError("too few bits to enclose the edges");
            }
            return level->contact();
        },
        asked.edge, asked.k, *asked.tolerance, scene_.ask.part);
    const auto done = [&](const Ball& x, const std::optional<Rational>& q) {
        return q || has_digits(x, plan_.digits);
    };
    std::optional<contact::EnclosedExtents> best;
    ExactExtents exact;
    for (long bits = plan_.bits; bits <= last_bits(); bits *= 2) {
        try {
            best = search.at(bits);
        } catch (const BudgetError&) {
            if (search.evaluations() > contact::BallExtentSearch::most_evaluations) {
                break;
            }
            continue;
        }
        exact = exact_extents(asked, *best, *at_level(bits));
        if (done(best->first_exit, exact.first_exit) && done(best->measure, exact.measure) &&
            std::ranges::equal(best->crossings, exact.crossings, done)) {
            break;
        }
    }
    if (!best) {
        return {};
    }
    const auto proved = [](const Ball& x, const std::optional<Rational>& q) {
        return BoundedValue{x, true, "sign changes", q};
    };
    const auto fraction = [&](const Ball& x, const std::optional<Rational>& q) {
        return proved(x / best->length, q && exact.length
                                            ? std::optional(Rational(*q / *exact.length))
                                            : std::nullopt);
    };
    std::vector<BoundedValue> crossings;
    std::ranges::transform(best->crossings, exact.crossings, std::back_inserter(crossings), proved);
    return extent_rows(
        asked,
        {proved(best->first_exit, exact.first_exit), fraction(best->first_exit, exact.first_exit),
         proved(best->measure, exact.measure), fraction(best->measure, exact.measure)},
        crossings, best->leaves);
}

BallRoute::ExactExtents BallRoute::exact_extents(const AskedValue& asked,
                                                 const contact::EnclosedExtents& found,
                                                 const BallLevel& level) {
    ExactExtents result;
    result.crossings.resize(found.crossings.size());
    const auto part = [&](const formula::Exact& fraction) {
        return exact_value([&](ExactValues& e) { return e.length() * exact_number(fraction); },
                           level, found.length * ball_of(fraction, found.length.bits()));
    };
    result.length = part(formula::Exact::of(Rational(1)));
    if (!result.length) {
        return result;
    }
    bool all = true;
    for (std::size_t k = 0; k < found.crossings.size(); ++k) {
        result.crossings[k] =
            found.single[k] ? exact_crossing(asked, found.crossings[k], level) : std::nullopt;
        all = all && result.crossings[k];
    }
    const auto start = part(scene_.ask.part.from);
    const auto end = part(scene_.ask.part.to);
    result.first_exit = !found.starts_within ? start
                        : !found.leaves      ? end
                                             : result.crossings.front();
    if (!all || !start || !end) {
        return result;
    }
    Rational measure = 0;
    Rational entered = *start;
    bool within = found.starts_within;
    for (const auto& u : result.crossings) {
        measure += within ? Rational(*u - entered) : Rational(0);
        entered = *u;
        within = !within;
    }
    measure += within ? Rational(*end - entered) : Rational(0);
    if (contains(found.measure, measure)) {
        result.measure = measure;
    }
    return result;
}

std::optional<Rational> BallRoute::exact_crossing(const AskedValue& asked, const Ball& u,
                                                  const BallLevel& level) {
    const auto q = may_be_a_limit(u, plan_.digits, has_digits(u, plan_.digits))
                       ? contact::simplest_rational(u)
                       : std::nullopt;
    if (!q || *q <= 0) {
        return {};
    }
    const formula::ExactNumber tolerance = exact_number(*asked.tolerance);
    const auto off = [&](ExactValues& e) {
        const formula::ExactNumber error =
            e.relative_error(asked.edge, formula::ExactNumber(*q), asked.k, false);
        return error == tolerance || error == -tolerance ? formula::ExactNumber(*q)
                                                         : formula::ExactNumber::unknown();
    };
    return exact_value(off, level, u);
}

} // namespace edgeproof::scene
