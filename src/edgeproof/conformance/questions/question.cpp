// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/exact_rational.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

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

namespace {

struct Key {
    std::string_view name;
    std::string_view section;
};

constexpr Key all_keys[] = {
    {"kind", "profile"},
    {"m", "profile"},
    {"C", "profile"},
    {"phi", "profile"},
    {"alpha", "profile"},
    {"t", "profile"},
    {"flat_width", "profile"},
    {"R", "profile"},
    {"R1", "profile"},
    {"R2", "profile"},
    {"knots", "profile"},
    {"slopes", "profile"},
    {"symmetric", "profile"},
    {"a", "load"},
    {"width", "load"},
    {"P", "load"},
    {"M", "load"},
    {"contact_modulus", "load"},
    {"E1", "load"},
    {"nu1", "load"},
    {"E2", "load"},
    {"nu2", "load"},
    {"Q", "shear"},
    {"bulk_tension", "shear"},
    {"path", "shear"},
    {"friction", "shear"},
};

std::size_t place_of(std::string_view key) {
    const auto& keys = parameter_keys();
    return static_cast<std::size_t>(std::find(keys.begin(), keys.end(), key) - keys.begin());
}

/// The entry as in a scene file.
io::TomlEntry entry_of(const Parameter& p, const std::string& file, std::size_t line) {
    for (const char c : p.text) {
        if (static_cast<unsigned char>(c) < 0x20) {
            throw InputError(p.key + " holds a control character",
                             "write a number or an expression")
                .at(file, p.line);
        }
    }
    if (p.key == "symmetric") {
        if (p.text != "true" && p.text != "false") {
            throw InputError("symmetric = " + p.text + " is neither true nor false",
                             "write true or false")
                .at(file, p.line);
        }
        return {p.key, p.text == "true", line};
    }
    if (is_list_key(p.key)) {
        return {p.key, list_items(p.text), line};
    }
    return {p.key, p.text, line};
}

} // namespace

const std::vector<std::string_view>& parameter_keys() {
    static const std::vector<std::string_view> keys = [] {
        std::vector<std::string_view> list;
        for (const Key& key : all_keys) {
            list.push_back(key.name);
        }
        return list;
    }();
    return keys;
}

std::string_view section_of(std::string_view key) { return all_keys[place_of(key)].section; }
bool is_list_key(std::string_view key) { return key == "knots" || key == "slopes"; }
bool is_word_key(std::string_view key) {
    return key == "kind" || key == "slopes" || key == "symmetric" || key == "path";
}

std::vector<std::string> list_items(std::string_view text) {
    std::vector<std::string> items;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(';'), text.size());
        std::string_view item = text.substr(0, end);
        const std::size_t from = item.find_first_not_of(' ');
        item = from == std::string_view::npos
                   ? std::string_view{}
                   : item.substr(from, item.find_last_not_of(' ') - from + 1);
        items.emplace_back(item);
        text = end == text.size() ? std::string_view{} : text.substr(end + 1);
    }
    return items;
}

AskedContact make_asked_contact(std::vector<Parameter> parameters, const std::string& file,
                                std::size_t line) {
    std::stable_sort(parameters.begin(), parameters.end(), [](const auto& x, const auto& y) {
        return place_of(x.key) < place_of(y.key);
    });
    // Each key has a line of its own, in the order of columns, so that the first of several wrong
    // keys is reported; `lines` has the file's line for each.
    std::vector<io::TomlTable> tables;
    std::vector<std::size_t> lines;
    for (const std::string_view section : {"profile", "load", "shear"}) {
        for (const Parameter& p : parameters) {
            if (section_of(p.key) != section) {
                continue;
            }
            if (tables.empty() || tables.back().name != section) {
                lines.push_back(line);
                tables.push_back({std::string(section), lines.size(), {}});
            }
            lines.push_back(p.line != 0 ? p.line : line);
            tables.back().entries.push_back(entry_of(p, file, lines.size()));
        }
    }
    const auto mapped = [&](std::size_t at) {
        return at >= 1 && at <= lines.size() ? lines[at - 1] : line;
    };
    try {
        AskedContact contact{std::move(parameters),
                             scene::read_contact(io::TomlSection::made(tables, file))};
        contact.scene.profile_line = mapped(contact.scene.profile_line);
        contact.scene.load_line = mapped(contact.scene.load_line);
        contact.scene.friction_line = mapped(contact.scene.friction_line);
        contact.scene.tension_line = mapped(contact.scene.tension_line);
        contact.scene.ask_line = line;
        return contact;
    } catch (const InputError& error) {
        throw InputError(error.problem(), error.instead()).at(file, mapped(error.line()));
    }
}

formula::Exact rounded_to_binary64(const formula::Exact& x) {
    return formula::Exact::parse(exact_text(exact_rational(x.to<double>())));
}

std::vector<Parameter> rounded_to_binary64(std::vector<Parameter> parameters) {
    for (Parameter& p : parameters) {
        if (is_word_key(p.key)) {
            continue;
        }
        std::string text;
        for (const std::string& item :
             is_list_key(p.key) ? list_items(p.text) : std::vector<std::string>{p.text}) {
            text += (text.empty() ? "" : "; ") +
                    rounded_to_binary64(formula::Exact::parse(item)).text();
        }
        p.text = text;
    }
    return parameters;
}

void AskedList::add(const std::vector<Question>& questions) {
    if (!questions.empty()) {
        parts_.push_back({size_, questions});
        size_ += questions.size();
    }
}

void AskedList::add_at_points(const std::string& before_point,
                              const std::vector<Question>& at_each) {
    if (points_.size() > 0 && !at_each.empty()) {
        parts_.push_back({size_, at_each, true, before_point});
        size_ += points_.size() * at_each.size();
    }
}

const AskedList::Part& AskedList::part_of(std::size_t i) const {
    return *std::prev(std::upper_bound(parts_.begin(), parts_.end(), i,
                                       [](std::size_t n, const Part& p) { return n < p.first; }));
}

const Question& AskedList::pattern(std::size_t i) const {
    const Part& part = part_of(i);
    return part.each[(i - part.first) % part.each.size()];
}

Question AskedList::at(std::size_t i) const {
    const Part& part = part_of(i);
    Question q = part.each[(i - part.first) % part.each.size()];
    if (part.at_points) {
        scene::AskedPoint point = points_.at((i - part.first) / part.each.size());
        q.id = part.before_point + point.u.text() + q.id;
        q.u = std::move(point.u);
        q.line = point.line;
    }
    return q;
}

std::vector<Question> AskedList::telling() const {
    std::vector<Question> questions;
    for (const Part& part : parts_) {
        const bool first_only = part.at_points && points_.range;
        const std::size_t n =
            part.each.size() * (part.at_points && !first_only ? points_.size() : 1);
        for (std::size_t k = 0; k < n; ++k) {
            questions.push_back(at(part.first + k));
        }
    }
    return questions;
}

} // namespace edgeproof::conformance
