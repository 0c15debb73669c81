// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ledger/evidence.hpp"

namespace edgeproof::audit {

Evidence& Evidence::add(std::string_view key, EvidenceItem value) {
    for (Entry& entry : entries_) {
        if (entry.first == key) {
            entry.second = std::move(value);
            return *this;
        }
    }
    entries_.emplace_back(std::string(key), std::move(value));
    return *this;
}

const EvidenceItem* Evidence::find(std::string_view key) const {
    for (const Entry& entry : entries_) {
        if (entry.first == key) {
            return &entry.second;
        }
    }
    return nullptr;
}

namespace {

struct OneLine {
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(long count) const { return std::to_string(count); }
    std::string operator()(bool yes) const { return yes ? "yes" : "no"; }
    std::string operator()(const std::vector<EvidenceItem>& list) const {
        std::string text;
        for (const EvidenceItem& item : list) {
            text += (text.empty() ? "" : ", ") + item.text();
        }
        return text;
    }
    std::string operator()(const Evidence& nested) const {
        std::string text;
        for (const auto& [key, item] : nested.entries()) {
            text += (text.empty() ? "" : ", ") + key + " " + item.text();
        }
        return text;
    }
};

} // namespace

std::string EvidenceItem::text() const { return std::visit(OneLine{}, value_); }

} // namespace edgeproof::audit
