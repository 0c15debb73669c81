// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>

namespace edgeproof {

/// Keeps up to `capacity` values by their keys; a new value replaces the one whose last use is the
/// oldest. Values are shared pointers and so remain valid for those who hold them. Not locked: an
/// object belongs to one thread, or its owner locks it.
template <class Key, class Value> class BoundedCache {
public:
    explicit BoundedCache(std::size_t capacity) : capacity_(capacity) {}

    /// Returns the value of a key. If there is none, make() -> std::shared_ptr<Value> creates it;
    /// make() may call this cache for other keys, and may throw, in which case nothing is stored.
    template <class Make> [[nodiscard]] std::shared_ptr<Value> get(const Key& key, Make make) {
        const auto known = entries_.find(key);
        if (known != entries_.end()) {
            known->second.last_use = ++uses_;
            return known->second.value;
        }
        std::shared_ptr<Value> value = make();
        while (!entries_.empty() && entries_.size() >= capacity_) {
            entries_.erase(std::min_element(entries_.begin(), entries_.end(),
                                            [](const auto& x, const auto& y) {
                                                return x.second.last_use < y.second.last_use;
                                            }));
        }
        entries_.insert_or_assign(key, Entry{value, ++uses_});
        return value;
    }

    [[nodiscard]] std::size_t size() const { return entries_.size(); }

private:
    struct Entry {
        std::shared_ptr<Value> value;
        std::uint64_t last_use;
    };
    std::size_t capacity_;
    std::uint64_t uses_ = 0;
    std::map<Key, Entry> entries_;
};

} // namespace edgeproof
