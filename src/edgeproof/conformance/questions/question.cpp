// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/questions/question.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <set>

namespace edgeproof::conformance {
std::string parameter_text(const AskedContact& contact, std::string_view key) {
    for (const Parameter& p : contact.parameters) {
        if (p.key == key) {
            return p.text;
        }
    }
    return {};
}

std::vector<std::string> Questions::columns() const {
    std::set<std::string, std::less<>> used;
    for (const AskedContact& contact : contacts) {
        for (const Parameter& p : contact.parameters) {
            used.insert(p.key);
        }
    }
    std::vector<std::string> keys;
    for (const std::string_view key : parameter_keys()) {
        if (used.contains(key)) {
            keys.emplace_back(key);
        }
    }
    return keys;
}

bool Questions::has_tolerances() const {
    return std::any_of(list.begin(), list.end(), [](const Question& q) { return q.tolerance; });
}

std::set<scene::Quantity> Questions::quantities() const {
    std::set<scene::Quantity> asked;
    for (const Question& q : list) {
        asked.insert(q.quantity);
    }
    return asked;
}

Questions rounded_to_binary64(const Questions& questions) {
    Questions rounded;
    rounded.file = questions.file;
    for (const AskedContact& contact : questions.contacts) {
        rounded.contacts.push_back(make_asked_contact(rounded_to_binary64(contact.parameters),
                                                      questions.file, contact.scene.ask_line));
    }
    rounded.list = questions.list;
    for (Question& q : rounded.list) {
        if (q.u) {
            q.u = rounded_to_binary64(*q.u);
        }
        if (q.tolerance) {
            q.tolerance = rounded_to_binary64(*q.tolerance);
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

} // namespace edgeproof::conformance
