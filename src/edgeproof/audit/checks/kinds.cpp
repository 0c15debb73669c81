// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"

namespace edgeproof::audit {

const std::vector<CheckKind>& check_kinds() {
    static const std::vector<CheckKind> kinds{
        definition_kind(),   value_kind(),          identity_kind(),   expansion_kind(),
        size_extent_kind(),  size_condition_kind(), vanishing_kind(),  superposition_kind(),
        independence_kind(), dependence_kind(),     uniformity_kind(), split_kind(),
        relation_kind(),     order_kind(),          series_kind(),     figure_kind(),
        extent_kind(),       monotone_kind(),       limit_kind(),      optimum_kind(),
    };
    return kinds;
}

const CheckKind* find_check_kind(std::string_view name) {
    for (const CheckKind& kind : check_kinds()) {
        if (kind.name == name) {
            return &kind;
        }
    }
    return nullptr;
}

const std::vector<KeySpec>& common_keys() {
    using Type = KeySpec::Type;
    static const std::vector<KeySpec> keys{
        {.name = "over"},
        {.name = "edge", .type = Type::choice, .choices = {"right", "left"}},
        {.name = "where", .type = Type::condition},
        {.name = "quoted"},
        {.name = "with", .type = Type::table},
        {.name = "vary", .type = Type::table},
        {.name = "points", .type = Type::integer},
        {.name = "remark"},
        {.name = "decimals", .type = Type::choice, .choices = {"rounded", "exact"}},
    };
    return keys;
}

} // namespace edgeproof::audit
