// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/python/native_scene.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/python/bindings.hpp"
#include "edgeproof/scene/input/readers.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::python {
namespace {

constexpr long most_terms = 400;

/// The value of a question; null if it is not asked.
template <class T> const T* answer(const AskedByName& asked, const char* name) {
    const auto found = asked.find(name);
    return found == asked.end() ? nullptr : &std::get<T>(found->second);
}

formula::Exact exact_named(const std::string& name, const std::string& text) {
    try {
        return formula::Exact::parse(text);
    } catch (const InputError& error) {
        throw InputError(name + " = \"" + text + "\": " + error.problem(), error.instead());
    }
}

formula::Exact positive(const std::string& name, const std::string& text, const char* problem,
                        const char* instead) {
    formula::Exact x = exact_named(name, text);
    if (x.sign() <= 0) {
        throw InputError(name + " = " + text + problem, instead);
    }
    return x;
}

scene::Place place_at(const std::string& text, const scene::Place::Names& names) {
    try {
        return scene::Place::parse(text, scene::Place::From::origin, names);
    } catch (const InputError& error) {
        throw InputError("x = \"" + text + "\": " + error.problem(), error.instead());
    }
}

std::vector<scene::BodyPoint> points_of(const Texts& x, const Texts& z, const std::string& name) {
    const scene::Body body = body_named(name);
    std::vector<scene::BodyPoint> points;
    for (std::size_t i = 0; i < x.size(); ++i) {
        formula::Exact depth = exact_named("z", z.at(i));
        if (depth.sign() < 0) {
            throw InputError("the depth z = " + z[i] + " is negative",
                             "give z >= 0, the depth into the body");
        }
        points.push_back({exact_named("x", x[i]), std::move(depth), body});
    }
    return points;
}

contact::ExtentRange part_named(const Texts& part) {
    if (part.size() != 2) {
        throw InputError("part has " + std::to_string(part.size()) + " numbers",
                         "give two, fractions of a + b from the edge: (0, \"1/2\")");
    }
    const formula::Exact from = exact_named("part", part[0]);
    const formula::Exact to = exact_named("part", part[1]);
    const auto minus = [](const formula::Exact& x, const formula::Exact& y) {
        return formula::Exact(x.expr() - y.expr()).sign();
    };
    if (from.sign() < 0 || minus(to, from) <= 0 || minus(formula::Exact::of(Rational(1)), to) < 0) {
        throw InputError("the part of the contact does not ascend within 0 ... 1",
                         "give (0, \"1/2\"), fractions of a + b from the edge");
    }
    return {from, to};
}

} // namespace

std::size_t number_of_terms(long n) {
    if (n < 1 || n > most_terms) {
        throw InputError("terms = " + std::to_string(n) + " is out of range",
                         "give a number from 1 to " + std::to_string(most_terms));
    }
    return static_cast<std::size_t>(n);
}

contact::Edge edge_named(const std::string& name) {
    if (const auto edge = scene::edge_named(name)) {
        return *edge;
    }
    throw InputError("there is no edge '" + name + "'", "write \"right\" or \"left\"");
}

scene::Body body_named(const std::string& name) {
    if (name != "A" && name != "B") {
        throw InputError("there is no body '" + name + "'",
                         "write \"A\" (on which Q acts) or \"B\"");
    }
    return name == "A" ? scene::Body::A : scene::Body::B;
}

NativeScene::NativeScene(std::string text, scene::Scene scene)
    : text_(std::move(text)), scene_(std::move(scene)), pool_(std::make_shared<Pool>()) {
    scene_.ask.digits = digits_asked(scene_.ask.digits.count);
}

scene::Scene NativeScene::asking(const AskedByName& asked) const {
    scene::Scene scene = scene_;
    scene::Ask& ask = scene.ask;
    if (const auto* names = answer<Texts>(asked, "edges")) {
        ask.edges.clear();
        std::ranges::transform(*names, std::back_inserter(ask.edges), edge_named);
    }
    if (const auto* places = answer<Texts>(asked, "u")) {
        ask.u.clear();
        for (const std::string& text : *places) {
            ask.u.push_back({positive("u", text, " is not inside the contact",
                                      "give distances from the edge, 0 < u < a + b"),
                             0});
        }
    }
    if (const auto* places = answer<Texts>(asked, "x")) {
        ask.u.clear();
        const scene::Place::Names names = names_of(scene);
        for (const std::string& text : *places) {
            ask.u.push_back({formula::Exact(), 0, place_at(text, names)});
        }
    }
    if (const auto* x = answer<Texts>(asked, "points_x")) {
        ask.in_bodies =
            points_of(*x, *answer<Texts>(asked, "points_z"), *answer<std::string>(asked, "body"));
    }
    if (const auto* text = answer<std::string>(asked, "reference")) {
        ask.reference = place_at(*text, names_of(scene)).distance(contact::Edge::right);
        ask.surface_of = body_named(*answer<std::string>(asked, "body"));
    }
    if (const auto* terms = answer<std::vector<long>>(asked, "terms")) {
        ask.terms.clear();
        std::ranges::transform(*terms, std::back_inserter(ask.terms), number_of_terms);
    }
    if (const auto* names = answer<Texts>(asked, "quantities")) {
        ask.quantities.clear();
        for (const scene::GroupRow& row : scene::group_rows()) {
            if (std::ranges::find(*names, row.name) != names->end()) {
                ask.quantities.insert(row.group);
            }
        }
    }
    if (const auto* text = answer<std::string>(asked, "tolerance")) {
        ask.tolerance = text->empty() ? std::nullopt : std::optional(scene::parse_tolerance(*text));
    }
    if (const auto* text = answer<std::string>(asked, "process_zone")) {
        ask.process_zone.reset();
        if (!text->empty()) {
            ask.process_zone = positive("process_zone", *text, " is not positive",
                                        "give the length of the process zone, or leave it out");
        }
    }
    if (const auto* part = answer<Texts>(asked, "part")) {
        ask.part = part_named(*part);
    }
    if (const auto* digits = answer<long>(asked, "digits")) {
        ask.digits = digits_asked(checked_digits(*digits));
    }
    return scene;
}

void NativeScene::pressures(contact::Edge edge, std::span<const double> u, std::span<double> p) {
    std::unique_ptr<scene::Binary64Values> contact;
    {
        const std::lock_guard lock(pool_->mutex);
        if (!pool_->free.empty()) {
            contact = std::move(pool_->free.back());
            pool_->free.pop_back();
        }
    }
    if (!contact) {
        contact = std::make_unique<scene::Binary64Values>(scene_);
    }
    (*contact)(edge, u, p);
    const std::lock_guard lock(pool_->mutex);
    pool_->free.push_back(std::move(contact));
}

} // namespace edgeproof::python
