// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"

#include "edgeproof/contact/design/best_reach.hpp"
#include "edgeproof/contact/enclosure/ball_extent.hpp"
#include "edgeproof/precision/bounded_cache.hpp"
#include "edgeproof/precision/error.hpp"

#include <map>
#include <memory>

namespace edgeproof::audit {
namespace {

constexpr long most_terms = 9;

std::size_t number_of_terms(const Exact& terms) {
    for (long n = 1; n <= most_terms; ++n) {
        if (terms == Exact::of(Rational(n))) {
            return static_cast<std::size_t>(n);
        }
    }
    throw Error("an approximation of " + terms.text() + " terms: write 1 to 9");
}

/// The value for the one-power law, whose shape is all that the question depends on.
Ball best_exponent(Edge edge, std::size_t terms, const Exact& tolerance, const Exact& from,
                   const Exact& to) {
    contact::ReachProblem problem;
    problem.edges = {contact::power_law_errors(Expr::symbol("m"), {},
                                               {edge, terms, contact::ReachUnit::fraction})};
    problem.tolerance = tolerance.rational();
    problem.part = Rational(1, 2);
    contact::DesignOptions options;
    options.gap = Rational(1, 100'000'000);
    const contact::BestReach best = best_reach(problem, {from.rational(), to.rational()}, options);
    if (!best.proved) {
        throw BudgetError(best.missing);
    }
    return best.value;
}

} // namespace

Ball EnclosedSample::reach(const Expr& call) const {
    const auto exact = [&](std::size_t i) {
        auto value = constant(call.arg(i));
        return value ? *std::move(value)
                     : throw Error("the arguments of " + call.name() + " are not numbers");
    };
    const Exact terms = exact(0);
    const Exact tolerance = exact(1);
    if (call.name() == "best") {
        if (call.arg(2).name() != "m" || sample_.scene.profile != "power-law") {
            throw Error("best(...) is proved only for the exponent m of a power law");
        }
        // The proof takes seconds, and is the same for all scenes, bits and parts of a condition.
        constexpr std::size_t most_kept = 16;
        thread_local BoundedCache<std::string, const Ball> kept(most_kept);
        const Exact from = exact(3);
        const Exact to = exact(4);
        std::string key = sample_.edge == Edge::right ? "right" : "left";
        for (const Exact* argument : {&terms, &tolerance, &from, &to}) {
            key += ", " + to_text(argument->expr());
        }
        return *kept.get(key, [&] {
            return std::make_shared<const Ball>(
                best_exponent(sample_.edge, number_of_terms(terms), tolerance, from, to));
        });
    }
    std::map<long, std::unique_ptr<contact::ProvedContact>> contacts;
    const auto contact_at = [&](long bits) -> const contact::ProvedContact& {
        auto& made = contacts[bits];
        if (!made) {
            made = sample_.scene.contact(bits);
        }
        return *made;
    };
    contact::BallExtentSearch search(contact_at, sample_.edge, number_of_terms(terms), tolerance,
                                     {});
    const contact::EnclosedExtents extents = search.at(bits_);
    if (call.name() == "exit" && !extents.leaves) {
        throw Error("there is no first exit: the error is within the tolerance in all the contact");
    }
    return call.name() == "exit" ? extents.first_exit : extents.measure;
}

} // namespace edgeproof::audit
