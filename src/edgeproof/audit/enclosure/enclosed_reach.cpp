// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosure/enclosed_reach.hpp"

#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/contact/design/best_reach.hpp"
#include "edgeproof/contact/enclosure/ball_extent.hpp"
#include "edgeproof/precision/bounded_cache.hpp"
#include "edgeproof/precision/error.hpp"

#include <map>
#include <memory>

namespace edgeproof::audit {
namespace {

constexpr long most_terms = 9;

std::size_t number_of_terms(const ReachQuestion& question) {
    for (long n = 1; n <= most_terms; ++n) {
        if (question.terms == Exact::of(Rational(n))) {
            return static_cast<std::size_t>(n);
        }
    }
    throw Error("an approximation of " + question.terms.text() + " terms: write 1 to 9");
}

} // namespace

Ball enclosed_reach(const SceneSpec& scene, const ReachQuestion& question, bool first_exit,
                    long bits) {
    std::map<long, std::unique_ptr<contact::ProvedContact>> contacts;
    const auto contact_at = [&](long at_bits) -> const contact::ProvedContact& {
        auto& made = contacts[at_bits];
        if (!made) {
            made = scene.contact(at_bits);
        }
        return *made;
    };
    contact::BallExtentSearch search(contact_at, question.edge, number_of_terms(question),
                                     question.tolerance, {});
    const contact::EnclosedExtents extents = search.at(bits);
    if (first_exit && !extents.leaves) {
        throw Error("there is no first exit: the error is within the tolerance in all the contact");
    }
    return first_exit ? extents.first_exit : extents.measure;
}

namespace {

/// The value for the one-power law, whose shape is all that the question depends on.
Ball best_exponent(const ReachQuestion& question, const Exact& from, const Exact& to) {
    const auto errors = contact::power_law_errors(
        Expr::symbol("m"), {},
        {question.edge, number_of_terms(question), contact::ReachUnit::fraction});
    contact::ReachProblem problem;
    problem.edges = {errors.get()};
    problem.tolerance = question.tolerance.rational();
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

Ball best_value(const SceneSpec& scene, const ReachQuestion& question, const std::string& parameter,
                const Exact& from, const Exact& to) {
    if (parameter != "m" || scene.profile != "power-law") {
        throw Error("best(...) is proved only for the exponent m of a power law");
    }
    // The proof takes seconds, and is the same for all scenes, bits and parts of a condition.
    constexpr std::size_t most_kept = 16;
    thread_local BoundedCache<std::string, const Ball> kept(most_kept);
    std::string key = question.edge == Edge::right ? "right" : "left";
    for (const Exact* argument : {&question.terms, &question.tolerance, &from, &to}) {
        key += ", " + to_text(argument->expr());
    }
    return *kept.get(
        key, [&] { return std::make_shared<const Ball>(best_exponent(question, from, to)); });
}

} // namespace edgeproof::audit
