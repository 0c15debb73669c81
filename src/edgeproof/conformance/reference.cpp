// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/reference.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/plan.hpp"
#include "edgeproof/scene/value_route.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <exception>
#include <map>
#include <memory>
#include <utility>

namespace edgeproof {
namespace {

/// Questions of one contact that one thread answers; cut alike however many threads there are.
constexpr std::size_t most_in_a_task = 48;

struct Task {
    std::size_t contact;
    bool points;
    std::vector<std::size_t> questions;
};

std::vector<Task> tasks_of(const Questions& questions) {
    std::vector<Task> tasks;
    std::map<std::pair<std::size_t, bool>, std::size_t> open;
    for (std::size_t i = 0; i < questions.list.size(); ++i) {
        const Question& q = questions.list[i];
        const std::pair key{q.contact, q.wanted.at_point()};
        const auto found = open.find(key);
        if (found == open.end() || tasks[found->second].questions.size() >= most_in_a_task) {
            open[key] = tasks.size();
            tasks.push_back({key.first, key.second, {}});
        }
        tasks[open[key]].questions.push_back(i);
    }
    return tasks;
}

/// The answers to one task.
class Answering {
public:
    Answering(const Questions& questions, const Task& task, const ReferenceOptions& options)
        : questions_(questions), task_(task), scene_(questions.contacts[task.contact].scene) {
        scene_.file = questions.file;
        scene_.ask.digits = options.digits;
        std::size_t terms = 0;
        bool shear = false;
        for (const std::size_t i : task.questions) {
            const Question& q = questions.list[i];
            const auto kind = q.wanted.kind;
            shear = shear || kind == Wanted::Kind::q || kind == Wanted::Kind::s;
            if (q.wanted.at_point()) {
                scene_.ask.quantities.insert(kind == Wanted::Kind::p ? Quantity::pressure
                                                                     : Quantity::shear);
                scene_.ask.u.push_back({*q.u, q.line});
            } else if (q.wanted.at_edge()) {
                scene_.ask.quantities.insert(Quantity::coefficients);
                terms = std::max(terms, q.wanted.k + 1);
            } else {
                scene_.ask.quantities.insert(Quantity::contact);
            }
        }
        if (!shear) {
            scene_.shear.reset();
        }
        if (terms > 0) {
            scene_.ask.terms = {terms};
        }
        scene_.ask.edges = {Edge::right, Edge::left};
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
                found =
                    points_
                        .emplace(key, route_->at(q.edge, *q.u, plan_.print_pressure, plan_.shear))
                        .first;
            } catch (const DomainError& error) {
                throw InputError("u = " + q.u->text() + " from the " + edge_name(q.edge) +
                                     " edge: " + error.what(),
                                 "give distances from the edge, 0 < u < a + b, off every corner")
                    .at(questions_.file, q.line);
            }
        }
        const PointValues& v = found->second;
        return {q.wanted.kind == Wanted::Kind::p ? *v.p : *v.q, v.x};
    }
    const EdgeValues& expansion(Edge edge) {
        auto found = expansions_.find(edge);
        if (found == expansions_.end()) {
            found = expansions_
                        .emplace(edge,
                                 route_->expansion(edge, plan_.expand_pressure, plan_.expand_shear))
                        .first;
        }
        return found->second;
    }
    const ContactValues& contact_values() {
        if (!contact_) {
            contact_ = route_->contact();
        }
        return *contact_;
    }

    const Questions& questions_;
    const Task& task_;
    Scene scene_;
    Plan plan_;
    Work work_;
    std::unique_ptr<ValueRoute> route_;
    std::map<std::pair<Edge, std::string>, PointValues> points_;
    std::map<Edge, EdgeValues> expansions_;
    std::optional<ContactValues> contact_;
};

} // namespace

std::vector<Reference> references(const Questions& questions, const ReferenceOptions& options) {
    std::vector<Reference> results(questions.list.size());
    const std::vector<Task> tasks = tasks_of(questions);
    std::vector<std::exception_ptr> errors(tasks.size());
    std::atomic<std::size_t> done{0};
    const auto run = [&](std::size_t t) {
        try {
            if (options.stop != nullptr && *options.stop) {
                throw Error("interrupted: nothing is written");
            }
            Answering answering(questions, tasks[t], options);
            for (const std::size_t i : tasks[t].questions) {
                if (options.stop != nullptr && *options.stop) {
                    throw Error("interrupted: nothing is written");
                }
                results[i] = answering.answer(i);
                const std::size_t n = ++done;
                if (options.progress) {
                    options.progress(n, results.size());
                }
            }
        } catch (...) {
            errors[t] = std::current_exception();
        }
    };
    tbb::task_arena arena(options.threads == 0 ? tbb::task_arena::automatic
                                               : static_cast<int>(options.threads));
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, tasks.size(), run); });
    for (const std::exception_ptr& error : errors) {
        if (error) {
            std::rethrow_exception(error);
        }
    }
    return results;
}

} // namespace edgeproof
