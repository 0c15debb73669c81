// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/python/native_scene.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/python/value.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::python {
namespace {

constexpr long most_terms = 400;

formula::Exact exact_named(const std::string& name, const std::string& text) {
    try {
        return formula::Exact::parse(text);
    } catch (const InputError& error) {
        throw InputError(name + " = \"" + text + "\": " + error.problem(), error.instead());
    }
}

void ask_places(const std::vector<std::string>& places, scene::Ask& ask) {
    ask.u.clear();
    for (const std::string& text : places) {
        formula::Exact u = exact_named("u", text);
        if (u.sign() <= 0) {
            throw InputError("u = " + text + " is not inside the contact",
                             "give distances from the edge, 0 < u < a + b");
        }
        ask.u.push_back({std::move(u), 0});
    }
}

void ask_terms(const std::vector<long>& terms, scene::Ask& ask) {
    ask.terms.clear();
    for (const long n : terms) {
        if (n < 1 || n > most_terms) {
            throw InputError("terms = " + std::to_string(n) + " is out of range",
                             "give a number from 1 to " + std::to_string(most_terms));
        }
        ask.terms.push_back(static_cast<std::size_t>(n));
    }
}

void ask_quantities(const std::vector<std::string>& names, scene::Ask& ask) {
    ask.quantities.clear();
    for (const std::string& name : names) {
        const auto rows = scene::group_rows();
        const auto row = std::find_if(rows.begin(), rows.end(),
                                      [&](const scene::GroupRow& r) { return r.name == name; });
        if (row == rows.end()) {
            throw InputError("unknown quantity '" + name + "'", "");
        }
        ask.quantities.insert(row->group);
    }
}

void ask_part(const std::vector<std::string>& part, scene::Ask& ask) {
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
    ask.part = {from, to};
}

} // namespace

contact::Edge edge_named(const std::string& name) {
    for (const contact::Edge edge : {contact::Edge::right, contact::Edge::left}) {
        if (name == scene::edge_name(edge)) {
            return edge;
        }
    }
    throw InputError("there is no edge '" + name + "'", "write \"right\" or \"left\"");
}

NativeScene::NativeScene(std::string text, scene::Scene scene)
    : text_(std::move(text)), scene_(std::move(scene)), pool_(std::make_shared<Pool>()) {
    scene_.ask.digits = digits_asked(scene_.ask.digits.count);
}

scene::Scene NativeScene::asking(const AskedByName& asked) const {
    scene::Scene scene = scene_;
    scene::Ask& ask = scene.ask;
    if (asked.edges) {
        ask.edges.clear();
        for (const std::string& name : *asked.edges) {
            ask.edges.push_back(edge_named(name));
        }
    }
    if (asked.u) {
        ask_places(*asked.u, ask);
    }
    if (asked.terms) {
        ask_terms(*asked.terms, ask);
    }
    if (asked.quantities) {
        ask_quantities(*asked.quantities, ask);
    }
    if (asked.tolerance) {
        ask.tolerance.reset();
        if (!asked.tolerance->empty()) {
            ask.tolerance = scene::parse_tolerance(*asked.tolerance);
        }
    }
    if (asked.process_zone) {
        ask.process_zone.reset();
        if (!asked.process_zone->empty()) {
            ask.process_zone = exact_named("process_zone", *asked.process_zone);
            if (ask.process_zone->sign() <= 0) {
                throw InputError("process_zone = " + *asked.process_zone + " is not positive",
                                 "give the length of the process zone, or leave it out");
            }
        }
    }
    if (asked.part) {
        ask_part(*asked.part, ask);
    }
    if (asked.digits) {
        ask.digits = digits_asked(checked_digits(*asked.digits));
    }
    return scene;
}

void NativeScene::pressures(contact::Edge edge, std::span<const double> u, std::span<double> p) {
    std::unique_ptr<scene::Binary64Pressures> contact;
    {
        const std::lock_guard lock(pool_->mutex);
        if (!pool_->free.empty()) {
            contact = std::move(pool_->free.back());
            pool_->free.pop_back();
        }
    }
    if (!contact) {
        contact = std::make_unique<scene::Binary64Pressures>(scene_);
    }
    (*contact)(edge, u, p);
    const std::lock_guard lock(pool_->mutex);
    pool_->free.push_back(std::move(contact));
}

} // namespace edgeproof::python
