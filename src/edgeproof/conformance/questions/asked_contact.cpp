// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/questions/asked_contact.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace edgeproof::conformance {
namespace {

struct Key {
    std::string_view name;
    std::string_view section;
};

constexpr Key all_keys[] = {
    {"kind", "profile"},   {"m", "profile"},
    {"C", "profile"},      {"phi", "profile"},
    {"alpha", "profile"},  {"t", "profile"},
    {"R", "profile"},      {"knots", "profile"},
    {"slopes", "profile"}, {"symmetric", "profile"},
    {"a", "load"},         {"P", "load"},
    {"M", "load"},         {"contact_modulus", "load"},
    {"E1", "load"},        {"nu1", "load"},
    {"E2", "load"},        {"nu2", "load"},
    {"Q", "shear"},        {"bulk_tension", "shear"},
    {"path", "shear"},
};

std::size_t place_of(std::string_view key) {
    const auto& keys = parameter_keys();
    return static_cast<std::size_t>(std::find(keys.begin(), keys.end(), key) - keys.begin());
}

std::string quoted(const Parameter& p, std::string_view text, const std::string& file) {
    std::string out = "\"";
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < 0x20) {
            throw InputError(p.key + " holds a control character",
                             "write a number or an expression")
                .at(file, p.line);
        }
        out += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
    }
    return out + "\"";
}

std::string toml_value(const Parameter& p, const std::string& file) {
    if (p.key == "symmetric") {
        if (p.text != "true" && p.text != "false") {
            throw InputError("symmetric = " + p.text + " is neither true nor false",
                             "write true or false")
                .at(file, p.line);
        }
        return p.text;
    }
    if (!is_list_key(p.key)) {
        return quoted(p, p.text, file);
    }
    std::string list;
    for (const std::string& item : list_items(p.text)) {
        list += (list.empty() ? "[" : ", ") + quoted(p, item, file);
    }
    return list.empty() ? "[]" : list + "]";
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
    std::string text;
    std::vector<std::size_t> lines; // of `file`, for each line of `text`
    for (const std::string_view section : {"profile", "load", "shear"}) {
        const bool any = std::any_of(parameters.begin(), parameters.end(),
                                     [&](const auto& p) { return section_of(p.key) == section; });
        if (!any) {
            continue;
        }
        text += "[" + std::string(section) + "]\n";
        lines.push_back(line);
        for (const Parameter& p : parameters) {
            if (section_of(p.key) == section) {
                text += p.key + " = " + toml_value(p, file) + "\n";
                lines.push_back(p.line != 0 ? p.line : line);
            }
        }
    }
    try {
        AskedContact contact{std::move(parameters), scene::parse_scene(text, file)};
        contact.scene.ask = {};
        const auto mapped = [&](std::size_t at) {
            return at >= 1 && at <= lines.size() ? lines[at - 1] : line;
        };
        contact.scene.profile_line = mapped(contact.scene.profile_line);
        contact.scene.load_line = mapped(contact.scene.load_line);
        contact.scene.ask_line = line;
        return contact;
    } catch (const InputError& error) {
        const std::size_t at = error.line();
        throw InputError(error.problem(), error.instead())
            .at(file, at >= 1 && at <= lines.size() ? lines[at - 1] : line);
    }
}

formula::Exact rounded_to_binary64(const formula::Exact& x) {
    return formula::Exact::parse(exact_text(Rational(x.to<double>())));
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

} // namespace edgeproof::conformance
