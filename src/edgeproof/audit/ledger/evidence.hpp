// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace edgeproof::audit {

class EvidenceItem;

/// The reasons for a verdict: keys with values, in the order in which they were added. JSON and the
/// tables keep this order. Computed numbers are stored as text, already rounded.
class Evidence {
public:
    using Entry = std::pair<std::string, EvidenceItem>;

    /// Adds `key`, or replaces its value without changing the order.
    Evidence& add(std::string_view key, EvidenceItem value);
    [[nodiscard]] const std::vector<Entry>& entries() const noexcept { return entries_; }
    [[nodiscard]] bool empty() const noexcept;
    /// Returns nullptr if the key is missing.
    [[nodiscard]] const EvidenceItem* find(std::string_view key) const;

private:
    std::vector<Entry> entries_;
};

/// A text, an integer, a Boolean, a list, or nested evidence.
class EvidenceItem {
public:
    using Value = std::variant<std::string, long, bool, std::vector<EvidenceItem>, Evidence>;

    EvidenceItem(std::string text) : value_(std::move(text)) {} // NOLINT: converts on purpose
    EvidenceItem(std::string_view text) : value_(std::string(text)) {}   // NOLINT
    EvidenceItem(const char* text) : value_(std::string(text)) {}        // NOLINT
    template <std::same_as<bool> B> EvidenceItem(B yes) : value_(yes) {} // NOLINT
    template <std::integral N>
    requires(!std::same_as<N, bool>) EvidenceItem(N count)
        : value_(static_cast<long>(count)) {}                                 // NOLINT
    EvidenceItem(std::vector<EvidenceItem> list) : value_(std::move(list)) {} // NOLINT
    EvidenceItem(Evidence nested) : value_(std::move(nested)) {}              // NOLINT
    EvidenceItem(const std::vector<std::string>& texts)                       // NOLINT
        : value_(std::vector<EvidenceItem>(texts.begin(), texts.end())) {}

    [[nodiscard]] const Value& value() const noexcept { return value_; }
    /// Returns the value on one line, for tables.
    [[nodiscard]] std::string text() const;

private:
    Value value_;
};

inline bool Evidence::empty() const noexcept { return entries_.empty(); }

} // namespace edgeproof::audit
