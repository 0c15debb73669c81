// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/questions/reference.hpp"

#include "edgeproof/io/error_place.hpp"
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/scene/plan.hpp"
#include "edgeproof/scene/value_route.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace edgeproof::conformance {
namespace {

/// The answers to one piece.
class Answering {
public:
    Answering(const Questions& questions, const Piece& piece, const scene::Digits& digits)
        : questions_(questions),
          scene_(questions.contacts[questions.list[piece.front()].contact].scene) {
        scene_.file = questions.file;
        scene_.ask.digits = digits;
        std::size_t terms = 0;
        bool shear = false;
        std::set<std::size_t> numbers_of_terms;
        for (const std::size_t i : piece) {
            const Question& q = questions.list[i];
            const auto kind = q.wanted.kind;
            shear = shear || kind == Wanted::Kind::q || kind == Wanted::Kind::s;
            if (q.wanted.at_point()) {
                scene_.ask.quantities.insert(kind == Wanted::Kind::p ? scene::Quantity::pressure
                                                                     : scene::Quantity::shear);
                scene_.ask.u.push_back({*q.u, q.line});
            } else if (q.wanted.of_terms()) {
                scene_.ask.quantities.insert(scene::Quantity::extent);
                scene_.ask.tolerance = q.tolerance;
                numbers_of_terms.insert(q.wanted.k);
            } else if (q.wanted.at_edge()) {
                scene_.ask.quantities.insert(scene::Quantity::coefficients);
                terms = std::max(terms, q.wanted.k + 1);
            } else {
                scene_.ask.quantities.insert(scene::Quantity::contact);
            }
        }
        if (!shear) {
            scene_.shear.reset();
        }
        if (terms > 0) {
            scene_.ask.terms = {terms};
        }
        if (!numbers_of_terms.empty()) {
            scene_.ask.terms.assign(numbers_of_terms.begin(), numbers_of_terms.end());
        }
        scene_.ask.edges = {contact::Edge::right, contact::Edge::left};
        plan_ = make_plan(scene_);
        route_ = plan_.proved ? make_ball_route(scene_, plan_, work_)
                              : make_real_route(scene_, plan_, work_);
    }

    [[nodiscard]] Reference answer(std::size_t i) {
        const Question& q = questions_.list[i];
        switch (q.wanted.kind) {
        case Wanted::Kind::p:
        case Wanted::Kind::q:
            return at_point(q);
        case Wanted::Kind::c:
            return {expansion(q.edge).c.at(q.wanted.k), {}};
        case Wanted::Kind::s:
            return {expansion(q.edge).s.at(q.wanted.k), {}};
        case Wanted::Kind::a:
            return {contact_values().a, {}};
        case Wanted::Kind::b:
            return {contact_values().b, {}};
        case Wanted::Kind::P:
            return {contact_values().force.value(), {}};
        case Wanted::Kind::M:
            return {contact_values().moment.value(), {}};
        case Wanted::Kind::extent:
            if (!extent(q).leaves) {
                throw InputError("there is no first exit: n = " + std::to_string(q.wanted.k) +
                                     " terms stay within the tolerance all over the contact",
                                 "ask for measure_" + std::to_string(q.wanted.k) +
                                     ", or give a smaller tolerance")
                    .at(questions_.file, q.line);
            }
            return {extent(q).first_exit, {}};
        case Wanted::Kind::measure:
            return {extent(q).measure, {}};
        case Wanted::Kind::alpha:
            break;
        }
        return {contact_values().alpha.value(), {}};
    }

private:
    Reference at_point(const Question& q) {
        const std::pair key{q.edge, q.u->text()};
        auto found = points_.find(key);
        if (found == points_.end()) {
            try {
                if (q.u->sign() <= 0) {
                    throw DomainError("the point lies outside the contact");
                }
                found =
                    points_
                        .emplace(key, route_->at(q.edge, *q.u, plan_.print_pressure, plan_.shear))
                        .first;
            } catch (const DomainError& error) {
                throw InputError("u = " + q.u->text() + " from the " + scene::edge_name(q.edge) +
                                     " edge: " + error.what(),
                                 "give distances from the edge, 0 < u < a + b, off every corner")
                    .at(questions_.file, q.line);
            }
        }
        const scene::PointValues& v = found->second;
        return {q.wanted.kind == Wanted::Kind::p ? *v.p : *v.q, v.x};
    }
    const scene::EdgeValues& expansion(contact::Edge edge) {
        auto found = expansions_.find(edge);
        if (found == expansions_.end()) {
            found = expansions_
                        .emplace(edge,
                                 route_->expansion(edge, plan_.expand_pressure, plan_.expand_shear))
                        .first;
        }
        return found->second;
    }
    const scene::ExtentValues& extent(const Question& q) {
        const std::pair key{q.edge, q.wanted.k};
        auto found = extents_.find(key);
        if (found == extents_.end()) {
            found = extents_.emplace(key, route_->extent(q.edge, q.wanted.k)).first;
        }
        return found->second;
    }
    const scene::ContactValues& contact_values() {
        if (!contact_) {
            contact_ = route_->contact();
        }
        return *contact_;
    }

    const Questions& questions_;
    scene::Scene scene_;
    scene::Plan plan_;
    contact::Work work_;
    std::unique_ptr<scene::ValueRoute> route_;
    std::map<std::pair<contact::Edge, std::string>, scene::PointValues> points_;
    std::map<contact::Edge, scene::EdgeValues> expansions_;
    std::map<std::pair<contact::Edge, std::size_t>, scene::ExtentValues> extents_;
    std::optional<scene::ContactValues> contact_;
};

/// The answer to question i of a piece; where there is none, an error with the question's line.
Reference placed_answer(std::optional<Answering>& answering, const Questions& questions,
                        const Piece& piece, const scene::Digits& digits, std::size_t i) {
    return io::at_place(questions.file, questions.list[i].line, [&] {
        if (!answering) {
            answering.emplace(questions, piece, digits);
        }
        return answering->answer(i);
    });
}

/// Counts questions, and tells of them.
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
    std::vector<Piece> pieces;
    std::map<std::tuple<std::size_t, int, std::string>, std::size_t> open;
    for (std::size_t i = 0; i < questions.list.size(); ++i) {
        const Question& q = questions.list[i];
        const int kind = q.wanted.at_point() ? 1 : q.wanted.of_terms() ? 2 : 0;
        const std::tuple key{q.contact, kind, q.tolerance ? q.tolerance->text() : ""};
        const auto found = open.find(key);
        if (found == open.end() || pieces[found->second].size() >= most_in_a_piece) {
            open[key] = pieces.size();
            pieces.emplace_back();
        }
        pieces[open[key]].push_back(i);
    }
    return pieces;
}

std::vector<Reference> references_in_turn(const Questions& questions, const scene::Digits& digits,
                                          const std::function<void()>& one) {
    std::vector<Reference> results(questions.list.size());
    for (const Piece& piece : pieces_of(questions)) {
        check_interruption();
        std::optional<Answering> answering;
        for (const std::size_t i : piece) {
            check_interruption();
            results[i] = placed_answer(answering, questions, piece, digits, i);
            one();
        }
    }
    return results;
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
                                       if (!questions.list[i].wanted.at_point()) {
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
                                   } catch (const Error&) { // there is none
                                   }
                                   count.one();
                               }
                           });
    return results;
}

} // namespace edgeproof::conformance
