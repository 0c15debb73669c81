// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ledger/scene_names.hpp"

namespace edgeproof::audit {

const std::vector<std::string>& scene_symbols() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all{"a", "b", "Es", "P", "M", "L", "u", "x"};
        for (int k = 1; k <= 9; ++k) {
            all.push_back("P" + std::to_string(k));
            all.push_back("b" + std::to_string(k));
        }
        for (int k = 0; k <= 9; ++k) {
            all.push_back("right_c" + std::to_string(k));
            all.push_back("left_c" + std::to_string(k));
            all.push_back("right_s" + std::to_string(k));
            all.push_back("left_s" + std::to_string(k));
        }
        return all;
    }();
    return names;
}

const std::vector<std::string>& slip_symbols() {
    static const std::vector<std::string> names{"right_d", "left_d", "stick_a", "stick_b"};
    return names;
}

bool is_full_stick_symbol(std::string_view name) {
    return (name.starts_with("right_s") && name.size() == 8) ||
           (name.starts_with("left_s") && name.size() == 7);
}

const std::vector<std::pair<std::string, unsigned>>& scene_functions() {
    static const std::vector<std::pair<std::string, unsigned>> functions{
        {"p", 1},    {"g1", 1},          {"Pof", 1},        {"P1of", 1}, {"bof", 1},
        {"binv", 1}, {"right_local", 2}, {"left_local", 2}, {"q", 1}};
    return functions;
}

} // namespace edgeproof::audit
