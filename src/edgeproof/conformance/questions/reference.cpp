// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/questions/reference.hpp"

#include "edgeproof/io/error_place.hpp"
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <atomic>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>

namespace edgeproof::conformance {
namespace {

/// Questions (by index) of one contact that are answered together. The division into pieces does
/// not depend on the number of threads, and an answer depends on nothing outside its piece.
using Piece = std::vector<std::size_t>;

std::vector<scene::AskedValue> values_of(const Questions& questions, const Piece& piece) {
    std::vector<scene::AskedValue> values;
    for (const std::size_t i : piece) {
        values.push_back(questions.list[i]);
    }
    return values;
}

scene::Scene scene_of(const Questions& questions, const Piece& piece) {
    scene::Scene scene = questions.contacts[questions.list[piece.front()].contact].scene;
    scene.file = questions.file;
    return scene;
}

/// The answers of one piece.
class Answering {
public:
    Answering(const Questions& questions, const Piece& piece, const scene::Digits& digits)
        : questions_(questions),
          values_(scene_of(questions, piece), values_of(questions, piece), digits) {}

    [[nodiscard]] Reference answer(std::size_t i) {
        const Question& q = questions_.list[i];
        if (q.at_point()) {
            try {
                scene::BoundedValue x = values_.x(q);
                return {values_.value(q), std::move(x)};
            } catch (const DomainError& error) {
                throw InputError("u = " + q.u->text() + " from the " + scene::edge_name(q.edge) +
                                     " edge: " + error.what(),
                                 "give distances from the edge, 0 < u < a + b, off every corner")
                    .at(questions_.file, q.line);
            }
        }
        if (q.quantity == scene::Quantity::extent && !values_.searched(q).reached) {
            throw InputError("there is no first exit: n = " + std::to_string(q.k) +
                                 " terms stay within the tolerance all over the contact",
                             "ask for measure_" + std::to_string(q.k) +
                                 ", or give a smaller tolerance")
                .at(questions_.file, q.line);
        }
        return {values_.value(q), {}};
    }

private:
    const Questions& questions_;
    scene::SceneValues values_;
};

std::vector<Piece> pieces_of(const Questions& questions) {
    constexpr std::size_t most_in_a_piece = 128;
    std::vector<Piece> pieces;
    std::map<std::tuple<std::size_t, int, std::string>, std::size_t> open;
    for (std::size_t i = 0; i < questions.list.size(); ++i) {
        const Question& q = questions.list[i];
        const int kind = q.at_point() ? 1 : q.to_a_tolerance() ? 2 : 0;
        const auto [found, first] =
            open.try_emplace({q.contact, kind, q.tolerance ? q.tolerance->text() : ""}, 0);
        if (first || pieces[found->second].size() >= most_in_a_piece) {
            found->second = pieces.size();
            pieces.emplace_back();
        }
        pieces[found->second].push_back(i);
    }
    return pieces;
}

/// Calls `handle(i, answering)` for each question, in several threads; answering() returns the
/// answers of its piece.
template <class Handle>
void answer_all(const Questions& questions, const ReferenceOptions& options, const Handle& handle) {
    const std::vector<Piece> pieces = pieces_of(questions);
    std::atomic<std::size_t> done{0};
    parallel::parallel_for(pieces.size(), options.threads, [&](std::size_t p) {
        std::optional<Answering> answers;
        const auto answering = [&]() -> Answering& {
            return answers ? *answers : answers.emplace(questions, pieces[p], options.digits);
        };
        for (const std::size_t i : pieces[p]) {
            check_interruption();
            handle(i, answering);
            const std::size_t n = ++done;
            if (options.progress) {
                options.progress(n, questions.list.size());
            }
        }
    });
}

} // namespace

std::vector<Reference> references(const Questions& questions, const ReferenceOptions& options) {
    std::vector<Reference> results(questions.list.size());
    answer_all(questions, options, [&](std::size_t i, const auto& answering) {
        results[i] = io::at_place(questions.file, questions.list[i].line,
                                  [&] { return answering().answer(i); });
    });
    return results;
}

std::vector<ReferenceOrWhy> references_or_why(const Questions& questions,
                                              const ReferenceOptions& options) {
    std::vector<ReferenceOrWhy> results(questions.list.size());
    answer_all(questions, options, [&](std::size_t i, const auto& answering) {
        Answering& answers = answering(); // throws for an invalid contact
        try {
            results[i].reference = answers.answer(i);
        } catch (const InputError& error) {
            if (!questions.list[i].at_point()) {
                throw;
            }
            results[i].why = error.problem();
        } catch (const BudgetError& error) {
            results[i].why = error.what();
        }
    });
    return results;
}

std::vector<std::optional<Reference>> references_where_any(const Questions& questions,
                                                           const ReferenceOptions& options) {
    std::vector<std::optional<Reference>> results(questions.list.size());
    answer_all(questions, options, [&](std::size_t i, const auto& answering) {
        const Question& q = questions.list[i];
        if (lack_of(questions.contacts[q.contact].scene, q)) {
            return; // the approach of a plane contact, q without shear
        }
        try {
            results[i] = answering().answer(i);
        } catch (const Error&) { // there is no answer
        }
    });
    return results;
}

} // namespace edgeproof::conformance
