// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/input/scene_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace edgeproof::conformance {

std::vector<std::string> Parameter::items() const {
    std::vector<std::string> items;
    if (!is_list()) {
        items.push_back(text);
        return items;
    }
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(';', at), text.size());
        items.emplace_back(io::trimmed(std::string_view(text).substr(at, end - at), " "));
        at = end + 1;
    }
    return items;
}

void Parameter::set_items(const std::vector<std::string>& items) {
    text = fmt::format("{}", fmt::join(items, "; "));
}

bool Parameter::is_word() const {
    const scene::Key* const known = scene::key_named(key);
    return known != nullptr && known->word;
}

std::string parameter_text(const AskedContact& contact, std::string_view key) {
    const auto found = std::ranges::find(contact.parameters, key, &Parameter::key);
    return found == contact.parameters.end() ? std::string() : found->text;
}

std::vector<std::string> Questions::columns() const {
    std::vector<std::string> keys;
    for (const ParameterKey& key : parameter_keys()) {
        if (std::ranges::any_of(contacts, [&](const AskedContact& contact) {
                return std::ranges::find(contact.parameters, key.name, &Parameter::key) !=
                       contact.parameters.end();
            })) {
            keys.emplace_back(key.name);
        }
    }
    return keys;
}

bool Questions::has_tolerances() const {
    return std::ranges::any_of(list, [](const Question& q) { return q.tolerance.has_value(); });
}

bool Questions::has_body_points() const {
    return std::ranges::any_of(list, [](const Question& q) { return q.in_body.has_value(); });
}

std::set<scene::Quantity> Questions::quantities() const {
    std::set<scene::Quantity> asked;
    for (const Question& question : list) {
        asked.insert(question.quantity);
    }
    return asked;
}

Questions rounded_to_binary64(const Questions& questions) {
    Questions rounded = questions;
    for (AskedContact& contact : rounded.contacts) {
        contact = make_asked_contact(rounded_to_binary64(std::move(contact.parameters)),
                                     questions.file, contact.scene.ask_line);
    }
    for (Question& q : rounded.list) {
        if (q.in_body) {
            q.in_body->x = rounded_to_binary64(*q.in_body->x.number());
            q.in_body->z = rounded_to_binary64(*q.in_body->z.number());
        }
        for (std::optional<formula::Exact>* const number : {&q.u, &q.tolerance}) {
            if (*number) {
                *number = rounded_to_binary64(**number);
            }
        }
    }
    return rounded;
}

void check_askable(const AskedContact& contact, const scene::AskedValue& asked,
                   const std::string& file, std::size_t line) {
    if (const auto lack = lack_of(contact.scene, asked)) {
        throw InputError(lack->problem, lack->instead).at(file, line);
    }
}

const std::vector<ParameterKey>& parameter_keys() {
    static const std::vector<ParameterKey> keys = [] {
        std::vector<ParameterKey> list;
        for (const scene::Key& key : scene::keys_of_scene()) {
            if (key.section != "ask" && key.section != "units") {
                list.push_back({key.name, key.section});
            }
        }
        list.insert(list.end(), {{"step_P", "steps"}, {"step_Q", "steps"}});
        return list;
    }();
    return keys;
}

namespace {

std::size_t place_of(const Parameter& p) {
    const auto& keys = parameter_keys();
    return static_cast<std::size_t>(std::ranges::find(keys, p.key, &ParameterKey::name) -
                                    keys.begin());
}

/// The entry as in a scene file.
io::TomlEntry entry_of(const Parameter& p, const std::string& file, std::size_t line) {
    if (p.key == "symmetric") {
        if (p.text != "true" && p.text != "false") {
            throw InputError("symmetric = " + p.text + " is neither true nor false",
                             "write true or false")
                .at(file, p.line);
        }
        return {p.key, p.text == "true", line};
    }
    if (p.is_list()) {
        return {p.key, p.items(), line};
    }
    return {p.key, p.text, line};
}

/// The steps of a scene from the lists of their P and Q.
std::vector<io::TomlTable> steps_of(const std::vector<Parameter>& parameters,
                                    const std::string& file, std::size_t line) {
    std::vector<io::TomlTable> steps;
    for (const Parameter& p : parameters) {
        if (!p.key.starts_with("step_")) {
            continue;
        }
        const std::vector<std::string> items = p.items();
        if (!steps.empty() && items.size() != steps.size()) {
            throw InputError("step_P and step_Q have different numbers of steps",
                             "give P and Q of each step")
                .at(file, p.line != 0 ? p.line : line);
        }
        steps.resize(items.size(), {"[[step]]", line, {}});
        for (std::size_t i = 0; i < items.size(); ++i) {
            steps[i].entries.push_back({p.key.substr(5), items[i], line});
        }
    }
    return steps;
}

} // namespace

AskedContact make_asked_contact(std::vector<Parameter> parameters, const std::string& file,
                                std::size_t line) {
    std::ranges::stable_sort(parameters, {}, place_of);
    std::vector<io::TomlTable> tables;
    for (const Parameter& p : parameters) {
        const std::string_view section = parameter_keys()[place_of(p)].section;
        if (section == "steps") {
            continue;
        }
        if (tables.empty() || tables.back().name != section) {
            tables.push_back({std::string(section), line, {}});
        }
        tables.back().entries.push_back(entry_of(p, file, p.line != 0 ? p.line : line));
    }
    for (io::TomlTable& step : steps_of(parameters, file, line)) {
        tables.push_back(std::move(step));
    }
    AskedContact contact{std::move(parameters),
                         scene::read_contact(io::TomlSection::made(tables, file))};
    contact.scene.ask_line = line;
    return contact;
}

formula::Exact rounded_to_binary64(const formula::Exact& x) {
    return formula::Exact::parse(exact_text(exact_rational(x.to<double>())));
}

std::vector<Parameter> rounded_to_binary64(std::vector<Parameter> parameters) {
    for (Parameter& p : parameters) {
        if (p.is_word()) {
            continue;
        }
        std::vector<std::string> items = p.items();
        for (std::string& item : items) {
            item = rounded_to_binary64(formula::Exact::parse(item)).text();
        }
        p.set_items(items);
    }
    return parameters;
}

} // namespace edgeproof::conformance
