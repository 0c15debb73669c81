// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/python/native_scene.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/python/bindings.hpp"
#include "edgeproof/scene/input/readers.hpp"

#include <algorithm>
#include <iterator>
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

/// The entries of [ask] for the questions that have a key there.
std::vector<io::TomlEntry> entries_of(const AskedByName& asked) {
    std::vector<io::TomlEntry> entries;
    for (const char* const key : {"edges", "u", "x", "terms", "quantities", "tolerance",
                                  "process_zone", "part", "reference"}) {
        const auto found = asked.find(key);
        if (found == asked.end()) {
            continue;
        }
        if (const auto* numbers = std::get_if<std::vector<long>>(&found->second)) {
            Texts texts;
            std::ranges::transform(*numbers, std::back_inserter(texts),
                                   [](long n) { return std::to_string(n); });
            entries.push_back({key, texts});
        } else if (const auto* texts = std::get_if<Texts>(&found->second)) {
            entries.push_back({key, *texts});
        } else {
            entries.push_back({key, std::get<std::string>(found->second)});
        }
    }
    return entries;
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
    for (const auto& [key, value] : asked) { // the empty text means none
        ask.tolerance = key == "tolerance" ? std::nullopt : ask.tolerance;
        ask.process_zone = key == "process_zone" ? std::nullopt : ask.process_zone;
        if (key == "quantities") {
            ask.quantities.clear();
        }
    }
    if (const auto* name = answer<std::string>(asked, "body")) {
        ask.surface_of = body_named(*name);
    }
    if (const auto* x = answer<Texts>(asked, "points_x")) {
        ask.in_bodies =
            points_of(*x, *answer<Texts>(asked, "points_z"), *answer<std::string>(asked, "body"));
    }
    try {
        const io::TomlSection made =
            io::TomlSection::made({{"profile", 0, {}}, {"ask", 0, entries_of(asked)}}, "");
        read_ask(made.section("ask"), made.section("profile"), scene);
        scene.ask_line = scene_.ask_line;
    } catch (const InputError& error) {
        throw InputError(error.problem(), error.instead()); // without the line 0
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
