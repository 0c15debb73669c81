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
          values_(scene_of(questions, piece), values_of(questions, piece), digits) {
        for (const std::size_t i : piece) {
            if (questions.list[i].at_point()) {
                at_points_.insert(questions.list[i].quantity);
            }
        }
    }

    [[nodiscard]] Reference answer(std::size_t i) {
        const Question& q = questions_.list[i];
        if (q.at_point() && at_points_.size() == 1) {
            return at_point_of(q, [&] {
                scene::BoundedValue x = values_.x(q);
                return Reference{values_.value(q), std::move(x)};
            });
        }
        if (q.at_point()) {
            const Point& point = at_point(q);
            return {point.values.at(q.quantity), point.x};
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
    /// The values of the piece at a point: either all of them exist, or none.
    struct Point {
        scene::BoundedValue x;
        std::map<scene::Quantity, scene::BoundedValue> values;
    };
    const Point& at_point(const Question& q) {
        const std::pair key{q.edge, q.u->text()};
        const auto known = points_.find(key);
        if (known != points_.end()) {
            return known->second;
        }
        const auto all = [&] {
            Point point{values_.x(q), {}};
            for (scene::AskedValue value = q; const scene::Quantity quantity : at_points_) {
                value.quantity = quantity;
                point.values.emplace(quantity, values_.value(value));
            }
            return point;
        };
        return points_.emplace(key, at_point_of(q, all)).first->second;
    }
    /// Calls f() for the point of a question; errors name the point.
    template <class F>
    [[nodiscard]] std::invoke_result_t<F> at_point_of(const Question& q, const F& f) const {
        try {
            return f();
        } catch (const DomainError& error) {
            throw InputError("u = " + q.u->text() + " from the " + scene::edge_name(q.edge) +
                                 " edge: " + error.what(),
                             "give distances from the edge, 0 < u < a + b, off every corner")
                .at(questions_.file, q.line);
        }
    }

    const Questions& questions_;
    scene::SceneValues values_;
    std::set<scene::Quantity> at_points_;
    std::map<std::pair<contact::Edge, std::string>, Point> points_;
};

/// Calls `handle(i, answering)` for each question of a piece; answering() returns the answers.
template <class Handle>
void answer_piece(const Questions& questions, const Piece& piece, const scene::Digits& digits,
                  const Handle& handle) {
    check_interruption();
    std::optional<Answering> answers;
    const auto answering = [&]() -> Answering& {
        return answers ? *answers : answers.emplace(questions, piece, digits);
    };
    for (const std::size_t i : piece) {
        check_interruption();
        handle(i, answering);
    }
}

/// Calls `handle` as answer_piece() does for all pieces, in several threads.
template <class Handle>
void answer_all(const Questions& questions, const ReferenceOptions& options, const Handle& handle) {
    const std::vector<Piece> pieces = pieces_of(questions);
    std::atomic<std::size_t> done{0};
    const auto piece = [&](std::size_t p) {
        answer_piece(questions, pieces[p], options.digits, [&](std::size_t i, const auto& answers) {
            handle(i, answers);
            const std::size_t n = ++done;
            if (options.progress) {
                options.progress(n, questions.list.size());
            }
        });
    };
    parallel::work_through(parallel::all_pieces(pieces.size()), options.threads, piece);
}

/// Returns the answer to question i, or throws an error with the question's line.
template <class Answers>
Reference placed_answer(const Questions& questions, std::size_t i, const Answers& answering) {
    return io::at_place(questions.file, questions.list[i].line,
                        [&] { return answering().answer(i); });
}

} // namespace

std::vector<Piece> pieces_of(const Questions& questions) {
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

std::vector<Reference> references(const Questions& questions, const ReferenceOptions& options) {
    std::vector<Reference> results(questions.list.size());
    answer_all(questions, options, [&](std::size_t i, const auto& answering) {
        results[i] = placed_answer(questions, i, answering);
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
