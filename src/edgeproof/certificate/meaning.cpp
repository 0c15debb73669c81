// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ledger/ledger_parts.hpp"
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace edgeproof::certificate {
namespace {

// The slope of a flat punch with rounded edges that is tilted by alpha (TiltedRounded.v).
constexpr std::string_view slope_of_tilted_punch =
    "-alpha + max(s + alpha*R, 0)/R + min(s + 2*t + alpha*R, 0)/R";

/// The names of the claim without its definitions, and "gp" with the theorems' definition.
Vocabulary usual_names(const Claim& claim) {
    Vocabulary names{claim.vocabulary.symbols, {}};
    if (names.symbols.has("alpha") && names.symbols.has("t") && names.symbols.has("R")) {
        formula::Symbols with_place = names.symbols;
        with_place.add("s");
        names.symbols.add_function("gp", 1);
        names.definitions = {
            {"gp", "s", audit::parse_formula(slope_of_tilted_punch, {with_place, {}})}};
    }
    return names;
}

bool is_name_of_contact(const std::string& name) {
    return std::ranges::find(audit::scene_symbols(), name) != audit::scene_symbols().end() ||
           std::ranges::any_of(audit::scene_functions(),
                               [&](const auto& function) { return function.first == name; });
}

/// Throws NotStated if a name that the theorems use has another meaning in the claim.
void require_usual_names(const Claim& claim, const std::vector<SceneSpec>& scenes) {
    std::vector<std::string> variables;
    if (claim.has("vary")) {
        for (const auto& [name, values] : claim.table("vary")) {
            variables.push_back(name);
        }
    }
    std::vector<std::string> given = variables;
    given.insert(given.end(), claim.undefined.begin(), claim.undefined.end());
    for (const auto& definition : claim.vocabulary.definitions) {
        given.push_back(definition.name);
        const bool parameter = std::ranges::any_of(scenes, [&](const SceneSpec& scene) {
            return scene.parameters.contains(definition.name);
        });
        if (parameter || std::ranges::find(variables, definition.name) != variables.end()) {
            throw NotStated("the ledger defines " + definition.name + " again");
        }
    }
    const auto redefined = std::ranges::find_if(given, is_name_of_contact);
    if (redefined != given.end()) {
        throw NotStated("the ledger gives " + *redefined + " another meaning");
    }
}

} // namespace

const EvidenceItem& item(const Evidence& evidence, std::string_view key) {
    const EvidenceItem* const found = evidence.find(key);
    if (found == nullptr) {
        throw NotStated("the audit computed no value");
    }
    return *found;
}

void require_usual_meaning(const Claim& claim, const Ledger& ledger) {
    if (!claim.has("over")) {
        return;
    }
    const auto scenes = draw_scenes(ledger.family(claim.text("over")), ledger.families);
    for (const SceneSpec& scene : scenes) {
        if (scene.axisymmetric) {
            throw NotStated("axisymmetric contacts are not stated");
        }
        if (scene.flat_punch()) {
            throw NotStated("flat punches are not stated");
        }
        if (scene.slips()) {
            throw NotStated("contacts with friction are not stated");
        }
    }
    if (claim.kind == "expansion" && (claim.has("as_if") || claim.has("given"))) {
        throw NotStated("expansions under an assumption of the claim are not stated");
    }
    require_usual_names(claim, scenes);
    for (const Claim& reading : claim.readings) {
        require_usual_names(reading, scenes);
        // The theorem of an extent states the first reading alone.
        if (claim.kind != "extent" &&
            (reading.text_or("over", "") != claim.text("over") || reading.edge() != claim.edge())) {
            throw NotStated("readings about different contacts or edges are not stated");
        }
    }
}

bool is_formula(const Claim& claim, std::string_view key, std::string_view text) {
    try {
        const Vocabulary names = usual_names(claim);
        return claim.formula(key) == expand_definitions(parse_formula(text, names), names);
    } catch (const InputError&) {
        return false; // the claim does not have all names
    }
}

bool is_condition(const Claim& claim, std::string_view key, std::string_view text) {
    if (!claim.has(key)) {
        return false;
    }
    try {
        const Condition expected = parse_condition(text, usual_names(claim));
        return std::ranges::equal(claim.condition(key), expected,
                                  [](const Relation& x, const Relation& y) {
                                      return x.lhs == y.lhs && x.op == y.op && x.rhs == y.rhs;
                                  });
    } catch (const InputError&) {
        return false;
    }
}

} // namespace edgeproof::certificate
