// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/python/native_scene.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/python/bindings.hpp"
#include "edgeproof/scene/input/readers.hpp"

#include <utility>

namespace edgeproof::python {
namespace {

Texts texts_in(const std::map<std::string, KeyValue>& asked, const char* name) {
    const auto found = asked.find(name);
    return found == asked.end() ? Texts{} : std::get<Texts>(found->second);
}

} // namespace

NativeScene::NativeScene(std::string text, scene::Scene scene)
    : text_(std::move(text)), scene_(std::move(scene)),
      profile_(io::TomlSection::parse(text_, scene_.file).section("profile")),
      pool_(std::make_shared<Pool>()) {
    scene_.ask.digits = digits_asked(scene_.ask.digits.count);
}

scene::Scene NativeScene::asking(std::map<std::string, KeyValue> asked) const {
    const Texts x = texts_in(asked, "points_x");
    const Texts z = texts_in(asked, "points_z");
    const auto body = asked.find("body");
    const scene::Body of = body == asked.end()
                               ? scene::Body::A
                               : scene::body_named(std::get<std::string>(body->second));
    for (const char* const key : {"points_x", "points_z", "body"}) {
        asked.erase(key);
    }
    scene::Scene scene = scene_;
    if (asked.contains("quantities")) {
        scene.ask.quantities.clear();
    }
    for (const auto& [key, value] : {std::pair{"tolerance", &scene.ask.tolerance},
                                     {"process_zone", &scene.ask.process_zone}}) {
        if (asked.contains(key)) {
            value->reset();
        }
    }
    try {
        const auto top = io::TomlSection::made({{"ask", 0, entries_of(asked)}}, scene.file);
        read_ask(top.section("ask"), profile_, scene);
    } catch (const InputError& error) {
        throw InputError(error.problem(), error.instead()); // the questions are in no file
    }
    scene.ask.digits = digits_asked(scene.ask.digits.count);
    scene.ask.surface_of = of;
    if (!x.empty()) {
        const scene::Place::Names names = scene::exact_names_of(scene);
        scene.ask.in_bodies.clear();
        for (std::size_t i = 0; i < x.size(); ++i) {
            scene.ask.in_bodies.push_back(scene::body_point(x[i], z.at(i), of, names));
        }
    }
    return scene;
}

void NativeScene::binary64(const scene::Binary64Question& question, contact::Edge edge,
                           std::span<const double> places, std::span<double> values) const {
    const std::tuple key(question.quantity, question.n, question.from_origin);
    std::unique_ptr<scene::Binary64Values> contact;
    {
        const std::lock_guard lock(pool_->mutex);
        Contacts& free = pool_->free[key];
        if (!free.empty()) {
            contact = std::move(free.back());
            free.pop_back();
        }
    }
    if (!contact) {
        contact = std::make_unique<scene::Binary64Values>(scene_, question);
    }
    (*contact)(edge, places, values);
    const std::lock_guard lock(pool_->mutex);
    pool_->free[key].push_back(std::move(contact));
}

} // namespace edgeproof::python
