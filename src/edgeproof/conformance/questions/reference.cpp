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
    values.reserve(piece.size());
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

/// Returns the answer to question i of a piece, or throws an error with the question's line.
Reference placed_answer(std::optional<Answering>& answering, const Questions& questions,
                        const Piece& piece, const scene::Digits& digits, std::size_t i) {
    return io::at_place(questions.file, questions.list[i].line, [&] {
        if (!answering) {
            answering.emplace(questions, piece, digits);
        }
        return answering->answer(i);
    });
}

/// Divides n questions into pieces: similar questions of one contact, at most most_in_a_piece each.
template <class QuestionAt> std::vector<Piece> cut(std::size_t n, const QuestionAt& question_at) {
    std::vector<Piece> pieces;
    std::map<std::tuple<std::size_t, int, std::string>, std::size_t> open;
    for (std::size_t i = 0; i < n; ++i) {
        const Question& q = question_at(i);
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

class Count {
public:
    Count(const ReferenceOptions& options, std::size_t total) : options_(options), total_(total) {}
    void one() {
        const std::size_t n = ++done_;
        if (options_.progress) {
            options_.progress(n, total_);
        }
    }

private:
    const ReferenceOptions& options_;
    std::size_t total_;
    std::atomic<std::size_t> done_{0};
};

} // namespace

std::vector<Piece> pieces_of(const Questions& questions) {
    return cut(questions.list.size(),
               [&](std::size_t i) -> const Question& { return questions.list[i]; });
}

std::vector<Piece> pieces_of(const AskedList& asked) {
    return cut(asked.size(), [&](std::size_t i) -> const Question& { return asked.pattern(i); });
}

void references_in_turn(const Questions& questions, const scene::Digits& digits,
                        const std::function<void(std::size_t, const Reference&)>& take) {
    for (const Piece& piece : pieces_of(questions)) {
        check_interruption();
        std::optional<Answering> answering;
        for (const std::size_t i : piece) {
            check_interruption();
            take(i, placed_answer(answering, questions, piece, digits, i));
        }
    }
}

std::vector<Reference> references(const Questions& questions, const ReferenceOptions& options) {
    std::vector<Reference> results(questions.list.size());
    const std::vector<Piece> pieces = pieces_of(questions);
    Count count(options, questions.list.size());
    parallel::work_through(
        parallel::all_pieces(pieces.size()), options.threads, [&](std::size_t p) {
            check_interruption();
            std::optional<Answering> answering;
            for (const std::size_t i : pieces[p]) {
                check_interruption();
                results[i] = placed_answer(answering, questions, pieces[p], options.digits, i);
                count.one();
            }
        });
    return results;
}

std::vector<ReferenceOrWhy> references_or_why(const Questions& questions,
                                              const ReferenceOptions& options) {
    std::vector<ReferenceOrWhy> results(questions.list.size());
    const std::vector<Piece> pieces = pieces_of(questions);
    Count count(options, questions.list.size());
    parallel::work_through(parallel::all_pieces(pieces.size()), options.threads,
                           [&](std::size_t p) {
                               check_interruption();
                               Answering answering(questions, pieces[p], options.digits);
                               for (const std::size_t i : pieces[p]) {
                                   check_interruption();
                                   try {
                                       results[i].reference = answering.answer(i);
                                   } catch (const InputError& error) {
                                       if (!questions.list[i].at_point()) {
                                           throw;
                                       }
                                       results[i].why = error.problem();
                                   } catch (const BudgetError& error) {
                                       results[i].why = error.what();
                                   }
                                   count.one();
                               }
                           });
    return results;
}

std::vector<std::optional<Reference>> references_where_any(const Questions& questions,
                                                           const ReferenceOptions& options) {
    std::vector<std::optional<Reference>> results(questions.list.size());
    const std::vector<Piece> pieces = pieces_of(questions);
    Count count(options, questions.list.size());
    parallel::work_through(parallel::all_pieces(pieces.size()), options.threads,
                           [&](std::size_t p) {
                               check_interruption();
                               std::optional<Answering> answering;
                               for (const std::size_t i : pieces[p]) {
                                   check_interruption();
                                   try {
                                       if (!answering) {
                                           answering.emplace(questions, pieces[p], options.digits);
                                       }
                                       results[i] = answering->answer(i);
                                   } catch (const Error&) { // there is no answer
                                   }
                                   count.one();
                               }
                           });
    return results;
}

} // namespace edgeproof::conformance
