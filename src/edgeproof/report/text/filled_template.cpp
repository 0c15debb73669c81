// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/text/filled_template.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/text/escape.hpp"

#include <vector>

namespace edgeproof::report {
namespace {

using Json = nlohmann::ordered_json;
using Scope = std::vector<const Json*>; ///< the innermost object last

const Json* value_in(const Scope& scope, const std::string& name) {
    if (name == ".") {
        return scope.back();
    }
    for (auto object = scope.rbegin(); object != scope.rend(); ++object) {
        if ((*object)->is_object() && (*object)->contains(name)) {
            return &(*object)->at(name);
        }
    }
    return nullptr;
}

bool is_shown(const Json* value) {
    return value != nullptr && !value->empty() && *value != Json(false) && *value != Json("");
}

std::string text_of(const Json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
}

/// Returns the text before a mark, and removes both.
std::string_view taken(std::string_view& text, const std::string& mark) {
    const std::size_t at = text.find(mark);
    if (at == std::string_view::npos) {
        throw Error("a template of the report has no " + mark);
    }
    const std::string_view before = text.substr(0, at);
    text.remove_prefix(at + mark.size());
    return before;
}

std::string in_scope(std::string_view text, Scope& scope) {
    std::string out;
    while (text.find("{{") != std::string_view::npos) {
        out += taken(text, "{{");
        std::string name(taken(text, "}}"));
        const char kind = name.front();
        name.erase(0, kind == '#' || kind == '^' || kind == '&' ? 1 : 0);
        const Json* const value = value_in(scope, name);
        if (kind == '#' || kind == '^') {
            const std::string_view part = taken(text, "{{/" + name + "}}");
            if (is_shown(value) != (kind == '#')) {
                continue;
            }
            const bool repeated = kind == '#' && value->is_array();
            for (std::size_t i = 0; i < (repeated ? value->size() : 1); ++i) {
                scope.push_back(repeated ? &(*value)[i] : kind == '#' ? value : scope.back());
                out += in_scope(part, scope);
                scope.pop_back();
            }
        } else if (value == nullptr) {
            throw Error("a template of the report asks for '" + name + "', which nothing supplies");
        } else {
            out += kind == '&' ? text_of(*value) : escape_html(text_of(*value));
        }
    }
    return out.append(text);
}

} // namespace

std::string filled(std::string_view text, const Json& values) {
    Scope scope{&values};
    return in_scope(text, scope);
}

} // namespace edgeproof::report
